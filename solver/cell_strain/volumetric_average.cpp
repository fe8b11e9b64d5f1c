#include "solver/cell_strain/volumetric_average.hpp"

#include <algorithm>

namespace quicksand {

namespace {

/// Give the sum of `xx` and `yy` its mean over the cell, the difference staying as it is.
void average_traces(const std::vector<std::uint8_t>& asked_for, const CellLists& lists, const Tile& tile,
                    const Particles& particles, Scalars& xx, Scalars& yy)
{
    const auto asks = [&](std::size_t p) {
        return asked_for[static_cast<std::size_t>(particles.material[p])] != 0;
    };
    for (std::int32_t c = tile.first_cell; c < tile.last_cell; ++c) {
        const auto slot = static_cast<std::size_t>(c);
        const auto first = static_cast<std::size_t>(lists.cell_start[slot]);
        const auto last = static_cast<std::size_t>(lists.cell_start[slot + 1]);
        double volume = 0.0, sum = 0.0;
        for (std::size_t k = first; k < last; ++k) {
            const auto p = static_cast<std::size_t>(lists.order[k]);
            if (!asks(p)) continue;
            volume += particles.volume[p];
            sum += particles.volume[p] * (xx[p] + yy[p]);
        }
        for (std::size_t k = first; k < last; ++k) {
            const auto p = static_cast<std::size_t>(lists.order[k]);
            if (!asks(p)) continue;
            const double half = 0.5 * (sum / volume - (xx[p] + yy[p]));
            xx[p] += half;
            yy[p] += half;
        }
    }
}

void average_all(const CellLists& lists, const std::vector<std::uint8_t>& asked_for,
                 const Particles& particles, Scalars& xx, Scalars& yy)
{
    if (asked_for.empty()) return;
    for_each_tile(lists,
                  [&](const Tile& tile) { average_traces(asked_for, lists, tile, particles, xx, yy); });
}

/// Whether the soil grows as it flows.
bool dilates(const SkeletonLaw& any)
{
    return std::visit(
        [](const auto& law) {
            if constexpr (requires { law.dilation_angle; }) {
                return law.dilation_angle > 0.0;
            } else {
                return false;
            }
        },
        any);
}

/// By material whether it is so; empty when none is.
template <class Is>
std::vector<std::uint8_t> flags_of(const Problem& problem, Is&& is)
{
    std::vector<std::uint8_t> flags;
    for (const Material& material : problem.materials) flags.push_back(is(material) ? 1 : 0);
    if (std::find(flags.begin(), flags.end(), 1) == flags.end()) flags.clear();
    return flags;
}

} // namespace

VolumetricAverage make_volumetric_average(const Problem& problem)
{
    const auto averages = [](const Material& material) {
        return material.volumetric_strain == VolumetricStrain::cell;
    };
    return {flags_of(problem, averages), flags_of(problem, [&](const Material& material) {
                return averages(material) && dilates(material.law);
            })};
}

void average_volume_change(const CellLists& lists, const VolumetricAverage& average, Particles& particles)
{
    Gradients& L = particles.velocity_gradient_solid;
    average_all(lists, average.of_strain, particles, L.xx, L.yy);
}

void average_mean_stress(const CellLists& lists, const VolumetricAverage& average, Particles& particles)
{
    average_all(lists, average.of_stress, particles, particles.stress.xx, particles.stress.yy);
}

} // namespace quicksand
