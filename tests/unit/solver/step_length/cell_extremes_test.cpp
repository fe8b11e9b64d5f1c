#include "solver/motion/particle_order.hpp"
#include "solver/step_length/cell_extremes.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double h = 0.0075; // cell size of the column [m]

/// Settling sand, whose modulus follows the root of its mean stress, under 100 kPa; the top layer fills a
/// third of its cells.
struct Column {
    Problem problem = centrifuge_column();
    State state;
    double modulus; // M at 100 kPa [Pa]

    Column()
    {
        const SettlingSand law{make_ubcsand(nevada_sand_55())};
        problem.materials[0].law = law;
        state = fill(problem, 3, [](const Vector2& x) { return x.y() < 4.0 * h + h / 3.0; });
        CellLists lists = make_cell_lists(problem.grid);
        sort_particles(problem.grid, 0.0, state, lists);
        for (std::size_t p = 0; p < state.particles.size(); ++p) set_mean_stress(p, 100e3);
        modulus = particle_moduli(law, 0, 1, state.particles).stiffest;
    }

    void set_mean_stress(std::size_t p, double stress)
    {
        SymmetricTensors& stresses = state.particles.stress;
        stresses.xx[p] = stresses.yy[p] = stresses.zz[p] = -stress;
    }

    std::size_t particle_near(const Vector2& place) const
    {
        std::size_t nearest = 0;
        const auto distance = [&](std::size_t p) {
            return (Vector2(state.particles.position.x[p], state.particles.position.y[p]) - place).norm();
        };
        for (std::size_t p = 1; p < state.particles.size(); ++p)
            if (distance(p) < distance(nearest)) nearest = p;
        return nearest;
    }

    double stiffest() const { return find_extremes(problem, state.particles).materials[0].stiffest_modulus; }
};

TEST(CellExtremes, OfUniformSoilAreThoseOfAnyParticle)
{
    const Column column;
    EXPECT_NEAR(column.stiffest(), column.modulus, 1e-12 * column.modulus);
}

TEST(CellExtremes, AStiffParticleCountsByItsPartOfTheCell)
{
    Column column;
    column.set_mean_stress(column.particle_near({2.5 * h, 1.5 * h}), 900e3); // three times as stiff
    EXPECT_NEAR(column.stiffest(), (8.0 + 3.0) / 9.0 * column.modulus, 1e-9 * column.modulus);
}

TEST(CellExtremes, AStiffParticleCountsByTheEmptyPartToo)
{
    Column column;
    column.set_mean_stress(column.particle_near({2.5 * h, 4.2 * h}), 900e3);
    const double mean = (2.0 + 3.0) / 3.0;
    EXPECT_NEAR(column.stiffest(), (mean + 2.0 / 3.0 * (3.0 - mean)) * column.modulus, 1e-9 * column.modulus);
}

TEST(CellExtremes, ACutCellHasPiecesWhereverItsParticlesStandInMemory)
{
    Column column;
    const std::size_t count = column.state.particles.size();
    const auto stiffest_cut = [&] {
        return find_extremes(column.problem, column.state.particles).materials[0].stiffest_cut_modulus;
    };
    EXPECT_EQ(stiffest_cut(), 0.0); // cells filled in part, and none cut
    const auto in_partly_filled_cell =
        static_cast<std::size_t>(column.state.particles.identifier[column.particle_near({2.5 * h, 4.2 * h})]);
    column.problem.cut_domains.pieces.assign(count, 0);
    column.problem.cut_domains.pieces[in_partly_filled_cell] = 1;
    EXPECT_GT(stiffest_cut(), 0.0);
    // whole particles far apart in memory look like cells that are filled in part
    std::vector<std::int32_t> order(count);
    for (std::size_t p = 0; p < count; ++p) order[p] = static_cast<std::int32_t>((p * 7) % count);
    reorder(column.state.particles, order);
    column.set_mean_stress(column.particle_near({2.5 * h, 1.5 * h}), 900e3);
    EXPECT_LT(stiffest_cut(), 2.0 * column.modulus);
}

TEST(CellExtremes, PorosityIsThatOfTheCell)
{
    Column column;
    const std::size_t p = column.particle_near({2.5 * h, 1.5 * h});
    const double solid = 1.0 - column.problem.materials[0].porosity;
    column.state.particles.mass_solid[p] *= 1.09;
    const MaterialExtremes extremes = find_extremes(column.problem, column.state.particles).materials[0];
    EXPECT_NEAR(extremes.min_porosity, 1.0 - 1.01 * solid, 1e-12);
    EXPECT_NEAR(extremes.max_porosity, 1.0 - solid, 1e-12);
}

TEST(CellExtremes, HaveTheLargestSpeed)
{
    Column column;
    column.state.particles.velocity_solid.set(17, {-3.0, 4.0});
    EXPECT_DOUBLE_EQ(find_extremes(column.problem, column.state.particles).max_speed, 5.0);
}

} // namespace
} // namespace quicksand
