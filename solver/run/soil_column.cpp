#include "solver/run/soil_column.hpp"

#include "solver/base/failure.hpp"
#include "solver/motion/body_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace quicksand {

namespace {

constexpr double close = 1e-9;       // places that are the same [cells or m]
constexpr double same_value = 1e-10; // of the largest of an array

/// A place within its column, in millionths of a cell: rounding does not tell two columns apart.
using Place = std::pair<std::int64_t, std::int64_t>;

/// How the particles of a body lie in its columns.
struct Columns {
    double left = 0.0;  // x of the first column [m]
    double width = 0.0; // of a column, a cell [m]
    int count = 0;
    std::vector<int> column;            // of every particle
    std::vector<std::size_t> source;    // of every particle: the one in the first column at its place
    std::vector<std::size_t> particles; // of the first column

    double shift(std::size_t p) const { return column[p] * width; }
};

Place place_in_column(const Problem& problem, const Columns& columns, const Vector2& x, int column)
{
    const double scale = 1e6 / columns.width;
    return {std::llround((x.y() - problem.grid.origin.y()) * scale),
            std::llround((x.x() - columns.left - column * columns.width) * scale)};
}

/// Whether every column has particles at the places of the first one; fills in what repeats where.
bool match_particles(const Problem& problem, const Particles& particles, Columns& columns)
{
    const std::size_t count = particles.size();
    columns.column.resize(count);
    columns.source.resize(count);
    std::map<Place, std::size_t> first_column;
    for (std::size_t p = 0; p < count; ++p) {
        const double cells = (particles.position.x[p] - columns.left) / columns.width;
        if (!(cells > -close && cells < columns.count + close)) return false;
        const int column = std::clamp(static_cast<int>(std::floor(cells + close)), 0, columns.count - 1);
        columns.column[p] = column;
        if (column > 0) continue;
        columns.particles.push_back(p);
        if (!first_column.emplace(place_in_column(problem, columns, particles.position[p], 0), p).second)
            return false;
    }
    std::vector<int> repeats(count, 0);
    for (std::size_t p = 0; p < count; ++p) {
        const auto source =
            first_column.find(place_in_column(problem, columns, particles.position[p], columns.column[p]));
        if (source == first_column.end()) return false;
        columns.source[p] = source->second;
        ++repeats[source->second];
    }
    return std::all_of(columns.particles.begin(), columns.particles.end(),
                       [&](std::size_t p) { return repeats[p] == columns.count; });
}

/// Whether every particle carries what its source does.
bool values_repeat(const Particles& particles, const Columns& columns)
{
    bool repeat = true;
    for_each_index_array(particles, [&](std::string_view name, const std::vector<std::int32_t>& values) {
        if (name == "identifier") return;
        for (std::size_t p = 0; p < values.size(); ++p)
            repeat = repeat && values[p] == values[columns.source[p]];
    });
    for_each_array(particles, [&](std::string_view name, const Scalars& values) {
        const bool is_place = name == "position_x" || name == "reference_position_x";
        double size = is_place ? columns.width : 0.0;
        for (const double value : values) size = std::max(size, is_place ? 0.0 : std::abs(value));
        for (std::size_t p = 0; p < values.size(); ++p) {
            const double expected = values[columns.source[p]] + (is_place ? columns.shift(p) : 0.0);
            repeat = repeat && std::abs(values[p] - expected) <= same_value * size;
        }
    });
    return repeat;
}

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

/// The pieces of the first column, carried by its new numbers; none when those of another column differ.
std::optional<std::vector<BoundaryPiece>> narrow_pieces(const std::vector<BoundaryPiece>& pieces,
                                                        const Particles& particles, const Columns& columns)
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
        narrow.back().identifier = number.at(p);
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

void narrow_problem(Problem& problem)
{
    for (Boundary& boundary : problem.boundaries)
        if (!boundary.segments.empty()) boundary = narrow_curve(problem, boundary);
    TiedSides& sides = *problem.tied_sides;
    sides.x_right = sides.x_left + problem.grid.cell_size;
    sides.wraps = true;
    problem.grid.origin.x() = sides.x_left;
    problem.grid.cells_x = 1;
}

} // namespace

ColumnSearch find_soil_column(const Problem& problem, const State& state)
{
    ColumnSearch search;
    if (!problem.tied_sides) return search;
    const double h = problem.grid.cell_size;
    Columns columns;
    columns.left = problem.tied_sides->x_left;
    columns.width = h;
    columns.count = static_cast<int>(std::lround((problem.tied_sides->x_right - columns.left) / h));
    search.obstacle = obstacle_of(problem);
    if (!search.obstacle.empty()) return search;
    const Particles& particles = state.particles;
    if (!match_particles(problem, particles, columns) || !values_repeat(particles, columns)) {
        search.obstacle = "the soil does not repeat from cell to cell";
        return search;
    }
    SoilColumn column{problem, state, columns.count, {}, particles.identifier, {}, {}};
    for (Boundary& boundary : column.problem.boundaries) {
        auto pieces = narrow_pieces(boundary.pieces, particles, columns);
        if (!pieces) {
            search.obstacle = "what acts on the curve \"" + boundary.name + "\" differs from cell to cell";
            return search;
        }
        boundary.pieces = std::move(*pieces);
        boundary.holders.clear(); // of particles that the column may not have
    }
    if (!take_part(particles, columns.particles, column.problem.cut_domains)) {
        search.obstacle = "thin pieces of soil are carried by the column beside theirs";
        return search;
    }
    narrow_problem(column.problem);
    column.state.particles = part_of(particles, columns.particles);
    column.drawn_x = column.state.particles.position.x;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const auto source =
            std::lower_bound(columns.particles.begin(), columns.particles.end(), columns.source[p]);
        column.source.push_back(static_cast<std::int32_t>(source - columns.particles.begin()));
        column.shift.push_back(columns.shift(p));
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
    const double width = column.problem.grid.cell_size;
    for (std::size_t p = 0; p < count; ++p) {
        // the reference moved with the soil whenever it came in by the other side
        const double drawn = column.drawn_x[static_cast<std::size_t>(column.source[p])];
        const double turns = std::round((to.reference_position.x[p] - drawn) / width);
        to.position.x[p] += column.shift[p] - turns * width;
        to.reference_position.x[p] += column.shift[p] - turns * width;
    }
    wide.stage = narrow.stage;
    wide.time = narrow.time;
    wide.step = narrow.step;
    wide.last_step = narrow.last_step;
    wide.whole_step = narrow.whole_step;
    wide.step_scale = narrow.step_scale;
    wide.step_halvings = narrow.step_halvings;
    wide.times_halved = narrow.times_halved;
    wide.explicit_end = narrow.explicit_end;
    wide.balance_terms = narrow.balance_terms;
    if (wide.balance_terms)
        for_each_number(*wide.balance_terms, [&](const char*, double& value) { value *= column.columns; });
}

} // namespace quicksand
