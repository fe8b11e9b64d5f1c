#include "io/assembly/present_soil.hpp"

#include "geometry/section/region_locator.hpp"
#include "io/scene/stage_changes.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <utility>

namespace quicksand {

std::vector<bool> absent_regions(const std::vector<ResolvedKey>& keys, const Section& section)
{
    std::vector<std::string> names;
    for (const Region& region : section.regions) names.push_back(region.name);
    return absent_soils(keys, names);
}

void leave_out_probes(const Section& section, const std::vector<bool>& absent, Scene& scene)
{
    if (std::find(absent.begin(), absent.end(), true) == absent.end()) return;
    const RegionLocator locator(section);
    std::erase_if(scene.probes, [&](const SceneProbe& probe) {
        if (probe.kind != ProbeKind::material || !probe.at) return false;
        const auto region = locator.locate(*probe.at);
        return region && absent[*region];
    });
}

std::vector<std::int32_t> keep_present(const std::vector<bool>& absent, const BackgroundGrid& grid,
                                       Sampling& sampling)
{
    std::vector<std::int32_t> numbers(sampling.domains.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    if (std::find(absent.begin(), absent.end(), true) == absent.end()) return numbers;
    std::erase_if(numbers, [&](std::int32_t number) {
        return absent[sampling.domains[static_cast<std::size_t>(number)].region];
    });
    std::vector<ParticleDomain> left;
    std::set<std::pair<int, int>> cells;
    for (const std::int32_t number : numbers) {
        const ParticleDomain& domain = left.emplace_back(sampling.domains[static_cast<std::size_t>(number)]);
        const Vector2 cell = grid.cells_from_rim(domain.centre);
        cells.emplace(static_cast<int>(cell.x()), static_cast<int>(cell.y()));
    }
    sampling.domains = std::move(left);
    for (std::size_t r = 0; r < absent.size(); ++r)
        if (absent[r]) sampling.regions[r].particles = sampling.regions[r].cut = 0;
    sampling.occupied_cells = cells.size();
    sampling.particles_per_cell =
        static_cast<double>(numbers.size()) / static_cast<double>(std::max<std::size_t>(cells.size(), 1));
    return numbers;
}

} // namespace quicksand
