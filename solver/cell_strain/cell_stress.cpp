#include "solver/cell_strain/cell_stress.hpp"

#include "solver/motion/particle_motion.hpp"

#include <cstdint>
#include <variant>
#include <vector>

namespace quicksand {

namespace {

/// Call even(points) for the particles of a material in each cell of a tile.
template <class Even>
void for_each_cell_of(std::size_t material, const CellLists& lists, const Tile& tile,
                      const Particles& particles, Even&& even)
{
    std::vector<std::int32_t> points;
    for (std::int32_t c = tile.first_cell; c < tile.last_cell; ++c) {
        const auto slot = static_cast<std::size_t>(c);
        points.clear();
        for (std::int32_t k = lists.cell_start[slot]; k < lists.cell_start[slot + 1]; ++k) {
            const std::int32_t p = lists.order[static_cast<std::size_t>(k)];
            if (particles.material[static_cast<std::size_t>(p)] == static_cast<std::int32_t>(material))
                points.push_back(p);
        }
        if (points.size() > 1) even(points);
    }
}

void even_out_cells(const Problem& problem, double dt, const CellLists& lists, Particles& particles)
{
    for (std::size_t m = 0; m < problem.materials.size(); ++m) {
        std::visit(
            [&](const auto& law) {
                if (!settles_by_cells(law)) return;
                for_each_tile(lists, [&](const Tile& tile) {
                    for_each_cell_of(m, lists, tile, particles, [&](const std::vector<std::int32_t>& points) {
                        even_out_cell(law, dt, points, particles);
                    });
                });
            },
            problem.materials[m].law);
    }
}

} // namespace

CellStrain make_cell_strain(const Problem& problem, Stage stage)
{
    return {make_volumetric_average(problem), make_shared_soils(problem, stage), {}, {}, {}};
}

StressOnNodes::StressOnNodes(const Problem& problem, const CellLists& lists, CellStrain& strain,
                             Particles& particles)
    : strain_(strain), particles_(particles)
{
    SymmetricTensors &stress = particles.stress, &own = strain.own_stress;
    const bool shears = !strain.shared.of_material.empty();
    if (shears || !strain.averaged.of_stress.empty()) own.xx = stress.xx, own.yy = stress.yy;
    if (shears) own.xy = stress.xy;
    find_cells_with_means(problem, lists, strain.shared, particles, strain.with_means);
    approach_means(lists, strain.shared, strain.with_means, particles, {&stress.xx, &stress.yy, &stress.xy});
    average_mean_stress(lists, strain.averaged, particles);
}

StressOnNodes::~StressOnNodes()
{
    SymmetricTensors &stress = particles_.stress, &own = strain_.own_stress;
    const bool shears = !strain_.shared.of_material.empty();
    if (shears || !strain_.averaged.of_stress.empty()) stress.xx.swap(own.xx), stress.yy.swap(own.yy);
    if (shears) stress.xy.swap(own.xy);
}

void update_stress_of_cells(const Problem& problem, double dt, const CellLists& lists, Particles& particles,
                            CellStrain& strain)
{
    Gradients& L = particles.velocity_gradient_solid;
    const bool shears = !strain.shared.of_material.empty(),
               grows = shears || !strain.averaged.of_strain.empty();
    if (grows) strain.own.xx = L.xx, strain.own.yy = L.yy;
    if (shears) strain.own.xy = L.xy, strain.own.yx = L.yx;
    average_volume_change(lists, strain.averaged, particles);
    approach_means(lists, strain.shared, strain.with_means, particles, {&L.xx, &L.xy, &L.yx, &L.yy});
    part_strains_of_soils(problem, dt, lists, strain.shared, particles);
    update_effective_stress(problem, dt, particles);
    if (grows) L.xx.swap(strain.own.xx), L.yy.swap(strain.own.yy);
    if (shears) L.xy.swap(strain.own.xy), L.yx.swap(strain.own.yx);
    even_out_cells(problem, dt, lists, particles);
}

} // namespace quicksand
