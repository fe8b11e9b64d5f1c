#include "solver/motion/wall_crossings.hpp"

#include "solver/base/lanes.hpp"
#include "solver/base/threads.hpp"
#include "solver/boundaries/wall_nodes.hpp"

#include <algorithm>
#include <cstdint>

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
VECTOR_KERNEL
void stop_chunk(const AlignedWall& wall, double dt, double stop, std::size_t first, std::size_t last,
                const double* v, const double* y, double* x)
{
    std::int64_t any = 0; // as a rule none
    for (std::size_t p = first; p < last; ++p)
        any |= static_cast<std::int64_t>(wall.side * (x[p] - wall.line) > 0.0);
    if (any == 0) return;
#pragma GCC ivdep // the arrays do not overlap
    for (std::size_t p = first; p < last; ++p) {
        const double beyond = wall.side * (x[p] - wall.line), before = beyond - dt * wall.side * v[p];
        const bool crosses =
            (beyond > 0.0) & (before <= 0.0) & (y[p] >= wall.first) & (y[p] <= wall.last); // no branches
        x[p] = crosses ? stop : x[p];
    }
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
            const double stop = wall.line - inside * wall.side;
            const Scalars& v = axis == 0 ? grid_velocity.x : grid_velocity.y;
            const Scalars& y = axis == 0 ? position.y : position.x;
            Scalars& x = axis == 0 ? position.x : position.y;
            for_each_chunk(x.size(), [&](std::size_t first, std::size_t last) {
                stop_chunk(wall, dt, stop, first, last, v.data(), y.data(), x.data());
            });
        }
    }
}

} // namespace quicksand
