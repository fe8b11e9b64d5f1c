// Faces that lie next to a line of the grid: what reaches over it by less than a part of a cell has no say.
#include "solver/run/strength_reduction.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double spacing = 0.5; // of the lines [m]

std::string still_scene(const std::string& soil)
{
    return "[analysis]\nstrain = \"small\"\n[sampling]\nparticles_per_cell = [2, 2]\n" + base_and_sides +
           "[initial]\nk0 = 1.0\n[materials.soil]\nmodel = \"mohr_coulomb\"\nporosity = 0.4\ngrain_density = "
           "3000\nshear_modulus = \"10 MPa\"\n" +
           soil + "[regions.soil]\nmaterial = \"soil\"\n[relaxation]\n";
}

/// The largest displacement of level dry sand without cohesion while it settles, its surface this high above
/// a line at the left and the right side [m].
double settlement_of_sand(double left, double right)
{
    const Section section = polygon_section(
        {{{0.0, 0.0}, "base"}, {{5.0, 0.0}, "right"}, {{5.0, 2.0 + right}, ""}, {{0.0, 2.0 + left}, "left"}});
    AssembledCase assembled = assemble(
        scene_with(spacing, {-1.0, -1.0}, 14, 9, still_scene("poisson_ratio = 0.3\nfriction_angle = 33\n")),
        section);
    return relax(assembled.problem, *assembled.scene.relaxation, assembled.state).max_displacement;
}

TEST(NearLines, LevelSandRestsHoweverNearItsSurfaceIsToALine)
{
    for (const double height : {0.0, 1e-9, 1e-6, 1e-5, 1e-4, 9e-4, 1.1e-3, 1e-2})
        EXPECT_LT(settlement_of_sand(height, height), 1e-3) << height;
    for (const double tilt : {1e-5, 1e-4, 1e-3, 1e-2}) {
        EXPECT_LT(settlement_of_sand(0.0, tilt), 1e-3) << tilt;
        EXPECT_LT(settlement_of_sand(tilt, 0.0), 1e-3) << tilt;
    }
}

/// The factor of safety of a cut in clay, 2.5 m high, whose face leans back by `run` [m].
double factor_of_cut(double run, const Vector2& shift = Vector2::Zero())
{
    std::vector<NamedCorner> corners = {{{-5.0, -1.5}, "base"}, {{3.0, -1.5}, "right"},
                                        {{3.0, 0.0}, ""},       {{run, 0.0}, ""},
                                        {{0.0, 2.5}, ""},       {{-5.0, 2.5}, "left"}};
    for (NamedCorner& corner : corners) corner.place += shift;
    AssembledCase assembled =
        assemble(scene_with(spacing, {-7.0, -2.5}, 23, 13,
                            still_scene("poisson_ratio = 0.49\nfriction_angle = 0\ncohesion = 15000\n")),
                 polygon_section(corners));
    relax(assembled.problem, *assembled.scene.relaxation, assembled.state);
    return safety_factor(assembled.problem, {}, assembled.state).factor;
}

TEST(NearLines, ACutHasTheFactorOfOneOnTheLine)
{
    const double aligned = factor_of_cut(0.0);
    for (const double run : {1e-6, 1e-5, 1e-4, 3e-4, 9e-4, 1.1e-3, 2e-3, 1e-2})
        EXPECT_NEAR(factor_of_cut(run), aligned, 0.01) << run;
    for (const double shift : {1e-5, 1e-4, 1.1e-3}) {
        EXPECT_NEAR(factor_of_cut(0.0, {shift, 0.0}), aligned, 0.01) << shift;
        EXPECT_NEAR(factor_of_cut(0.0, {0.0, shift}), aligned, 0.01) << shift;
    }
}

