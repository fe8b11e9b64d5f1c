// A slope that stands by two per cent of its strength settles; one that lacks five per cent, or ten, is said
// to run away within 2,000 steps.
#include "solver/base/failure.hpp"
#include "solver/run/strength_reduction.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace fixtures;

/// A slope of 1:1.5, 6 m high, on 2 m of the same soil; lengths in m.
AssembledCase slope(double cell, const Vector2& shift, int particles)
{
    std::vector<NamedCorner> corners = {{{0.0, 0.0}, "base"},    {{24.0, 0.0}, "right"},
                                        {{24.0, 2.0}, "ground"}, {{15.0, 2.0}, "ground"},
                                        {{6.0, 8.0}, "ground"},  {{0.0, 8.0}, "left"}};
    for (NamedCorner& corner : corners) corner.place += shift;
    const std::string tables = "[sampling]\nparticles_per_cell = [" + std::to_string(particles) + ", " +
                               std::to_string(particles) + "]\n" + base_and_sides + "[relaxation]\n" +
                               mohr_coulomb;
    return assemble(scene_with(cell, {-2.0 * cell, -2.0 * cell}, static_cast<int>(24.0 / cell) + 5,
                               static_cast<int>(8.0 / cell) + 5, tables),
                    polygon_section(corners));
}

TEST(RunawaySlope, IsToldSoonAndNotOfOneThatStands)
{
    for (const Vector2& shift : {Vector2(0.0, 0.0), Vector2(0.23, 0.31)}) {
        AssembledCase drawn = slope(1.0, shift, 2);
        State state = drawn.state;
        StrengthReductionControls controls;
        controls.tolerance = 0.01;
        const SafetyFactor safety = safety_factor(drawn.problem, controls, state);

        State stands = drawn.state;
        const Problem strong = with_reduced_strength(drawn.problem, safety.factor / 1.02);
        EXPECT_TRUE(relax(strong, {}, stands).settled) << safety.factor;

        State slides = drawn.state;
        const Problem weak = with_reduced_strength(drawn.problem, safety.factor / 0.95);
        try {
            relax(weak, {}, slides);
            ADD_FAILURE() << "it has settled, at " << safety.factor;
        } catch (const NumericalError& error) {
            const std::string text = error.what();
            EXPECT_NE(text.find("the soil runs away instead of settling: it has moved "), std::string::npos)
                << text;
            EXPECT_LE(error.record.step, 2000);
        }
    }
}

} // namespace
} // namespace quicksand
