#include "solver/cell_strain/volumetric_average.hpp"

#include "solver/cell_strain/cell_walk.hpp"
#include "solver/cell_strain/soil_faces.hpp"

#include <algorithm>

namespace quicksand {

namespace {

/// Particles of a cell, by the flag of their material.
class Flagged {
public:
    Flagged(const std::vector<std::uint8_t>& flags, const Particles& particles)
        : flags_(flags), particles_(particles)
    {
    }
    bool operator()(std::int32_t p) const
    {
        const std::int32_t material = particles_.material[static_cast<std::size_t>(p)];
        return flags_[static_cast<std::size_t>(material)] != 0;
    }

private:
    const std::vector<std::uint8_t>& flags_;
    const Particles& particles_;
};

/// Give the sum of `xx` and `yy` its mean over those of the cell that ask for it, the difference staying as
/// it is.
void average_traces(CellEntries cell, const Flagged& asks, const Scalars& volumes, Scalars& xx, Scalars& yy)
{
    double volume = 0.0, sum = 0.0;
    for (const std::int32_t k : cell) {
        if (!asks(k)) continue;
        const auto p = static_cast<std::size_t>(k);
        volume += volumes[p];
        sum += volumes[p] * (xx[p] + yy[p]);
    }
    for (const std::int32_t k : cell) {
        if (!asks(k)) continue;
        const auto p = static_cast<std::size_t>(k);
        const double half = 0.5 * (sum / volume - (xx[p] + yy[p]));
        xx[p] += half;
        yy[p] += half;
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
    if (average.of_strain.empty()) return;
    const Flagged asks(average.of_strain, particles);
    Gradients& L = particles.velocity_gradient_solid;
    for_each_slot(lists, [&](std::size_t slot) {
        average_traces(entries_of(lists, slot), asks, particles.volume, L.xx, L.yy);
    });
}

void average_mean_stress(const CellLists& lists, const VolumetricAverage& average, Particles& particles)
{
    if (average.of_stress.empty()) return;
    const Flagged asks(average.of_strain, particles), dilates(average.of_stress, particles);
    SymmetricTensors& stress = particles.stress;
    for_each_slot(lists, [&](std::size_t slot) {
        const CellEntries cell = entries_of(lists, slot);
        if (std::any_of(cell.begin(), cell.end(), dilates))
            average_traces(cell, asks, particles.volume, stress.xx, stress.yy);
    });
}

} // namespace quicksand
