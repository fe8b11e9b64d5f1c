#include "io/frames/grid_frame.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace quicksand {

TEST(GridFrame, IsTheConnectedGridOfTheActiveCells)
{
    const Problem problem = fixtures::small_problem(true);
    const Frame frame =
        grid_frame(problem, nodal_fields(problem, fixtures::small_state(problem).particles), 0.5);
    EXPECT_EQ(frame.time, 0.5);
    EXPECT_EQ(frame.cells.size(), 12u);
    EXPECT_EQ(frame.points.size(), 20u);
    for (std::size_t cell = 0; cell < frame.cells.size(); ++cell) {
        const auto quad = frame.cells[cell];
        ASSERT_EQ(quad.size(), 4u);
        const Vector2 diagonal =
            frame.points[static_cast<std::size_t>(quad[2])] - frame.points[static_cast<std::size_t>(quad[0])];
        EXPECT_EQ(diagonal, Vector2(0.5, 0.5));
    }
}

TEST(GridFrame, CarriesNodalValuesAndNodeNumbers)
{
    const Problem problem = fixtures::small_problem(true);
    const NodalFields fields = nodal_fields(problem, fixtures::small_state(problem).particles);
    const Frame frame = grid_frame(problem, fields, 0.0);
    const auto& nodes = std::get<std::vector<std::int32_t>>(frame.point_data.back().values);
    EXPECT_EQ(frame.point_data.back().name, "node_id");
    for (const FrameArray& array : frame.point_data) {
        if (array.name != "vertical_effective_stress") continue;
        const auto& values = std::get<std::vector<double>>(array.values);
        for (std::size_t k = 0; k < nodes.size(); ++k)
            EXPECT_EQ(
                values[k],
                fields.find("vertical_effective_stress")->components[0][static_cast<std::size_t>(nodes[k])]);
    }
    for (std::size_t k = 0; k < nodes.size(); ++k)
        EXPECT_EQ(frame.points[k], problem.grid.node_position(static_cast<std::size_t>(nodes[k])));
}

TEST(GridFrame, LeavesOutTheWaterOfADryScene)
{
    const Problem problem = fixtures::small_problem(false);
    const Frame frame =
        grid_frame(problem, nodal_fields(problem, fixtures::small_state(problem).particles), 0.0);
    for (const FrameArray& array : frame.point_data) {
        EXPECT_NE(array.name, "pore_pressure");
        EXPECT_NE(array.name, "ru");
    }
}

} // namespace quicksand
