#include "solver/columns/soil_column.hpp"

#include "solver/columns/equal_columns.hpp"
#include "solver/motion/body_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace quicksand {

namespace {

constexpr double close = 1e-9; // places that are the same [cells or m]

bool is_tied_side(const TiedSides& sides, const Boundary& boundary)
{
    return boundary.name == sides.left || boundary.name == sides.right;
}

/// Whether the segments of a curve make up one level line from side to side.
bool spans_the_width(const Problem& problem, const Boundary& boundary)
{
    const double tolerance = close * problem.grid.cell_size;
    const double left = problem.tied_sides->x_left, right = problem.tied_sides->x_right;
    double length = 0.0;
    for (const Segment& segment : boundary.segments) {
        const double y = boundary.segments.front().start.y();
        for (const Vector2& end : {segment.start, segment.end}) {
            if (std::abs(end.y() - y) > tolerance || end.x() < left - tolerance ||
                end.x() > right + tolerance)
                return false;
        }
        length += std::abs(segment.end.x() - segment.start.x());
    }
    return std::abs(length - (right - left)) <= tolerance;
}

/// The curve as the column has it.
Boundary narrow_curve(const Problem& problem, const Boundary& boundary)
{
    const double left = problem.tied_sides->x_left;
    Boundary narrow = boundary;
    if (is_tied_side(*problem.tied_sides, boundary)) {
        for (Segment& segment : narrow.segments) {
            if (boundary.name != problem.tied_sides->right) continue;
            segment.start.x() = segment.end.x() = left + problem.grid.cell_size;
        }
        return narrow;
    }
    const Segment& first = boundary.segments.front();
    Segment whole{{left, first.start.y()}, {left + problem.grid.cell_size, first.start.y()}};
    if (first.end.x() < first.start.x()) std::swap(whole.start, whole.end);
    narrow.segments = {whole};
    return narrow;
}

/// What tells two pieces of a curve apart, beside their particle [-] and [m].
using PieceShape = std::array<double, 5>;

PieceShape shape_of(const BoundaryPiece& piece)
{
    return {piece.start.x(), piece.start.y(), piece.end.x(), piece.end.y(), piece.length};
}

/// The pieces of the first column, carried by the new numbers of those that stand for its particles; none
/// when those of another column differ.
std::optional<std::vector<BoundaryPiece>> narrow_pieces(const std::vector<BoundaryPiece>& pieces,
                                                        const Particles& particles,
                                                        const EqualColumns& columns)
{
    std::map<std::int32_t, std::size_t> index;
    for (std::size_t p = 0; p < particles.size(); ++p) index[particles.identifier[p]] = p;
    std::map<std::size_t, std::int32_t> number;
    for (const std::size_t p : columns.particles) number.emplace(p, static_cast<std::int32_t>(number.size()));

    std::vector<BoundaryPiece> narrow;
    std::vector<std::vector<std::pair<std::size_t, PieceShape>>> shapes(
        static_cast<std::size_t>(columns.count));
    for (const BoundaryPiece& piece : pieces) {
        const std::size_t p = index.at(piece.identifier);
        const auto column = static_cast<std::size_t>(columns.column[p]);
        shapes[column].emplace_back(columns.source[p], shape_of(piece));
        if (column > 0) continue;
        narrow.push_back(piece);
        narrow.back().identifier = number.at(columns.source[p]);
    }
    // beside one particle the pieces follow each other along the curve
    const auto by_source = [](const auto& a, const auto& b) { return a.first < b.first; };
    for (auto& list : shapes) std::stable_sort(list.begin(), list.end(), by_source);
    for (const auto& list : shapes) {
        if (list.size() != shapes.front().size()) return std::nullopt;
        for (std::size_t k = 0; k < list.size(); ++k) {
            bool same = list[k].first == shapes.front()[k].first;
            for (std::size_t n = 0; n < list[k].second.size(); ++n)
                same = same && std::abs(list[k].second[n] - shapes.front()[k].second[n]) <= close;
            if (!same) return std::nullopt;
        }
    }
    return narrow;
}

/// What about the curves and the forces keeps columns apart, "" when nothing does.
std::string obstacle_of(const Problem& problem)
{
    if (problem.body_acceleration) return "the body force varies from place to place";
    if (!problem.cut_domains.shapes.empty()) return "an outline that is not level cuts particles";
    for (const Boundary& boundary : problem.boundaries) {
        if (boundary.segments.empty() || is_tied_side(*problem.tied_sides, boundary)) continue;
        if (moves(boundary.soil)) return "the curve \"" + boundary.name + "\" moves";
        if (!spans_the_width(problem, boundary))
            return "the curve \"" + boundary.name + "\" is no level line from side to side";
    }
    return "";
}

/// `length` particles side by side drift in and out of the column one by one.
void narrow_problem(int length, Problem& problem)
{
    for (Boundary& boundary : problem.boundaries)
        if (!boundary.segments.empty()) boundary = narrow_curve(problem, boundary);
    TiedSides& sides = *problem.tied_sides;
    sides.x_right = sides.x_left + problem.grid.cell_size;
    sides.period = problem.grid.cell_size / length;
    problem.grid.origin.x() = sides.x_left;
    problem.grid.cells_x = 1;
}

/// Volumes and masses are those of all particles for which one stands: `factor` of them.
void scale_amounts(double factor, Particles& particles)
{
    for (Scalars* amounts : {&particles.volume, &particles.mass_solid, &particles.water_volume})
        for (double& amount : *amounts) amount *= factor;
}

/// The particles that stand for others, in the middle of those of the first column.
Particles stand_ins(const Particles& particles, const EqualColumns& columns)
{
    Particles part = part_of(particles, columns.particles);
    const double to_middle = 0.5 * columns.width * (1.0 - 1.0 / columns.row_length);
    if (columns.row_length > 1)
        for (Scalars* x : {&part.position.x, &part.reference_position.x})
            for (double& place : *x) place += to_middle;
    scale_amounts(columns.row_length, part);
    return part;
}

} // namespace

