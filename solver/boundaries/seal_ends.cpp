#include "solver/boundaries/seal_ends.hpp"

#include "solver/boundaries/wall_nodes.hpp"

#include <algorithm>

namespace quicksand {

namespace {

constexpr double too_long = 0.5;     // [cells]
constexpr double most = 0.25;        // of the seal's length
constexpr double least_cosine = 0.5; // of the turn from the seal to the edge beyond; in sharper corners
                                     // nothing acts too far

enum class Beyond { nothing, drained, closed };

/// The edge beyond the end of a seal.
Beyond beyond_end(const Problem& problem, const Segment& seal, bool forward, Stage stage)
{
    const double tolerance = on_wall * problem.grid.cell_size;
    const Vector2 along = (seal.end - seal.start).normalized();
    Beyond beyond = Beyond::nothing;
    const auto meet = [&](const Segment& other, bool drains) {
        const Vector2 gap = forward ? other.start - seal.end : other.end - seal.start;
        if (gap.norm() > tolerance || beyond == Beyond::closed) return;
        const bool goes_on = along.dot((other.end - other.start).normalized()) > least_cosine;
        if (!drains)
            beyond = Beyond::closed;
        else if (goes_on)
            beyond = Beyond::drained;
    };
    for (const Boundary& boundary : problem.boundaries)
        for (const Segment& other : boundary.segments)
            meet(other,
                 !lies_in_soil(boundary.soil) && hold_of(boundary, other, stage).water == WaterHold::none);
    for (const Segment& edge : unnamed_edges(problem)) meet(edge, true);
    return beyond;
}

} // namespace

double drained_end(const Problem& problem, const Segment& segment, bool forward, double length, Stage stage)
{
    if (beyond_end(problem, segment, forward, stage) != Beyond::drained) return 0.0;
    return std::min(too_long * problem.grid.cell_size, most * length);
}

} // namespace quicksand
