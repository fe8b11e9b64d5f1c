// Soil on slanted bases: at rest, settling and sliding.
#include "solver/measure/monitors.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

/// Level ground of 10 x 4 m whose base rises by `slope`.
AssembledCase ground_on(double slope, double h, const std::string& base, const std::string& soil)
{
    const std::vector<NamedCorner> corners = {{{0.0, 0.0}, "base"},
                                              {{10.0, 10.0 * slope}, "right"},
                                              {{10.0, 4.0}, "surface"},
                                              {{0.0, 4.0}, "left"}};
    const std::string walls = "[boundaries.base]\nsoil = \"" + base +
                              "\"\n[boundaries.left]\nsoil = \"roller\"\n[boundaries.right]\nsoil = "
                              "\"roller\"\n[relaxation]\ntolerance = 1e-6\n";
    return assemble(
        scene_with(h, {0.0, 0.0}, static_cast<int>(10.0 / h), static_cast<int>(5.0 / h), soil + walls),
        polygon_section(corners));
}

TEST(SlantedBase, LevelGroundRestsOnIt)
{
    for (const std::string& soil : {elastic, mohr_coulomb}) {
        for (const double slope : {0.05, 0.2}) {
            AssembledCase assembled = ground_on(slope, 0.2, "fixed", soil);
            RelaxationControls controls;
            controls.tolerance = 1e-6;
            relax(assembled.problem, controls, assembled.state);
            const Particles& particles = assembled.state.particles;
            const double weight =
                0.6 * assembled.problem.materials[0].grain_density * assembled.problem.gravity;
            double square = 0.0, volume = 0.0, worst = 0.0;
            for (std::size_t p = 0; p < particles.size(); ++p) {
                const double error =
                    (-particles.stress.yy[p] - weight * (4.0 - particles.reference_position.y[p])) /
                    (weight * 4.0);
                square += particles.volume[p] * error * error;
                volume += particles.volume[p];
                worst = std::max(worst, std::abs(error));
            }
            EXPECT_LT(std::sqrt(square / volume), 1e-3) << slope; // measured 2e-5
            // a sliver has the stress of its carrier: a box of 5e-2 m of 4 m away at most
            EXPECT_LT(worst, 0.025) << slope; // measured 9e-3
        }
    }
}

TEST(SlantedBase, SandUnderWaterStaysAtRestOnIt)
{
    const std::string sand = R"(
[analysis]
scheme = "semi_implicit"
[water]
level = 5.0
[materials.soil]
model = "ubcsand"
relative_density = "45 %"
porosity = 0.43
hydraulic_conductivity = 1e-4
[regions.soil]
material = "soil"
)";
    for (const double slope : {0.05, 0.2}) {
        AssembledCase assembled = ground_on(slope, 0.4, "fixed", sand);
        RelaxationControls controls;
        controls.tolerance = 1e-6;
        relax(assembled.problem, controls, assembled.state);
        State& state = assembled.state;
        run(assembled.problem, 0.2, {}, state);
        const Monitors monitors = monitor(assembled.problem, state, {});
        const double fall = std::sqrt(assembled.problem.gravity * 4.0); // sqrt(g H) [m/s]
        EXPECT_LT(monitors.max_velocity, 1e-5 * fall) << slope;         // measured 5e-9
        EXPECT_LT(monitors.max_ru, 1e-4) << slope;                      // 2e-6
    }
}

/// A slope of 1:2, 2 m high under water on 2 m of the same sand.
AssembledCase slope_of(const std::string& model, int particles, double offset)
{
    const std::vector<NamedCorner> corners = {{{0.0, 0.0}, "base"},    {{12.0, 0.0}, "right"},
                                              {{12.0, 2.0}, "ground"}, {{8.0, 2.0}, "ground"},
                                              {{4.0, 4.0}, "ground"},  {{0.0, 4.0}, "left"}};
    const std::string tables = section_in_water(particles, "semi_implicit", "5.0",
                                                "model = \"" + model + "\"\nrelative_density = 0.55\n") +
                               "tolerance = 1e-6\n";
    return assemble(scene_with(0.5, {-1.0 - offset, -1.0 - offset}, 28, 13, tables),
                    polygon_section(corners));
}