ColumnSearch find_soil_column(const Problem& problem, const State& state)
{
    ColumnSearch search;
    if (!problem.tied_sides) return search;
    search.obstacle = obstacle_of(problem);
    if (!search.obstacle.empty()) return search;
    const Particles& particles = state.particles;
    std::optional<EqualColumns> columns = find_equal_columns(problem, particles);
    if (!columns) {
        search.obstacle = "the soil does not repeat from cell to cell";
        return search;
    }
    if (problem.cut_domains.slivers.empty()) join_rows(particles, *columns);
    SoilColumn column{
        problem, state, columns->count, columns->row_length, {}, particles.identifier, particles.position.x};
    for (Boundary& boundary : column.problem.boundaries) {
        auto pieces = narrow_pieces(boundary.pieces, particles, *columns);
        if (!pieces) {
            search.obstacle = "what acts on the curve \"" + boundary.name + "\" differs from cell to cell";
            return search;
        }
        boundary.pieces = std::move(*pieces);
        boundary.holders.clear(); // of particles that the column may not have
    }
    if (!take_part(particles, columns->particles, column.problem.cut_domains)) {
        search.obstacle = "thin pieces of soil are carried by the column beside theirs";
        return search;
    }
    narrow_problem(columns->row_length, column.problem);
    column.state.particles = stand_ins(particles, *columns);
    for (const std::size_t p : columns->source) {
        const auto source = std::lower_bound(columns->particles.begin(), columns->particles.end(), p);
        column.source.push_back(static_cast<std::int32_t>(source - columns->particles.begin()));
    }
    search.column = std::move(column);
    return search;
}

void widen(const SoilColumn& column, const State& narrow, State& wide)
{
    const Particles& from = narrow.particles;
    Particles& to = wide.particles;
    const std::size_t count = column.source.size();
    std::vector<std::int32_t> place(from.size());
    for (std::size_t p = 0; p < from.size(); ++p)
        place[static_cast<std::size_t>(from.identifier[p])] = static_cast<std::int32_t>(p);
    std::vector<std::size_t> source(count);
    for (std::size_t p = 0; p < count; ++p)
        source[p] = static_cast<std::size_t>(place[static_cast<std::size_t>(column.source[p])]);

    const auto repeat = [&](const auto& values, auto& repeated) {
        repeated.resize(values.empty() ? 0 : count);
        for (std::size_t p = 0; p < repeated.size(); ++p) repeated[p] = values[source[p]];
    };
    std::vector<const Scalars*> arrays;
    for_each_array(from, [&](const char*, const Scalars& values) { arrays.push_back(&values); });
    to.memory.resize(from.memory.size());
    std::size_t k = 0;
    for_each_array(to, [&](const char*, Scalars& values) { repeat(*arrays[k++], values); });
    repeat(from.material, to.material);
    repeat(from.region, to.region);
    to.identifier = column.identifier;
    scale_amounts(1.0 / column.row_length, to);
    for (std::size_t p = 0; p < count; ++p) { // the reference moved whenever soil came in by the other side
        to.position.x[p] += column.drawn_x[p] - to.reference_position.x[p];
        to.reference_position.x[p] = column.drawn_x[p];
    }
    wide.stage = narrow.stage;
    wide.time = narrow.time;
    wide.step = narrow.step;
    wide.stages_before = narrow.stages_before;
    wide.last_step = narrow.last_step;
    wide.whole_step = narrow.whole_step;
    wide.step_scale = narrow.step_scale;
    wide.implicit_cost = narrow.implicit_cost;
    wide.step_halvings = narrow.step_halvings;
    wide.times_halved = narrow.times_halved;
    wide.explicit_end = narrow.explicit_end;
    wide.balance_terms = narrow.balance_terms;
    if (wide.balance_terms)
        for_each_number(*wide.balance_terms, [&](const char*, double& value) { value *= column.columns; });
}

} // namespace quicksand
