#include "solver/walls/wall_chains.hpp"

#include "solver/base/cross_product.hpp"
#include "solver/boundaries/seal_ends.hpp"
#include "solver/boundaries/wall_nodes.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace quicksand {

namespace {

constexpr double hat_spacing = 2.5; // [cells]

/// A segment that becomes a part of a chain.
struct Link {
    WallHold hold;
    ChainEdge edge;
    std::size_t
        owner; // the boundary that a chain has to keep to: of walls that move or will let go; none otherwise
};

constexpr std::size_t none = static_cast<std::size_t>(-1);

Vector2 direction_of(const Segment& segment)
{
    return (segment.end - segment.start).normalized();
}

double length_of(const Segment& segment)
{
    return (segment.end - segment.start).norm();
}

/// Whether the wall goes on from one segment to the next: a turn below 45 degrees, one condition, one motion.
bool goes_on(const Link& from, const Link& to, double tolerance)
{
    if ((to.edge.drawn.start - from.edge.drawn.end).norm() > tolerance) return false;
    if (!(from.hold == to.hold) || from.owner != to.owner) return false;
    constexpr double rounding = 1e-9; // of a turn of 45 degrees, which ends the wall wherever it is drawn
    const double cosine = direction_of(from.edge.drawn).dot(direction_of(to.edge.drawn));
    return cosine > std::numbers::sqrt2 / 2.0 + rounding;
}

std::vector<Link> collect_links(const Problem& problem, Stage stage)
{
    std::vector<Link> links;
    for (std::size_t b = 0; b < problem.boundaries.size(); ++b) {
        const Boundary& boundary = problem.boundaries[b];
        for (std::size_t s = 0; s < boundary.segments.size(); ++s) {
            const Segment& segment = boundary.segments[s];
            const WallHold hold = hold_of(boundary, segment, stage);
            if (!hold.any() || holds_nodes(problem, boundary, segment)) continue;
            const bool alone = moves(boundary.soil) || lets_go(boundary.soil);
            links.push_back({hold, {segment, 0.0, b, s}, alone ? b : none});
        }
    }
    return links;
}

/// For every link the one that follows it, and the one before.
struct Order {
    std::vector<std::size_t> next, before;
};

Order order_links(const std::vector<Link>& links, double tolerance)
{
    Order order{std::vector<std::size_t>(links.size(), none), std::vector<std::size_t>(links.size(), none)};
    for (std::size_t a = 0; a < links.size(); ++a) {
        for (std::size_t b = 0; b < links.size(); ++b) {
            if (a == b || order.before[b] != none || !goes_on(links[a], links[b], tolerance)) continue;
            order.next[a] = b;
            order.before[b] = a;
            break;
        }
    }
    return order;
}

/// Whether soil may come to lie beyond an end of a wall: the edge that goes on there turns to the soil and is
/// no wall.
bool is_open_end(const Problem& problem, const Segment& wall, bool forward)
{
    const double tolerance = on_wall * problem.grid.cell_size;
    if (!std::isinf(reach_past(problem, wall, forward ? wall.end : wall.start))) return false;
    for (const Boundary& boundary : problem.boundaries) {
        for (const Segment& other : boundary.segments) {
            const Vector2 gap = forward ? other.start - wall.end : other.end - wall.start;
            if (gap.norm() > tolerance) continue;
            if (lies_in_soil(boundary.soil)) return false;
            if (hold_of(boundary, other, Stage::relaxation).grains != GrainHold::none) return false;
        }
    }
    return true;
}

/// How far the void goes on straight beyond an end of a wall, within the grid [m].
double room_beyond(const Problem& problem, const Segment& wall, bool forward)
{
    if (!is_open_end(problem, wall, forward)) return 0.0;
    const BackgroundGrid& grid = problem.grid;
    const Vector2 start = forward ? wall.end : wall.start;
    const Vector2 along = forward ? direction_of(wall) : Vector2(-direction_of(wall));
    const Vector2 lower = grid.origin - Vector2::Constant(grid.cell_size),
                  upper = grid.upper_corner() + Vector2::Constant(grid.cell_size);
    double room = (upper - lower).sum();
    for (int axis = 0; axis < 2; ++axis) {
        if (along[axis] > 0.0) room = std::min(room, (upper[axis] - start[axis]) / along[axis]);
        if (along[axis] < 0.0) room = std::min(room, (lower[axis] - start[axis]) / along[axis]);
    }
    const double step = 0.5 * grid.cell_size;
    double free = 0.0;
    while (free + step <= room && !enters_soil(problem, start, along, free + step)) free += step;
    return std::max(0.0, free);
}

/// Let a chain go on beyond its start and its end, where it may.
void extend_ends(const Problem& problem, bool at_start, bool at_end, WallChain& chain)
{
    const ChainEdge front = chain.edges.front(), back = chain.edges.back();
    const double before = at_start ? room_beyond(problem, front.drawn, false) : 0.0,
                 after = at_end ? room_beyond(problem, back.drawn, true) : 0.0;
    if (before > 0.0) {
        const Vector2& end = front.drawn.start;
        const Segment beyond{end - before * direction_of(front.drawn), end};
        chain.edges.insert(chain.edges.begin(), {beyond, -before, front.boundary, front.segment, true});
        chain.first = -before;
    }
    if (after > 0.0) {
        const Vector2& end = back.drawn.end;
        chain.edges.push_back(
            {{end, end + after * direction_of(back.drawn)}, chain.last, back.boundary, back.segment, true});
        chain.last += after;
    }
}

/// The axis that a straight chain is parallel to, -1 without.
int parallel_axis(const WallChain& chain)
{
    const int normal = chain.straight ? normal_axis(chain.edges.front().drawn) : -1;
    return normal < 0 ? -1 : 1 - normal;
}

/// Whether a chain goes round, not from one tied side to the other.
bool is_ring(const WallChain& chain, double tolerance)
{
    return chain.closed &&
           (chain.edges.front().drawn.start - chain.edges.back().drawn.end).norm() < tolerance;
}

/// The arc length of a ring's highest place, or half a ring from it: half way between the ends of its highest
/// corners, which are beside the widest gap between two of them.
double highest_place(const WallChain& ring, double tolerance)
{
    const auto height = [](const ChainEdge& edge) { return edge.drawn.start.y(); };
    const auto is_lower = [&](const ChainEdge& a, const ChainEdge& b) { return height(a) < height(b); };
    const double top = height(*std::max_element(ring.edges.begin(), ring.edges.end(), is_lower));
    const auto is_top = [&](const ChainEdge& edge) { return height(edge) > top - tolerance; };
    std::vector<double> corners;
    for (const ChainEdge& edge : ring.edges)
        if (is_top(edge)) corners.push_back(edge.first);
    corners.push_back(corners.front() + ring.last);
    std::size_t widest = 1;
    for (std::size_t k = 2; k < corners.size(); ++k)
        if (corners[k] - corners[k - 1] > corners[widest] - corners[widest - 1] + tolerance) widest = k;
    return 0.5 * (corners[widest - 1] + corners[widest]);
}

/// Hats of a ring: an even number, one of them at its highest place and one half a ring from there, so that
/// they lie the same wherever and in whichever sense the ring is drawn, and mirrored on one that is mirrored.
void place_hats_on_ring(double wanted, double tolerance, WallChain& ring)
{
    const double pairs = std::max(2.0, std::round(0.5 * ring.last / wanted));
    ring.spacing = 0.5 * ring.last / pairs;
    ring.hats = 2 * static_cast<std::size_t>(pairs);
    ring.first_hat = std::fmod(highest_place(ring, tolerance), ring.spacing);
}

/// Hats at even distances over the drawn part, going on at the same distance beyond it. Along the grid the
/// nodes of a line across the wall are all that touch it there: each line has a hat of its own, and none
/// lock.
void place_hats(const BackgroundGrid& grid, double drawn_length, WallChain& chain)
{
    chain.line_axis = parallel_axis(chain);
    if (chain.line_axis >= 0) {
        chain.closed = false;
        chain.spacing = 1.0;
        chain.hats = static_cast<std::size_t>(chain.line_axis == 0 ? grid.nodes_x() : grid.nodes_y());
        return;
    }
    const double cell_size = grid.cell_size;
    const double wanted = hat_spacing * cell_size, tolerance = on_wall * cell_size;
    if (is_ring(chain, tolerance)) return place_hats_on_ring(wanted, tolerance, chain);
    const auto least = chain.closed ? 3.0 : 0.0;
    const double intervals = std::max(least, std::round(drawn_length / wanted));
    if (intervals == 0.0 && chain.last - chain.first < wanted) {
        chain.hats = 1;
        return;
    }
    chain.spacing = intervals == 0.0 ? wanted : drawn_length / intervals;
    // about a short edge from its middle, so that they lie in its mirror image as here
    const double from = intervals == 0.0 ? 0.5 * drawn_length : 0.0, to = drawn_length - from;
    const double before = std::ceil((from - chain.first) / chain.spacing - on_wall),
                 after = std::ceil((chain.last - to) / chain.spacing - on_wall);
    chain.first_hat = from - before * chain.spacing;
    const auto count = static_cast<std::size_t>(before + intervals + after);
    chain.hats = chain.closed ? count : count + 1;
}

/// Whether a chain goes from one tied side to the other: these are one place, so that its end is its start.
bool spans_tied_sides(const Problem& problem, const WallChain& chain)
{
    if (!problem.tied_sides) return false;
    const double tolerance = on_wall * problem.grid.cell_size;
    const auto ends = std::minmax(chain.edges.front().drawn.start.x(), chain.edges.back().drawn.end.x());
    return std::abs(ends.first - problem.tied_sides->x_left) < tolerance &&
           std::abs(ends.second - problem.tied_sides->x_right) < tolerance;
}

/// Take this length off one end of a line of edges; what is taken off goes to `others`.
void shorten(double length, bool forward, std::vector<ChainEdge>& edges, std::vector<Segment>& others)
{
    while (length > 0.0) {
        ChainEdge& edge = forward ? edges.back() : edges.front();
        const double whole = length_of(edge.drawn);
        if (whole > length) {
            const Vector2 step = length * direction_of(edge.drawn);
            Vector2& end = forward ? edge.drawn.end : edge.drawn.start;
            const Vector2 before = end;
            end += forward ? Vector2(-step) : step;
            others.push_back(forward ? Segment{end, before} : Segment{before, end});
            return;
        }
        others.push_back(edge.drawn);
        edges.erase(forward ? edges.end() - 1 : edges.begin());
        length -= whole;
    }
}

/// The edges of a chain in their order, and whether they go round.
std::vector<ChainEdge> follow_links(const std::vector<Link>& links, const Order& order, std::size_t first)
{
    std::vector<ChainEdge> edges;
    std::size_t k = first;
    do {
        edges.push_back(links[k].edge);
        k = order.next[k];
    } while (k != none && k != first);
    return edges;
}

double length_of(const std::vector<ChainEdge>& edges)
{
    double length = 0.0;
    for (const ChainEdge& edge : edges) length += length_of(edge.drawn);
    return length;
}

/// Films end before drained edges; returns whether this one does at its start and at its end.
std::pair<bool, bool> shorten_seal(const Problem& problem, Stage stage, WallChain& chain,
                                   std::vector<Segment>& others)
{
    if (chain.closed || chain.hold.water != WaterHold::with_grains) return {false, false};
    const double length = length_of(chain.edges);
    const double before = drained_end(problem, chain.edges.front().drawn, false, length, stage),
                 after = drained_end(problem, chain.edges.back().drawn, true, length, stage);
    shorten(before, false, chain.edges, others);
    shorten(after, true, chain.edges, others);
    return {before > 0.0, after > 0.0};
}

/// `others` gets what the chain leaves of its links.
WallChain make_chain(const Problem& problem, Stage stage, const std::vector<Link>& links, const Order& order,
                     std::size_t first, std::vector<Segment>& others)
{
    WallChain chain;
    chain.hold = links[first].hold;
    chain.closed = order.before[first] != none;
    chain.edges = follow_links(links, order, first);
    const auto [ends_before, ends_after] = shorten_seal(problem, stage, chain, others);
    constexpr double collinear = 1e-6; // sine [-]
    for (ChainEdge& edge : chain.edges) {
        edge.first = chain.last;
        chain.last += length_of(edge.drawn);
        chain.straight = chain.straight && std::abs(cross(direction_of(links[first].edge.drawn),
                                                          direction_of(edge.drawn))) < collinear;
    }
    const double drawn_length = chain.last;
    chain.closed = chain.closed || spans_tied_sides(problem, chain);
    if (!chain.closed) extend_ends(problem, !ends_before, !ends_after, chain);
    place_hats(problem.grid, drawn_length, chain);
    return chain;
}

std::vector<WallChain> make_chains(const Problem& problem, Stage stage, std::vector<Segment>& others)
{
    const std::vector<Link> links = collect_links(problem, stage);
    const Order order = order_links(links, on_wall * problem.grid.cell_size);
    std::vector<WallChain> chains;
    std::vector<bool> used(links.size(), false);
    const auto take = [&](std::size_t first) {
        chains.push_back(make_chain(problem, stage, links, order, first, others));
        for (std::size_t k = first; k != none && !used[k]; k = order.next[k]) used[k] = true;
    };
    for (std::size_t k = 0; k < links.size(); ++k)
        if (order.before[k] == none) take(k);
    for (std::size_t k = 0; k < links.size(); ++k) // what is left goes round
        if (!used[k]) take(k);
    return chains;
}

/// All edges of the soil that are in no chain; points on tied sides are inside the soil.
std::vector<Segment> other_edges(const Problem& problem, Stage stage)
{
    std::vector<Segment> others;
    for (const Boundary& boundary : problem.boundaries) {
        if (lies_in_soil(boundary.soil)) continue;
        for (const Segment& segment : boundary.segments) {
            const bool in_chain =
                hold_of(boundary, segment, stage).any() && !holds_nodes(problem, boundary, segment);
            if (!in_chain) others.push_back(segment);
        }
    }
    const std::vector<Segment> unnamed = unnamed_edges(problem);
    others.insert(others.end(), unnamed.begin(), unnamed.end());
    return others;
}

} // namespace

SoilEdges make_soil_edges(const Problem& problem, Stage stage)
{
    SoilEdges edges;
    edges.others = other_edges(problem, stage);
    edges.chains = make_chains(problem, stage, edges.others);
    return edges;
}

} // namespace quicksand
