#include "io/frames/grid_frame.hpp"

#include "io/frames/frame_array.hpp"

#include <array>
#include <utility>

namespace quicksand {

namespace {

constexpr std::int64_t unused = -1;

/// The used nodes and their new numbers.
struct Renumbering {
    std::vector<std::size_t> nodes;   // in the order of their new numbers
    std::vector<std::int64_t> number; // of every node of the grid, `unused` for the others

    std::int64_t take(std::size_t node)
    {
        if (number[node] == unused) {
            number[node] = static_cast<std::int64_t>(nodes.size());
            nodes.push_back(node);
        }
        return number[node];
    }
};

/// Nodes of the cell with lower left node (i, j), counter-clockwise.
std::array<std::size_t, 4> cell_nodes(const BackgroundGrid& grid, int i, int j)
{
    const auto row = static_cast<std::size_t>(grid.nodes_x());
    const std::size_t lower_left = static_cast<std::size_t>(j) * row + static_cast<std::size_t>(i);
    return {lower_left, lower_left + 1, lower_left + row + 1, lower_left + row};
}

Renumbering add_cells(const BackgroundGrid& grid, const Scalars& volume, Frame& frame)
{
    Renumbering renumbering{{}, std::vector<std::int64_t>(grid.node_count(), unused)};
    for (int j = 0; j < grid.all_cells_y(); ++j) {
        for (int i = 0; i < grid.all_cells_x(); ++i) {
            const auto nodes = cell_nodes(grid, i, j);
            bool active = true;
            for (const std::size_t node : nodes) active = active && volume[node] > 0.0;
            if (!active) continue;
            std::array<std::int64_t, 4> quad{};
            for (std::size_t k = 0; k < 4; ++k) quad[k] = renumbering.take(nodes[k]);
            frame.cells.add(quad);
        }
    }
    return renumbering;
}

/// The values of a quantity at the nodes that are used; vectors have z = 0.
FrameArray nodal_array(const NodalField& field, const std::vector<std::size_t>& nodes)
{
    FrameArray array = frame_array(*field.quantity);
    const std::size_t width = array.component_count();
    std::vector<double> taken(width * nodes.size(), 0.0);
    for (std::size_t c = 0; c < field.components.size(); ++c)
        for (std::size_t k = 0; k < nodes.size(); ++k) taken[width * k + c] = field.components[c][nodes[k]];
    array.values = std::move(taken);
    return array;
}

FrameArray volume_array(const Scalars& volume, const std::vector<std::size_t>& nodes)
{
    std::vector<double> taken;
    taken.reserve(nodes.size());
    for (const std::size_t node : nodes) taken.push_back(volume[node]);
    return {"soil_volume", "m3/m", {}, std::move(taken)};
}

} // namespace

Frame grid_frame(const Problem& problem, const NodalFields& fields, double time)
{
    Frame frame;
    frame.time = time;
    const std::vector<std::size_t> nodes = add_cells(problem.grid, fields.volume, frame).nodes;
    std::vector<std::int32_t> identifiers;
    for (const std::size_t node : nodes) {
        frame.points.push_back(problem.grid.node_position(node));
        identifiers.push_back(static_cast<std::int32_t>(node));
    }
    for (const NodalField& field : fields.fields) frame.point_data.push_back(nodal_array(field, nodes));
    frame.point_data.push_back(volume_array(fields.volume, nodes));
    frame.point_data.push_back({"node_id", "-", {}, std::move(identifiers)});
    return frame;
}

} // namespace quicksand
