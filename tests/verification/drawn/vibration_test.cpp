// Periods of elastic bodies at any angle to the grid.
#include "solver/step/stepper.hpp"
#include "solver/step_length/time_step_control.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace quicksand {
namespace {

using namespace fixtures;

const std::string weightless_body =
    "[sampling]\nparticles_per_cell = [2, 2]\n[gravity]\nacceleration = 0.0\n" + elastic;

/// Velocity of a mode at a point, both in the drawing's own directions.
using Mode = std::function<Vector2(const Vector2&)>;

/// Period with which a body swings that begins with the velocities of a mode [s], in the mean of four.
double period_of(AssembledCase& assembled, double degrees, const Mode& mode)
{
    State& state = assembled.state;
    begin_shaking(assembled.problem, state);
    const auto velocity = [&](std::size_t p) {
        return turn(mode(turn(state.particles.reference_position[p], -degrees)), degrees);
    };
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        state.particles.velocity_solid.set(p, 1e-4 * velocity(p));
    const auto stepper = make_stepper(assembled.problem);
    const double dt = stable_time_step(assembled.problem, state.particles).dt;
    std::vector<double> crossings;
    double last = 1.0;
    while (crossings.size() < 9) {
        stepper->advance(assembled.problem, dt, state);
        double amplitude = 0.0;
        for (std::size_t p = 0; p < state.particles.size(); ++p)
            amplitude += state.particles.mass_solid[p] * state.particles.velocity_solid[p].dot(velocity(p));
        if ((amplitude > 0.0) != (last > 0.0) && state.step > 1)
            crossings.push_back((static_cast<double>(state.step) - amplitude / (amplitude - last)) * dt);
        last = amplitude;
        if (state.step > 100'000) return 0.0;
    }
    return (crossings[8] - crossings[0]) / 4.0;
}

AssembledCase vibrating_case(const std::vector<NamedCorner>& corners, double h, double degrees, double offset,
                             const std::string& tables)
{
    const Vector2 origin(-1.1 + offset * h, -0.3 + 0.7 * offset * h);
    return assemble(scene_with(h, origin, static_cast<int>(2.4 / h), static_cast<int>(2.1 / h), tables),
                    polygon_section(turned(corners, degrees, {0.0, 0.0})));
}

TEST(TurnedColumn, SwingsInCompressionWithItsPeriod)
{
    const std::vector<NamedCorner> column = {
        {{0.0, 0.0}, "base"}, {{0.3, 0.0}, "right"}, {{0.3, 1.0}, ""}, {{0.0, 1.0}, "left"}};
    const std::string walls =
        "[boundaries.base]\nsoil = \"fixed\"\n[boundaries.left]\nsoil = "
        "\"roller\"\n[boundaries.right]\nsoil = \"roller\"\n[analysis]\nstrain = \"small\"\n";
    const Mode mode = [](const Vector2& x) { return Vector2(0.0, std::sin(0.5 * std::numbers::pi * x.y())); };
    for (const double degrees : {0.0, 1.0, 5.0, 17.0, 30.0, 45.0}) {
        for (const double offset : {0.0, 0.1, 0.25, 0.5, 0.9}) {
            AssembledCase assembled = vibrating_case(column, 0.05, degrees, offset, weightless_body + walls);
            const Material& soil = assembled.problem.materials[0];
            const double speed = std::sqrt(constrained_modulus(std::get<LinearElastic>(soil.law)) /
                                           (0.6 * soil.grain_density));
            EXPECT_NEAR(period_of(assembled, degrees, mode) * speed / 4.0, 1.0, 1e-3) // measured 0.04 %
                << degrees << " degrees, " << offset;
        }
    }
}

TEST(TurnedBox, SwingsInShearWithItsPeriod)
{
    const std::vector<NamedCorner> box = {
        {{0.0, 0.0}, "a"}, {{1.0, 0.0}, "b"}, {{1.0, 1.0}, "c"}, {{0.0, 1.0}, "d"}};
    std::string walls = "[analysis]\nstrain = \"small\"\n";
    for (const std::string name : {"a", "b", "c", "d"})
        walls += "[boundaries." + name + "]\nsoil = \"roller\"\n";
    // without change of volume, and without shear on the walls: omega = sqrt(2) pi c_s / L
    const Mode mode = [](const Vector2& x) {
        const double a = std::numbers::pi * x.x(), b = std::numbers::pi * x.y();
        return Vector2(std::sin(a) * std::cos(b), -std::cos(a) * std::sin(b));
    };
    for (const double degrees : {0.0, 5.0, 17.0, 30.0, 45.0}) {
        AssembledCase assembled = vibrating_case(box, 0.025, degrees, 0.25, weightless_body + walls);
        const Material& soil = assembled.problem.materials[0];
        const double speed = std::sqrt(8e6 / (0.6 * soil.grain_density));
        EXPECT_NEAR(period_of(assembled, degrees, mode) * speed / std::numbers::sqrt2, 1.0, 1e-3) // 0.06 %
            << degrees << " degrees";
    }
}

} // namespace
} // namespace quicksand