/// Sand at its failure limit beneath the face included: nothing moves when the shaking begins.
TEST(SlopeOfSand, StaysAtRestFromTheFirstStepOn)
{
    for (const std::string model : {"ubcsand", "pm4sand"}) {
        for (const int particles : {2, 3}) {
            for (const double offset : {0.0, 0.19}) {
                AssembledCase assembled = slope_of(model, particles, offset);
                RelaxationControls controls;
                controls.tolerance = 1e-6;
                relax(assembled.problem, controls, assembled.state);
                const double fall = std::sqrt(assembled.problem.gravity * 4.0); // sqrt(g H) [m/s]
                for (const double time : {0.005, 0.02, 0.1}) {
                    run(assembled.problem, time, {}, assembled.state);
                    const Monitors monitors = monitor(assembled.problem, assembled.state, {});
                    EXPECT_LT(monitors.max_velocity, 1e-5 * fall) << model << particles << ' ' << offset;
                    EXPECT_LT(monitors.max_ru, 1e-4) << model << particles << " " << offset;
                }
            }
        }
    }
}

TEST(SlantedBase, SoilSettlesOnARoller)
{
    for (const double slope : {0.05, 0.25}) {
        AssembledCase assembled = ground_on(slope, 0.4, "roller", elastic);
        RelaxationControls controls;
        controls.tolerance = 1e-6;
        controls.max_steps = 20000;
        const RelaxationReport report = relax(assembled.problem, controls, assembled.state);
        EXPECT_LE(report.unbalanced.of_weight, 1e-6) << slope;
    }
}

TEST(SlantedBase, ABlockSlidesWithoutFriction)
{
    for (const double slope : {0.2, 1.0}) {
        for (const double offset : {0.0, 0.35}) {
            const double angle = std::atan(slope) * 180.0 / std::numbers::pi;
            const auto corners =
                turned({{{0.0, 0.0}, "base"}, {{3.0, 0.0}, ""}, {{3.0, 1.5}, ""}, {{0.0, 1.5}, ""}}, -angle,
                       {0.0, 0.0});
            const std::string walls = "[boundaries.base]\nsoil = \"roller\"\n";
            AssembledCase assembled =
                assemble(scene_with(0.2, {-1.0 + 0.2 * offset, -5.0}, 45, 40, elastic + walls),
                         polygon_section(corners));
            const Vector2 along = (corners[1].place - corners[0].place).normalized(),
                          normal(along.y(), -along.x());
            const double time = 0.6; // through seven cells on the steeper slope
            run(assembled.problem, time, {}, assembled.state);
            const Particles& particles = assembled.state.particles;
            Vector2 moved = Vector2::Zero();
            double mass = 0.0, deepest = -1.0;
            for (std::size_t p = 0; p < particles.size(); ++p) {
                moved += particles.mass_solid[p] * (particles.position[p] - particles.reference_position[p]);
                mass += particles.mass_solid[p];
                for (const Vector2& corner : domain_polygon(assembled.problem.cut_domains, particles, p))
                    deepest = std::max(deepest, corner.dot(normal));
            }
            moved /= mass;
            const double acceleration = 2.0 * moved.dot(along) / (time * time);
            const double expected = assembled.problem.gravity * std::sin(std::atan(slope));
            EXPECT_NEAR(acceleration / expected, 1.0, 1e-3) << slope << ' ' << offset; // measured 1e-5
            EXPECT_LT(deepest, 0.01 * 0.2) << slope << ' ' << offset;
        }
    }
}

} // namespace
} // namespace quicksand
