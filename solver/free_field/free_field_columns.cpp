#include "solver/free_field/free_field_columns.hpp"

#include "solver/boundaries/free_field.hpp"
#include "solver/motion/body_part.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace quicksand {

namespace {

constexpr double close = 1e-6; // lengths that are the same [cells]
constexpr double slope = 0.1;  // by which heads may differ over a cell, that count as level [-]

constexpr const char* uneven = "the ground beside it is not level over the first column of cells";
constexpr const char* no_lattice = "the material points beside it do not fill the first column of cells";

/// The cells beside a side.
struct Strip {
    double left = 0.0, right = 0.0; // [m]
    double tolerance = 0.0;         // of places [m]
    std::vector<std::size_t> particles;

    double width() const { return right - left; }
};

/// Particles of one height.
struct Row {
    double width = 0.0; // of all together [m]
    std::size_t first = 0;
};

Strip strip_beside(const Problem& problem, const Particles& particles, double x, double outward)
{
    const double h = problem.grid.cell_size;
    Strip strip{outward < 0.0 ? x : x - h, outward < 0.0 ? x + h : x, close * h, {}};
    for (std::size_t p = 0; p < particles.size(); ++p)
        if (particles.position.x[p] > strip.left && particles.position.x[p] < strip.right)
            strip.particles.push_back(p);
    return strip;
}

/// Whether a scalar of the two particles differs by more than a tolerance.
bool differs(const Scalars& values, std::size_t p, std::size_t q, double tolerance)
{
    return !values.empty() && std::abs(values[p] - values[q]) > tolerance;
}

/// Whether two materials are one soil, below the phreatic line and above.
bool is_same_soil(const Problem& problem, std::int32_t a, std::int32_t b)
{
    const Material &first = problem.materials[static_cast<std::size_t>(a)],
                   &second = problem.materials[static_cast<std::size_t>(b)];
    return a == b || (first.saturated != second.saturated && first.porosity == second.porosity &&
                      first.hydraulic_conductivity == second.hydraulic_conductivity);
}

double largest_size(const Scalars& values)
{
    double size = 0.0;
    for (const double value : values) size = std::max(size, std::abs(value));
    return size;
}

/// What keeps the particles from being a level column, "" when nothing does.
std::string obstacle_of_soil(const Problem& problem, const Particles& particles, const Strip& strip)
{
    if (strip.particles.empty()) return no_lattice;
    const double scale = 1.0 / strip.tolerance;
    const double tilt =
        problem.water ? slope * problem.grid.cell_size * problem.water->density * problem.gravity : 0.0;
    const double pressure = std::max(tilt, close * largest_size(particles.pore_pressure)),
                 stress = tilt + close * largest_size(particles.stress.yy);
    std::map<std::int64_t, Row> rows;
    for (const std::size_t p : strip.particles) {
        const Vector2 e1 = particles.half_edge_1[p], e2 = particles.half_edge_2[p];
        const bool is_cut = problem.cut_domains.find(particles.identifier[p]) != nullptr;
        if (is_cut) return uneven;
        if (std::abs(e1.y()) > strip.tolerance || std::abs(e2.x()) > strip.tolerance) return no_lattice;
        const double x = particles.position.x[p];
        if (x - e1.x() < strip.left - strip.tolerance || x + e1.x() > strip.right + strip.tolerance)
            return no_lattice;
        Row& row = rows.emplace(std::llround(particles.position.y[p] * scale), Row{0.0, p}).first->second;
        row.width += 2.0 * e1.x();
        const std::size_t q = row.first;
        if (!is_same_soil(problem, particles.material[p], particles.material[q]))
            return "its layers are not level beside it";
        if (differs(particles.pore_pressure, p, q, pressure)) return "the water beside it is not level";
        if (differs(particles.stress.yy, p, q, stress)) return uneven;
    }
    for (const auto& [height, row] : rows)
        if (std::abs(row.width - strip.width()) > 10.0 * strip.tolerance) return uneven;
    return "";
}

/// Let every row have the water of its particle nearest to the side: what flows beside it has a line that is
/// not quite level.
void level_rows(double x, double tolerance, Particles& particles)
{
    std::map<std::int64_t, std::size_t> nearest;
    const auto row_of_particle = [&](std::size_t p) {
        return std::llround(particles.position.y[p] / tolerance);
    };
    for (std::size_t p = 0; p < particles.size(); ++p) {
        std::size_t& q = nearest.emplace(row_of_particle(p), p).first->second;
        if (std::abs(particles.position.x[p] - x) < std::abs(particles.position.x[q] - x)) q = p;
    }
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const std::size_t q = nearest.at(row_of_particle(p));
        particles.material[p] = particles.material[q];
        particles.mass_solid[p] = particles.mass_solid[q] * particles.volume[p] / particles.volume[q];
        for (Scalars* values : {&particles.stress.xx, &particles.stress.yy, &particles.stress.zz,
                                &particles.pore_pressure, &particles.water_table})
            if (!values->empty()) (*values)[p] = (*values)[q];
    }
}

/// The soil's height in the strip [m].
double height_of(const Particles& particles, const Strip& strip)
{
    double area = 0.0;
    for (const std::size_t p : strip.particles) area += particles.volume[p];
    return area / strip.width();
}

bool is_free_field(const Boundary& boundary)
{
    return std::holds_alternative<FreeFieldSide>(boundary.soil);
}

/// Height of the free-field sides at a place [m].
double height_of_sides(const Problem& problem, std::size_t field)
{
    double height = 0.0;
    for (const Boundary& boundary : problem.boundaries) {
        if (!is_free_field(boundary)) continue;
        for (const Segment& segment : boundary.segments)
            if (free_field_beyond(problem, segment) == field) height += (segment.end - segment.start).norm();
    }
    return height;
}

