// A slope that stands by two or ten per cent of its strength settles; one that lacks five, ten or thirty per
// cent is said to run away within 2,000 steps. A slope of sand stands as its friction says.
#include "solver/base/failure.hpp"
#include "solver/run/strength_reduction.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace fixtures;

/// Soil of a slope of 1 : run.
struct Soil {
    std::string law;
    double run = 2.0;    // [-]
    double factor = 0.0; // of safety, tan(phi_f) run where the soil has friction alone; 0: another one [-]
};

const Soil earth = {mohr_coulomb, 1.5};

Soil sand_of_friction(const std::string& model, double friction_degrees)
{
    return {"[materials.soil]\nmodel = \"" + model +
                "\"\nrelative_density = 0.5\nporosity = 0.43\n[regions.soil]\nmaterial = \"soil\"\n",
            2.0, 2.0 * std::tan(friction_degrees * std::numbers::pi / 180.0)};
}

const Soil standing_ubcsand = sand_of_friction("ubcsand", 33.0 + 46.0 * 0.25 / 10.0),
           standing_pm4sand = sand_of_friction("pm4sand", 37.5);

/// A slope 6 m high on 2 m of the same soil, on cells of 1 m; lengths in m.
AssembledCase slope_of_soil(const Soil& soil, const Vector2& shift, int particles)
{
    const double toe = 6.0 + 6.0 * soil.run, end = toe + 9.0;
    std::vector<NamedCorner> corners = {{{0.0, 0.0}, "base"},   {{end, 0.0}, "right"},
                                        {{end, 2.0}, "ground"}, {{toe, 2.0}, "ground"},
                                        {{6.0, 8.0}, "ground"}, {{0.0, 8.0}, "left"}};
    for (NamedCorner& corner : corners) corner.place += shift;
    const std::string count = std::to_string(particles);
    return assemble(scene_with(1.0, {-2.0, -2.0}, static_cast<int>(end) + 5, 13,
                               "[sampling]\nparticles_per_cell = [" + count + ", " + count + "]\n" +
                                   base_and_sides + "[relaxation]\n" + soil.law),
                    polygon_section(corners));
}

struct Drawn {
    std::string name;
    Soil soil;
    Vector2 shift; // of the section in the grid [m]
    int particles = 2;
};

class RunawaySlope : public testing::TestWithParam<Drawn> {};

TEST_P(RunawaySlope, IsToldSoonAndNotOfOneThatStands)
{
    const AssembledCase drawn = slope_of_soil(GetParam().soil, GetParam().shift, GetParam().particles);
    State state = drawn.state;
    const double factor = safety_factor(drawn.problem, {}, state).factor;
    if (const double expected = GetParam().soil.factor; expected > 0.0) {
        EXPECT_NEAR(factor, expected, 0.05 * expected); // on cells of a sixth of the height
    }
    for (const double strength : {1.02, 1.1}) {
        State stands = drawn.state;
        EXPECT_TRUE(relax(with_reduced_strength(drawn.problem, factor / strength), {}, stands).settled)
            << factor;
    }
    for (const double strength : {0.95, 0.9, 0.7}) {
        State slides = drawn.state;
        try {
            relax(with_reduced_strength(drawn.problem, factor / strength), {}, slides);
            ADD_FAILURE() << "it has settled, at " << strength << " of " << factor;
        } catch (const NumericalError& error) {
            const std::string text = error.what();
            EXPECT_NE(text.find("the soil runs away instead of settling: it has moved "), std::string::npos)
                << text;
            EXPECT_LE(error.record.step, 2000) << strength;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Drawn, RunawaySlope,
                         testing::Values(Drawn{"EarthOnTheGrid", earth, {0.0, 0.0}, 2},
                                         Drawn{"EarthOffTheGrid", earth, {0.23, 0.31}, 3},
                                         Drawn{"UbcsandOffTheGrid", standing_ubcsand, {0.23, 0.31}, 2},
                                         Drawn{"UbcsandOnTheGrid", standing_ubcsand, {0.0, 0.0}, 3},
                                         Drawn{"Pm4sandOnTheGrid", standing_pm4sand, {0.0, 0.0}, 2},
                                         Drawn{"Pm4sandOffTheGrid", standing_pm4sand, {0.23, 0.31}, 3}),
                         [](const auto& drawn) { return drawn.param.name; });

// What fails only without the allowance of a cell's weight that sand has at first.
TEST(RunawaySand, IsToldAtTheStrengthOfTheShaking)
{
    AssembledCase drawn = slope_of_soil(standing_ubcsand, {0.0, 0.0}, 2);
    UbcSand& sand = std::get<UbcSand>(drawn.problem.materials[0].law);
    sand.eta_f = std::sin(std::atan(0.95 * 0.5)); // phi_f beneath the slope's angle
    try {
        relax(drawn.problem, {}, drawn.state);
        ADD_FAILURE() << "it has settled";
    } catch (const NumericalError& error) {
        EXPECT_NE(std::string(error.what()).find("the soil runs away"), std::string::npos) << error.what();
        EXPECT_LE(error.record.step, 2500);
    }
}

} // namespace
} // namespace quicksand
