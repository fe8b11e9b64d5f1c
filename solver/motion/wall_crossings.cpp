#include "solver/motion/wall_crossings.hpp"

#include "solver/base/threads.hpp"
#include "solver/boundaries/wall_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

/// A wall that is parallel to the grid.
struct AlignedWall {
    double line;        // along the normal's axis [m]
    double side;        // 1 or -1: that of the normal
    double first, last; // along the other axis [m]
};

AlignedWall aligned_wall(const Segment& segment, int axis)
{
    const double a = segment.start[1 - axis], b = segment.end[1 - axis];
    return {segment.start[axis], outward_normal(segment)[axis], std::min(a, b), std::max(a, b)};
}

/// x and v along the wall's normal, y along the wall. The line counts as before the wall.
void stop_at_wall(const AlignedWall& wall, double dt, double inside, const Scalars& v, const Scalars& y,
                  Scalars& x)
{
    for_each_chunk(x.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
            const double beyond = wall.side * (x[p] - wall.line), before = beyond - dt * wall.side * v[p];
            const bool crosses = beyond > 0.0 && before <= 0.0 && y[p] >= wall.first && y[p] <= wall.last;
            x[p] = crosses ? wall.line - inside * wall.side : x[p];
        }
    });
}

} // namespace

void stop_at_walls(const Problem& problem, double dt, const Vectors& grid_velocity, Particles& particles)
{
    const double inside = on_wall * problem.grid.cell_size;
    Vectors& position = particles.position;
    for (const Boundary& boundary : problem.boundaries) {
        if (!is_standing_wall(boundary.soil)) continue;
        for (const Segment& segment : boundary.segments) {
            if (!holds_nodes(problem, boundary, segment)) continue;
            const int axis = normal_axis(segment);
            const AlignedWall wall = aligned_wall(segment, axis);
            if (axis == 0)
                stop_at_wall(wall, dt, inside, grid_velocity.x, position.y, position.x);
            else
                stop_at_wall(wall, dt, inside, grid_velocity.y, position.x, position.y);
        }
    }
}

} // namespace quicksand
