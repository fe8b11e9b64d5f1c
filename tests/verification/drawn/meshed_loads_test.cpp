// Loads on curves of a section that is meshed, whose domains are quadrilaterals of any shape.
#include "solver/step/single_phase_step.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace quicksand {
namespace {

constexpr double pressure_around = 1000.0; // all around [Pa]

const std::string meshed_scene = R"(scene_version = 1
[geometry]
file = "drawing.geo"
[grid]
cell_size = 1.12
[analysis]
interpolation = "cpdi2"
[sampling]
kind = "mesh"
[materials.soil]
model = "linear_elastic"
shear_modulus = 1e7
poisson_ratio = 0.3
porosity = 0.4
[regions.soil]
material = "soil"
[boundaries.outline]
pressure = 1000
[run]
end_time = 0.1
)";

/// The outline as a drawing of one region and one curve.
std::string drawing_of(const std::vector<Vector2>& corners)
{
    std::ostringstream points, lines, loop;
    points.precision(17);
    for (std::size_t k = 1; k <= corners.size(); ++k) {
        points << "Point(" << k << ") = {" << corners[k - 1].x() << ", " << corners[k - 1].y() << ", 0};\n";
        lines << "Line(" << k << ") = {" << k << ", " << k % corners.size() + 1 << "};\n";
        loop << (k > 1 ? ", " : "") << k;
    }
    return points.str() + lines.str() + "Curve Loop(1) = {" + loop.str() +
           "};\nPlane Surface(1) = {1};\nPhysical Surface(\"soil\") = {1};\nPhysical Curve(\"outline\") = {" +
           loop.str() + "};\n";
}

/// Ground that falls to the height at its right side, on uneven rock; turned by an angle in degrees.
AssembledCase falling_ground(double height, double degrees)
{
    std::vector<Vector2> corners = {{0.0, -0.5},    {4.0, -0.1}, {10.1, 0.5},
                                    {10.1, height}, {4.0, 6.1},  {0.0, 6.1}};
    for (Vector2& corner : corners) corner = fixtures::turn(corner, degrees);
    const fixtures::TemporaryFolder folder;
    std::ofstream(folder / "drawing.geo") << drawing_of(corners);
    std::ofstream(folder / "scene.toml") << meshed_scene;
    return assemble_case(read_scene_file(folder / "scene.toml", {}));
}

/// Largest force that a uniform stress and its pressure all around leave on a node [N/m].
double largest_rest(AssembledCase ground)
{
    State& state = ground.state;
    std::fill(state.particles.stress.xx.begin(), state.particles.stress.xx.end(), -pressure_around);
    std::fill(state.particles.stress.yy.begin(), state.particles.stress.yy.end(), -pressure_around);
    ground.problem.gravity = 0.0;
    state.stage = Stage::shaking;
    SinglePhaseWorkspace work = make_single_phase_workspace(ground.problem);
    update_cell_lists(ground.problem.grid, state.particles, work.lists);
    scatter_to_nodes(ground.problem, 0.0, state, work);
    double largest = 0.0;
    for (const SinglePhaseSums& node : work.sums)
        largest = std::max({largest, std::abs(node.stress_force_x), std::abs(node.stress_force_y)});
    return largest;
}

TEST(MeshedLoads, ArePassedOnByTheDomainsTheyLieOn)
{
    for (const double height : {4.2, 4.73, 5.2})
        for (const double degrees : {0.0, 17.0})
            for (const Boundary& boundary : falling_ground(height, degrees).problem.boundaries)
                for (const BoundaryPiece& piece : boundary.pieces) {
                    const double farthest =
                        std::max(piece.start.cwiseAbs().maxCoeff(), piece.end.cwiseAbs().maxCoeff());
                    EXPECT_LT(farthest, 1.0 + 1e-6) << height << " m, " << degrees << " degrees";
                }
}

TEST(MeshedLoads, BalanceAUniformStressAtEveryNode)
{
    for (const double height : {4.2, 4.73, 5.2})
        for (const double degrees : {0.0, 17.0})
            EXPECT_LT(largest_rest(falling_ground(height, degrees)), 1e-6 * pressure_around)
                << height << " m, " << degrees << " degrees";
}

} // namespace
} // namespace quicksand
