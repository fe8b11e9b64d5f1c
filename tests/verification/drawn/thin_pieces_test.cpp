// Thin soil: pieces that a level surface cuts off the boxes, and fill that thins out on rock.
#include "solver/measure/monitors.hpp"
#include "solver/run/staged_run.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace quicksand {
namespace {

using namespace fixtures;

/// The ground's state after a cycle of shaking, computed from all columns of cells or from one.
State shaken(const AssembledCase& ground, ColumnsComputed columns)
{
    StagedRun run(ground.problem, ground.state, {0.05, columns, true});
    EXPECT_EQ(run.column() != nullptr, columns == ColumnsComputed::one) << run.obstacle();
    run.begin_shaking();
    EXPECT_TRUE(run.shake({}));
    return run.state_of_body();
}

TEST(ThinPieces, OfOneColumnAreCarriedAsThoseOfAll)
{
    const std::vector<NamedCorner> corners = {
        {{0.0, 0.0}, "base"}, {{4.0, 0.0}, "right"}, {{4.0, 2.01}, "surface"}, {{0.0, 2.01}, "left"}};
    const std::string walls = base_and_tied_sides + R"([sampling]
particles_per_cell = [3, 3]
[motion]
kind = "sine"
amplitude = "0.1 g"
frequency = "20 Hz"
)";
    const AssembledCase ground =
        assemble(scene_with(0.5, {0.0, 0.0}, 8, 6, elastic + walls), polygon_section(corners));
    ASSERT_FALSE(ground.problem.cut_domains.slivers.empty());
    const State all = shaken(ground, ColumnsComputed::all), one = shaken(ground, ColumnsComputed::one);
    const double fallen = monitor(ground.problem, all, {}).max_displacement;
    EXPECT_GT(fallen, 1e-6);
    double apart = 0.0;
    for (std::size_t p = 0; p < all.particles.size(); ++p) {
        for (std::size_t q = 0; q < one.particles.size(); ++q)
            if (one.particles.identifier[q] == all.particles.identifier[p])
                apart = std::max(apart, (one.particles.position[q] - all.particles.position[p]).norm());
    }
    EXPECT_LT(apart, 1e-9 * fallen + 1e-14);
}

/// Largest velocity of grains within half a second from rest, in fill under water that thins out to the left
/// on rock falling by 1 in `run_out` [m/s].
double unrest_of_wedge(double run_out, int particles, const std::string& soil)
{
    const double depth = 0.3, width = run_out * depth;
    std::string tables = section_in_water(particles, "semi_implicit", "0.5", soil);
    const std::string left = "[boundaries.left]\nsoil = \"roller\"\n"; // there is no side at the tip
    tables.replace(tables.find(left), left.size(), "[boundaries.top]\nsoil = \"free\"\n");
    const AssembledCase wedge =
        assemble(scene_with(0.1, {-0.2, -0.5}, static_cast<int>(10.0 * width) + 4, 7, tables),
                 polygon_section({{{0.0, 0.0}, "base"}, {{width, -depth}, "right"}, {{width, 0.0}, "top"}}));
    State state = wedge.state;
    EXPECT_LE(relax(wedge.problem, {}, state).unbalanced.of_weight, 1e-6);
    double largest = 0.0;
    for (int part = 1; part <= 5; ++part) {
        run(wedge.problem, 0.1 * part, {}, state);
        for (std::size_t p = 0; p < state.particles.size(); ++p)
            largest = std::max(largest, state.particles.velocity_solid[p].norm());
    }
    return largest;
}

TEST(ThinPieces, OfFillThatThinsOutOnRockRestToTheTip)
{
    // more than two cells at the tip are badly filled where rock falls by less than 1:6
    const std::string stiff = "model = \"linear_elastic\"\nshear_modulus = \"8 MPa\"\npoisson_ratio = 0.3\n";
    const std::string sand = "model = \"ubcsand\"\nrelative_density = \"50 %\"\n";
    for (const double run_out : {7.0, 12.0}) {
        for (const int particles : {3, 4}) {
            EXPECT_LT(unrest_of_wedge(run_out, particles, stiff), 1e-6) << run_out << ", " << particles;
            EXPECT_LT(unrest_of_wedge(run_out, particles, sand), 1e-6) << run_out << ", " << particles;
        }
    }
}

} // namespace
} // namespace quicksand