/// The parts of segments within the strip.
std::vector<Segment> within(const Strip& strip, const std::vector<Segment>& segments)
{
    std::vector<Segment> parts;
    for (const Segment& segment : segments) {
        Segment part = segment;
        part.start.x() = std::clamp(segment.start.x(), strip.left, strip.right);
        part.end.x() = std::clamp(segment.end.x(), strip.left, strip.right);
        if (std::abs(part.end.x() - part.start.x()) <= strip.tolerance) continue;
        parts.push_back(part);
    }
    return parts;
}

bool is_level(const std::vector<Segment>& segments, double tolerance)
{
    return std::all_of(segments.begin(), segments.end(), [&](const Segment& segment) {
        return std::abs(segment.end.y() - segment.start.y()) <= tolerance;
    });
}

/// A curve of the body in the column, with the pieces on the column's particles.
Boundary part_of_curve(const Boundary& boundary, const Strip& strip,
                       const std::map<std::int32_t, std::int32_t>& number)
{
    Boundary part{boundary.name, boundary.soil, boundary.water, within(strip, boundary.segments), {}};
    for (BoundaryPiece piece : boundary.pieces) {
        const auto found = number.find(piece.identifier);
        if (found == number.end()) continue;
        piece.identifier = found->second;
        part.pieces.push_back(piece);
    }
    return part;
}

/// The sides of the column, from the lowest to the highest of its soil.
void tie_sides(const Particles& particles, const Strip& strip, Problem& column)
{
    double lowest = particles.position.y[strip.particles.front()], highest = lowest;
    for (const std::size_t p : strip.particles) {
        lowest = std::min(lowest, particles.position.y[p] - particles.half_edge_2.y[p]);
        highest = std::max(highest, particles.position.y[p] + particles.half_edge_2.y[p]);
    }
    const Segment left{{strip.left, highest}, {strip.left, lowest}},
        right{{strip.right, lowest}, {strip.right, highest}};
    column.tied_sides = TiedSides{"left of the column", "right of the column", strip.left, strip.right,
                                  strip.right - strip.left};
    column.boundaries.push_back({column.tied_sides->left, TiedSide{}, Impervious{}, {left}, {}});
    column.boundaries.push_back({column.tied_sides->right, TiedSide{}, Impervious{}, {right}, {}});
    column.rim.push_back(left);
    column.rim.push_back(right);
}

/// The column of a strip; `what` says why there is none.
std::optional<Problem> cut_column(const Problem& problem, const Particles& particles, const Strip& strip,
                                  std::string& what)
{
    Problem column = problem;
    column.free_fields.clear();
    column.boundaries.clear();
    const auto number = numbers_in_part(particles, strip.particles);
    for (const Boundary& boundary : problem.boundaries) {
        const std::vector<Segment> parts = within(strip, boundary.segments);
        if (parts.empty()) continue;
        if (!is_level(parts, strip.tolerance)) {
            what = "the curve \"" + boundary.name + "\" is not level over the first column of cells";
            return std::nullopt;
        }
        if (moves(boundary.soil)) {
            what = "the curve \"" + boundary.name + "\" moves beside it";
            return std::nullopt;
        }
        column.boundaries.push_back(part_of_curve(boundary, strip, number));
    }
    column.rim = within(strip, problem.rim);
    if (!is_level(column.rim, strip.tolerance)) {
        what = uneven;
        return std::nullopt;
    }
    if (!take_part(particles, strip.particles, column.cut_domains)) {
        what = uneven;
        return std::nullopt;
    }
    tie_sides(particles, strip, column);
    column.grid.origin.x() = strip.left;
    column.grid.cells_x = 1;
    return column;
}

/// Why the free field has no column, "" when it has one now.
std::string add_column(Problem& problem, std::size_t k, State& state)
{
    const FreeField& field = problem.free_fields[k];
    const Particles& particles = state.particles;
    const Strip strip = strip_beside(problem, particles, field.x, field.outward);
    std::string what = obstacle_of_soil(problem, particles, strip);
    if (!what.empty()) return what;
    if (std::abs(height_of_sides(problem, k) - height_of(particles, strip)) > 1e-3 * problem.grid.cell_size)
        return "it does not bound all of the soil beside it, from the base to the surface";
    std::optional<Problem> column = cut_column(problem, particles, strip, what);
    if (!column) return what;
    State column_state = state;
    column_state.free_fields.clear();
    column_state.balance_terms.reset();
    column_state.reactions = {};
    column_state.particles = part_of(particles, strip.particles);
    level_rows(field.x, strip.tolerance, column_state.particles);
    problem.free_fields[k].column = std::move(*column);
    state.free_fields[k].column = std::move(column_state);
    return "";
}

} // namespace

std::vector<FreeFieldObstacle> add_free_fields(Problem& problem, State& state)
{
    std::vector<FreeFieldObstacle> obstacles;
    std::vector<std::string> curves; // of each place
    for (const Boundary& boundary : problem.boundaries) {
        if (!is_free_field(boundary)) continue;
        for (const Segment& segment : boundary.segments) {
            const double x = segment.start.x();
            const auto found = free_field_beyond(problem, segment);
            if (found && std::abs(problem.free_fields[*found].x - x) < 0.5 * problem.grid.cell_size) continue;
            problem.free_fields.push_back({x, outward_normal(segment).x() < 0.0 ? -1.0 : 1.0, {}});
            curves.push_back(boundary.name);
        }
    }
    state.free_fields.resize(problem.free_fields.size());
    for (std::size_t k = 0; k < problem.free_fields.size(); ++k) {
        const std::string what = add_column(problem, k, state);
        if (!what.empty()) obstacles.push_back({curves[k], what});
    }
    return obstacles;
}

} // namespace quicksand
