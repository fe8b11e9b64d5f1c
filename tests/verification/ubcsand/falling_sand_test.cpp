// A clod of wet sand that falls through cells which it hardly fills: it falls freely.
#include "solver/run/staged_run.hpp"
#include "tests/fixtures/scene_example.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

using fixtures::SceneFolder;

constexpr double cell = 0.0075; // [m]

const std::string scene = R"(scene_version = 1
geometry.file = "column.geo"
grid = { cell_size = 0.0075, origin = [0.0, 0.0], cells = [20, 40] }
sampling.particles_per_cell = [3, 3]
analysis.scheme = "implicit"
gravity.acceleration = "120 g"
materials.sand = { model = "ubcsand", preset = "nevada_sand_dr55", grain_density = 2670, porosity = 0.405, hydraulic_conductivity = 5.8e-5, conductivity_gravity = 9.81 }
water = { level = 0.30, cavitation_pressure = "2.3 kPa" }
regions.body.material = "sand"
regions.clod.material = "sand"
boundaries.base.soil = "fixed"
boundaries.left.soil = "roller"
boundaries.right.soil = "roller"
boundaries.top.soil = "free"
boundaries.face.soil = "free"
motion = { kind = "sine", amplitude = "20 g", frequency = "50 Hz" }
run.end_time = 0.01
)";

Ring block(double left, double bottom, double width, double height)
{
    return {{left, bottom}, {left + width, bottom}, {left + width, bottom + height}, {left, bottom + height}};
}

/// A body of 20 x 5 cells, and high above it a clod of two thirds of a cell, whose lower left corner is
/// given.
Section section_with_clod(double left, double bottom)
{
    const Ring body = block(0.0, 0.0, 20.0 * cell, 5.0 * cell),
               clod = block(left, bottom, 2.0 / 3.0 * cell, 2.0 / 3.0 * cell);
    Section section;
    section.regions = {{"body", {{body, {}}}}, {"clod", {{clod, {}}}}};
    section.curves = {
        {"base", {{body[0], body[1]}}},
        {"right", {{body[1], body[2]}}},
        {"top", {{body[2], body[3]}}},
        {"left", {{body[3], body[0]}}},
        {"face", {{clod[0], clod[1]}, {clod[1], clod[2]}, {clod[2], clod[3]}, {clod[3], clod[0]}}}};
    bound_section(section);
    return section;
}

// Pressures of cells with a sliver in them once bent those of the cells below, which blew the clod up in its
// fall where slivers of 1e-5 of a cell crossed a grid line.
TEST(FallingSand, FallsByItsBuoyantWeight)
{
    constexpr double porosity = 0.405, grains = 2670.0, water = 1000.0;
    const double weight =
        (1.0 - porosity) * (grains - water) / ((1.0 - porosity) * grains + porosity * water);
    for (const Vector2& corner : {Vector2(10.6, 27.0), Vector2(10.6, 22.3), Vector2(13.5, 27.0)}) {
        AssembledCase assembled =
            assemble_case(SceneFolder().read(scene), section_with_clod(corner.x() * cell, corner.y() * cell));
        constexpr double end = 0.0075, angular = 2.0 * std::numbers::pi * 50.0;
        StagedRun run(assembled.problem, std::move(assembled.state), {end, ColumnsComputed::all, true});
        run.begin_shaking();
        run.shake({});
        const Particles& particles = run.state().particles;
        for (std::size_t p = 0; p < particles.size(); ++p) {
            if (particles.position.y[p] < 10.0 * cell) continue;
            const double down = weight * 120.0 * standard_gravity * end, // and back, as the base moves on
                back = 20.0 * standard_gravity / angular * (1.0 - std::cos(angular * end));
            EXPECT_NEAR(particles.velocity_solid.y[p], -down, 0.01 * down);
            EXPECT_NEAR(particles.velocity_solid.x[p], -back, 0.01 * back);
        }
    }
}

} // namespace
} // namespace quicksand
