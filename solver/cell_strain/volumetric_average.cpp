#include "solver/cell_strain/volumetric_average.hpp"

#include <algorithm>

namespace quicksand {

namespace {

void average_tile(const VolumetricAverage& asked_for, const CellLists& lists, const Tile& tile,
                  Particles& particles)
{
    Gradients& L = particles.velocity_gradient_solid;
    const auto asks = [&](std::size_t p) {
        return asked_for[static_cast<std::size_t>(particles.material[p])] != 0;
    };
    for (std::int32_t c = tile.first_cell; c < tile.last_cell; ++c) {
        const auto slot = static_cast<std::size_t>(c);
        const auto first = static_cast<std::size_t>(lists.cell_start[slot]);
        const auto last = static_cast<std::size_t>(lists.cell_start[slot + 1]);
        double volume = 0.0, growth = 0.0; // [m3/m], [m3/s per metre]
        for (std::size_t k = first; k < last; ++k) {
            const auto p = static_cast<std::size_t>(lists.order[k]);
            if (!asks(p)) continue;
            volume += particles.volume[p];
            growth += particles.volume[p] * (L.xx[p] + L.yy[p]);
        }
        for (std::size_t k = first; k < last; ++k) {
            const auto p = static_cast<std::size_t>(lists.order[k]);
            if (!asks(p)) continue;
            const double half = 0.5 * (growth / volume - (L.xx[p] + L.yy[p]));
            L.xx[p] += half;
            L.yy[p] += half;
        }
    }
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

} // namespace

VolumetricAverage make_volumetric_average(const Problem& problem)
{
    VolumetricAverage asked_for;
    for (const Material& material : problem.materials)
        asked_for.push_back(
            material.volumetric_strain == VolumetricStrain::cell && !dilates(material.law) ? 1 : 0);
    if (std::find(asked_for.begin(), asked_for.end(), 1) == asked_for.end()) asked_for.clear();
    return asked_for;
}

void average_volume_change(const CellLists& lists, const VolumetricAverage& asked_for, Particles& particles)
{
    if (asked_for.empty()) return;
    for_each_tile(lists, [&](const Tile& tile) { average_tile(asked_for, lists, tile, particles); });
}

} // namespace quicksand