/// The particles of a drawing whose face "cut" between the rollers "base" and "left" has given way under 10
/// kPa.
Particles soil_that_gives_way(const Section& section, const std::string& strain,
                              const std::string& tables = "")
{
    AssembledCase assembled = assemble(
        scene_with(
            0.25, {-3.0, -1.0}, 28, 20,
            "[analysis]\nscheme = \"explicit\"\nstrain = \"" + strain +
                "\"\n[gravity]\nacceleration = 0.0\n[sampling]\nparticles_per_cell = [3, "
                "3]\n[materials.soil]\nmodel = \"linear_elastic\"\n"
                "shear_modulus = 4e6\npoisson_ratio = 0.25\nporosity = 0.4\n[regions.soil]\nmaterial = "
                "\"soil\"\n[boundaries.base]\nsoil = \"roller\"\n[boundaries.left]\nsoil = \"roller\"\n"
                "[boundaries.far]\nsoil = \"fixed\"\n[boundaries.cut]\nsoil = \"free\"\npressure = 1e4\n"
                "ramp_time = 0.5\n" +
                tables),
        section);
    begin_shaking(assembled.problem, assembled.state);
    run(assembled.problem, 0.6, {}, assembled.state);
    return assembled.state.particles;
}

/// How far the middle of a face of 45 degrees, which cuts the corner between two rollers, gives way; the
/// drawing is shifted against the grid by this along both axes [m].
double give_of_cut_corner(double legs, double shift, const std::string& strain)
{
    const Particles particles = soil_that_gives_way(polygon_section({{{legs + shift, shift}, "base"},
                                                                     {{3.0 + shift, shift}, "far"},
                                                                     {{3.0 + shift, 3.0 + shift}, "far"},
                                                                     {{shift, 3.0 + shift}, "left"},
                                                                     {{shift, legs + shift}, "cut"}}),
                                                    strain);
    const Vector2 middle = Vector2::Constant(0.5 * legs + shift);
    std::size_t nearest = 0;
    for (std::size_t p = 0; p < particles.size(); ++p)
        if ((particles.reference_position[p] - middle).norm() <
            (particles.reference_position[nearest] - middle).norm())
            nearest = p;
    return (particles.position[nearest] - particles.reference_position[nearest]).norm();
}

/// How far the soil within 0.45 m of a face moves in the mean that is set back by 0.3 m in a gap of 1 m
/// between two rollers in a line [m].
double give_of_gap(const Vector2& shift)
{
    const auto at = [&](double x, double y) { return Vector2(Vector2(x, y) + shift); };
    const std::string rollers =
        "[boundaries.right]\nsoil = \"roller\"\n[boundaries.west]\nsoil = \"roller\"\n";
    const Particles particles = soil_that_gives_way(polygon_section({{at(0.0, 0.0), "base"},
                                                                     {at(1.0, 0.0), "cut"},
                                                                     {at(1.3, 0.3), "cut"},
                                                                     {at(1.7, 0.3), "cut"},
                                                                     {at(2.0, 0.0), "left"},
                                                                     {at(3.0, 0.0), "right"},
                                                                     {at(3.0, 3.0), "far"},
                                                                     {at(0.0, 3.0), "west"}}),
                                                    "small", rollers);
    Vector2 sum = Vector2::Zero();
    double count = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if ((particles.reference_position[p] - at(1.5, 0.3)).norm() > 0.45) continue;
        sum += particles.position[p] - particles.reference_position[p];
        count += 1.0;
    }
    return sum.norm() / count;
}

// Walls that went on beyond their ends held the face: 0.19 and 0.15 of what finer cells give.
TEST(NearLines, AFaceBetweenTwoWallsGivesWayWhereverTheyLie)
{
    for (const std::string strain : {"small", "large"}) {
        for (const double shift : {0.005, 0.02, 0.05, 0.12, 0.24}) { // measured 0.92 to 1.09
            EXPECT_NEAR(give_of_cut_corner(0.5, shift, strain) / 5.15e-4, 1.0, 0.15) << shift << strain;
            EXPECT_NEAR(give_of_cut_corner(0.75, shift, strain) / 8.15e-4, 1.0, 0.15) << shift << strain;
        }
    }
}

// A wall that ends by a hair beyond a grid line held the face with all that lies beyond its end: 0.55 to
// 0.58.
TEST(NearLines, AFaceBetweenWallsThatEndByAHairBeyondALineGivesWay)
{
    for (const Vector2& shift : {Vector2(-0.001, 0.0001), Vector2(-0.001, 0.003), Vector2(0.01, 0.003)})
        EXPECT_NEAR(give_of_gap(shift) / 4.06e-4, 1.0, 0.15) << shift.transpose(); // cells of 1/16 m
}

} // namespace
} // namespace quicksand
