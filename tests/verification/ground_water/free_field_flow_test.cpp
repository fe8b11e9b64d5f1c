// Free-field sides beside a computed flow: none passes them, or what their head drives; their columns begin
// with its water, and what rests stays at rest.
#include "solver/run/simulation.hpp"
#include "tests/fixtures/drawn_section.hpp"
#include "tests/fixtures/grain_speed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double weight_of_water = 1000.0 * standard_gravity; // [N/m3]

/// A dike 4 m high on 4 m of ground with a river of head 2 on its left; level water in the ground beyond.
struct Drawing {
    std::string side = "soil = \"free_field\"\n"; // both sides
    std::string land_side;                        // more keys of the right one
    std::string level = "0.0";                    // [m]
    bool mirrored = false;
};

AssembledCase dike(const Drawing& drawing)
{
    std::vector<NamedCorner> corners = {{{-16.0, -4.0}, "base"}, {{16.0, -4.0}, "land_side"},
                                        {{16.0, 0.0}, "land"},   {{10.0, 0.0}, "land"},
                                        {{2.0, 4.0}, "land"},    {{-2.0, 4.0}, "river"},
                                        {{-10.0, 0.0}, "river"}, {{-16.0, 0.0}, "river_side"}};
    if (drawing.mirrored) {
        std::vector<NamedCorner> image;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const NamedCorner& corner = corners[corners.size() - 1 - k];
            const std::string& edge = corners[(2 * corners.size() - 2 - k) % corners.size()].edge;
            image.push_back({{-corner.place.x(), corner.place.y()}, edge});
        }
        corners = image;
    }
    const std::string tables = R"([analysis]
scheme = "semi_implicit"
[sampling]
particles_per_cell = [2, 2]
[water]
initial_flow = "seepage"
level = )" + drawing.level + R"(
[boundaries.base]
soil = "fixed"
[boundaries.river]
water = "head"
head = 2.0
[boundaries.land]
water = "drained"
[boundaries.river_side]
)" + drawing.side + "[boundaries.land_side]\n" +
                               drawing.side + drawing.land_side + "[relaxation]\ntolerance = 1e-6\n";
    std::string soil = elastic;
    soil.replace(soil.find("porosity"), 0, "hydraulic_conductivity = 1e-4\n");
    return assemble(scene_with(1.0, {-17.0, -5.0}, 34, 12, tables + soil), polygon_section(corners));
}

/// The ground water stands a metre below the land, and the land's side keeps it there.
Drawing with_held_level()
{
    return {"soil = \"free_field\"\n", "water = \"head\"\nhead = -1.0\n", "-1.0", false};
}

/// Largest relative difference of the column's pore pressure from that of still water of a head.
double column_error(const AssembledCase& drawn, std::size_t field, double head)
{
    const Problem& column = drawn.problem.free_fields[field].column;
    const Particles& particles = drawn.state.free_fields[field].column.particles;
    double error = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double y = particles.position.y[p];
        const double still = std::max(0.0, weight_of_water * (head - y));
        const double found = is_wet(column.materials[static_cast<std::size_t>(particles.material[p])])
                                 ? particles.pore_pressure[p] + static_water_pressure(column, y)
                                 : 0.0;
        error = std::max(error, std::abs(found - still) / (4.0 * weight_of_water));
    }
    return error;
}

TEST(FreeFieldFlow, DoesNotPassASideWithoutAHead)
{
    const AssembledCase level = dike({}), walls = dike({"soil = \"roller\"\n", "", "0.0", false});
    EXPECT_NEAR(level.initial_flow->discharge, walls.initial_flow->discharge,
                1e-9 * walls.initial_flow->discharge);
    EXPECT_LT(column_error(level, 0, 2.0), 0.03);
    EXPECT_LT(column_error(level, 1, 0.0), 0.03);
}

TEST(FreeFieldFlow, PassesASideWithAHead)
{
    const AssembledCase held = dike(with_held_level());
    const auto& faces = held.initial_flow->faces;
    const auto side = std::find_if(faces.begin(), faces.end(),
                                   [](const FaceFlow& face) { return face.name == "land_side"; });
    ASSERT_NE(side, faces.end());
    EXPECT_LT(side->inflow, -0.2 * held.initial_flow->discharge);
    EXPECT_LT(column_error(held, 1, -1.0), 0.03);
}

TEST(FreeFieldFlow, IsMirroredWithTheDrawing)
{
    Drawing drawing = with_held_level();
    const AssembledCase one = dike(drawing);
    drawing.mirrored = true;
    const AssembledCase other = dike(drawing);
    EXPECT_NEAR(one.initial_flow->discharge, other.initial_flow->discharge,
                0.01 * one.initial_flow->discharge);
    const auto weight = [](const AssembledCase& drawn, std::size_t field) {
        double sum = 0.0;
        for (const double mass : drawn.state.free_fields[field].column.particles.mass_solid) sum += mass;
        return sum;
    };
    EXPECT_NEAR(weight(one, 0), weight(other, 1), 1e-9 * weight(one, 0));
    EXPECT_NEAR(weight(one, 1), weight(other, 0), 1e-9 * weight(one, 1));
}

double velocity_after_settling(const Drawing& drawing)
{
    AssembledCase drawn = dike(drawing);
    relax(drawn.problem, *drawn.scene.relaxation, drawn.state, {}, {});
    run(drawn.problem, 0.5, {}, drawn.state);
    return largest_speed_of_grains(drawn.state.particles);
}

// Where the level is held the line of the flow falls towards the side, and is level over its last cells.
TEST(FreeFieldFlow, RestsBesideItsColumnsAsBetweenWalls)
{
    const double walls = velocity_after_settling({"soil = \"roller\"\n", "", "0.0", false});
    EXPECT_LT(walls, 2e-5); // measured 1.2e-5
    EXPECT_LT(velocity_after_settling({}), 1.1 * walls);
    EXPECT_LT(velocity_after_settling(with_held_level()), 3e-5); // measured 2.4e-5
}

} // namespace
} // namespace quicksand
