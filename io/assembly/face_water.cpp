#include "io/assembly/face_water.hpp"

#include "io/assembly/ground_water.hpp"
#include "io/keys/scene_schema.hpp"
#include "io/tables/scene_boundaries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

constexpr double edge_rounding = 1e-6; // a point so little below the water lies at its edge [cells]
constexpr double slack = 0.1;          // by which drawn lines and heads may disagree [cells]

std::string five_digits(double value)
{
    return fmt::format("{:.5g}", value);
}

std::string text(const Vector2& point)
{
    return "[" + five_digits(point.x()) + ", " + five_digits(point.y()) + "]";
}

/// Smallest and largest of some numbers.
struct Range {
    double least = std::numeric_limits<double>::infinity(), most = -std::numeric_limits<double>::infinity();

    void include(double value)
    {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    double width() const { return most - least; }
};

/// The points with those between them where `value`, linear from one to the next, is zero.
template <class Value>
std::vector<Vector2> with_zeros(const std::vector<Vector2>& points, Value&& value)
{
    std::vector<Vector2> all = {points.front()};
    for (std::size_t k = 1; k < points.size(); ++k) {
        const double before = value(points[k - 1]), after = value(points[k]);
        if (before * after < 0.0)
            all.push_back(points[k - 1] + before / (before - after) * (points[k] - points[k - 1]));
        all.push_back(points[k]);
    }
    return all;
}

/// How far a point lies below the phreatic line, or the level where there is none [m].
double depth(const Scene& scene, const Vector2& point)
{
    return phreatic_elevation(scene, point.x()) - point.y();
}

/// Points of a segment between which the depth is linear and keeps its sign.
std::vector<Vector2> marks_along(const Scene& scene, const Segment& segment)
{
    std::vector<Vector2> points = {segment.start, segment.end};
    for (const Vector2& knee : scene.phreatic_line)
        points = with_zeros(points, [&](const Vector2& point) { return point.x() - knee.x(); });
    return with_zeros(points, [&](const Vector2& point) { return depth(scene, point); });
}

/// Whether the water at rest acts on the curve: its pores are open to it, or it seals a face.
bool bears_still_water(const Boundary& boundary)
{
    if (std::holds_alternative<FreeFieldSide>(boundary.soil)) return false; // its column has the water beyond
    return std::holds_alternative<Drained>(boundary.water) ||
           (std::holds_alternative<FreeFace>(boundary.soil) &&
            std::holds_alternative<Impervious>(boundary.water));
}

bool lies_on(const Vector2& point, const Segment& segment)
{
    const Vector2 along = segment.end - segment.start, from = point - segment.start;
    const double length = along.norm(), fraction = from.dot(along) / (length * length);
    const double aside = std::abs(along.x() * from.y() - along.y() * from.x()) / length;
    return fraction > -edge_rounding && fraction < 1.0 + edge_rounding && aside < edge_rounding * length;
}

class FaceWater {
public:
    FaceWater(const Scene& scene, const Section& section, Problem& problem, Diagnostics& findings)
        : scene_(scene), section_(section), problem_(problem), findings_(findings)
    {
    }

    void set();

private:
    double cell() const { return problem_.grid.cell_size; }
    void refuse_line(std::string what, std::string expected, std::string hint)
    {
        findings_.add(error_at(scene_.phreatic_place, "phreatic-line", std::move(what), std::move(expected),
                               std::move(hint)));
    }
    Range heights_of_line() const;
    bool is_under_water(const Segment& segment) const;
    void put_water_at_rest(Boundary& boundary) const;
    void check_open_water(const Boundary& boundary);
    void refuse_slope(const Boundary& boundary, const std::vector<Vector2>& stretch);
    void check_unnamed_edges();
    void check_tied_sides();
    void check_extent(const Range& heights);
    void check_given_water(const SourcePlace& place, const Boundary& boundary, const PrescribedWater& water);
    void refuse_given_water(const SourcePlace& place, const Boundary& boundary, const PrescribedWater& water,
                            const Vector2& point);

    const Scene& scene_;
    const Section& section_;
    Problem& problem_;
    Diagnostics& findings_;
};

Range FaceWater::heights_of_line() const
{
    Range heights;
    heights.include(phreatic_elevation(scene_, section_.lower.x()));
    heights.include(phreatic_elevation(scene_, section_.upper.x()));
    for (const Vector2& knee : scene_.phreatic_line) {
        if (knee.x() > section_.lower.x() && knee.x() < section_.upper.x()) heights.include(knee.y());
    }
    return heights;
}

bool FaceWater::is_under_water(const Segment& segment) const
{
    const auto marks = marks_along(scene_, segment);
    return std::any_of(marks.begin(), marks.end(),
                       [&](const Vector2& point) { return depth(scene_, point) > edge_rounding * cell(); });
}

void FaceWater::put_water_at_rest(Boundary& boundary) const
{
    const WaterLine line{scene_.phreatic_line};
    if (auto* given = std::get_if<PrescribedWater>(&boundary.water)) {
        if (!given->at_rest) given->at_rest = line;
        return;
    }
    const auto is_face = [&](const Segment& segment) {
        return is_under_water(segment) && any_along(problem_.rim, segment);
    };
    if (!bears_still_water(boundary) ||
        std::none_of(boundary.segments.begin(), boundary.segments.end(), is_face))
        return;
    if (std::holds_alternative<Drained>(boundary.water)) {
        boundary.water = Drained{line};
    } else {
        boundary.water = Impervious{line};
    }
}

/// Water outside the soil stands level: `stretch` is a part of a face below the line.
void FaceWater::refuse_slope(const Boundary& boundary, const std::vector<Vector2>& stretch)
{
    Range heights, depths, places;
    for (const Vector2& point : stretch) {
        heights.include(phreatic_elevation(scene_, point.x()));
        depths.include(depth(scene_, point));
        places.include(point.x());
    }
    if (stretch.empty() || heights.width() <= slack * std::max(cell(), depths.most)) return;
    refuse_line("above the curve \"" + boundary.name + "\" the phreatic line varies from " +
                    five_digits(heights.least) + " to " + five_digits(heights.most) +
                    " m, between x = " + five_digits(places.least) + " and " + five_digits(places.most) +
                    " m: water outside the soil stands level",
                "a line that is level above the ground, and in the soil elsewhere",
                "let it enter the soil where the water meets the slope");
}

void FaceWater::check_open_water(const Boundary& boundary)
{
    if (!std::holds_alternative<FreeFace>(boundary.soil)) return;
    const auto is_open = [&](const Vector2& point) {
        double above = 0.0;
        for (const double thickness : thickness_above(section_, point)) above += thickness;
        return above < edge_rounding * cell();
    };
    std::vector<Vector2> stretch;
    for (const Segment& segment : boundary.segments) {
        for (const Vector2& point : marks_along(scene_, segment)) {
            if (depth(scene_, point) >= -edge_rounding * cell() && is_open(point)) {
                stretch.push_back(point);
                continue;
            }
            refuse_slope(boundary, stretch);
            stretch.clear();
        }
    }
    refuse_slope(boundary, stretch);
}

void FaceWater::check_unnamed_edges()
{
    for (const Segment& edge : problem_.rim) {
        const bool named =
            std::any_of(section_.curves.begin(), section_.curves.end(),
                        [&](const NamedCurve& curve) { return any_along(curve.segments, edge); });
        if (named || !is_under_water(edge)) continue;
        refuse_line("the edge of the soil from " + text(edge.start) + " to " + text(edge.end) +
                        " lies below the phreatic line and is no physical curve: nothing holds its water",
                    "a physical curve along every edge below the line",
                    "name it in the drawing; it then takes the line's head, or what its table says");
        return;
    }
}

void FaceWater::check_tied_sides()
{
    if (!problem_.tied_sides) return;
    const double left = phreatic_elevation(scene_, problem_.tied_sides->x_left),
                 right = phreatic_elevation(scene_, problem_.tied_sides->x_right);
    if (std::abs(left - right) <= slack * cell()) return;
    findings_.add(warning_at(scene_.phreatic_place, "water.phreatic_line", "phreatic-line",
                             "the phreatic line is " + five_digits(left) + " m high at the tied side \"" +
                                 problem_.tied_sides->left + "\" and " + five_digits(right) + " m at \"" +
                                 problem_.tied_sides->right + "\": a common side has one pore water pressure",
                             "the same height at both"));
}

/// A line that ends before the section begins was probably drawn for another place.
void FaceWater::check_extent(const Range& heights)
{
    const double first = scene_.phreatic_line.front().x(), last = scene_.phreatic_line.back().x();
    const bool drawn_level =
        std::all_of(scene_.phreatic_line.begin(), scene_.phreatic_line.end(), [&](const Vector2& point) {
            return std::abs(point.y() - heights.most) <= edge_rounding * cell();
        });
    if (drawn_level || (first < section_.upper.x() && last > section_.lower.x())) return;
    findings_.add(warning_at(scene_.phreatic_place, "water.phreatic_line", "phreatic-line",
                             "the phreatic line, from x = " + five_digits(first) + " to " +
                                 five_digits(last) + " m, lies beside the soil: its end, " +
                                 five_digits(heights.most) + " m, counts everywhere",
                             "points across the section, x = " + five_digits(section_.lower.x()) + " to " +
                                 five_digits(section_.upper.x()) + " m"));
}

void FaceWater::refuse_given_water(const SourcePlace& where, const Boundary& boundary,
                                   const PrescribedWater& water, const Vector2& point)
{
    const double height = phreatic_elevation(scene_, point.x());
    const auto* head = std::get_if<WaterHead>(&water.value);
    const std::string given =
        join_path({"boundaries", boundary.name, head != nullptr ? "head" : "pore_pressure"}) + ", " +
        (head != nullptr ? five_digits(head->head) + " m"
                         : five_digits(std::get<PorePressure>(water.value).pressure) + " Pa");
    const std::string place = "at " + text(point);
    const std::string hint = "a variable head begins with the water at rest: give it a ramp_time";
    if (scene_.phreatic_line.empty()) {
        findings_.add(error_at(where, "boundary",
                               given + ", stands against soil " + place +
                                   " that is dry: the water level is " + five_digits(height) + " m",
                               "no head above the level where there is soil above it",
                               "raise water.level, or draw water.phreatic_line; " + hint));
        return;
    }
    findings_.add(error_at(where, "boundary",
                           given + ", contradicts the phreatic line, which is " + five_digits(height) +
                               " m high " + place,
                           "the height of the line, or no head: the curve then takes the line's", hint));
}

/// At the start what was given must be the water at rest, where it could not be borne otherwise.
void FaceWater::check_given_water(const SourcePlace& place, const Boundary& boundary,
                                  const PrescribedWater& water)
{
    const auto* head = std::get_if<WaterHead>(&water.value);
    const bool free = std::holds_alternative<FreeFace>(boundary.soil), line = !scene_.phreatic_line.empty();
    if (!free && (head == nullptr || !line)) return; // a wall bears what begins to flow
    const double factor = outer_factor(boundary.water, 0.0);
    double worst = slack * cell() * problem_.water->density * problem_.gravity;
    std::optional<Vector2> where;
    for (const Segment& segment : boundary.segments) {
        auto marks = marks_along(scene_, segment);
        if (head != nullptr)
            marks = with_zeros(marks, [&](const Vector2& point) { return head->head - point.y(); });
        const bool wet = std::all_of(marks.begin(), marks.end(), [&](const Vector2& point) {
            return depth(scene_, point) >= -edge_rounding * cell();
        });
        for (const Vector2& point : marks) {
            const double below = depth(scene_, point);
            if (!line && (wet || below > edge_rounding * cell())) continue; // a pressure that comes suddenly
            const double at_rest = pressure_below(problem_, point.y() + below, point.y());
            const double given = outer_excess_pressure(problem_, boundary, point, factor) +
                                 static_water_pressure(problem_, point.y());
            if (std::abs(given - at_rest) <= worst) continue;
            worst = std::abs(given - at_rest);
            where = point;
        }
    }
    if (where) refuse_given_water(place, boundary, water, *where);
}

void FaceWater::set()
{
    if (!scene_.phreatic_line.empty()) {
        const Range heights = heights_of_line();
        check_extent(heights);
        problem_.water->level = std::max(problem_.water->level, heights.least);
        if (heights.width() > edge_rounding * cell()) {
            check_unnamed_edges();
            check_tied_sides();
            for (Boundary& boundary : problem_.boundaries) {
                if (bears_still_water(boundary)) check_open_water(boundary);
                put_water_at_rest(boundary);
            }
        }
    }
    for (const Boundary& boundary : problem_.boundaries) {
        const auto* water = std::get_if<PrescribedWater>(&boundary.water);
        if (water == nullptr) continue;
        const SceneBoundary& written = *find_boundary(scene_, boundary.name);
        if (!written.water_goes_on) check_given_water(written.water_place, boundary, *water);
    }
}

} // namespace

bool any_along(const std::vector<Segment>& segments, const Segment& other)
{
    const Vector2 middle = 0.5 * (other.start + other.end);
    return std::any_of(segments.begin(), segments.end(),
                       [&](const Segment& segment) { return lies_on(middle, segment); });
}

void set_face_water(const Scene& scene, const Section& section, Problem& problem, Diagnostics& findings)
{
    if (scene.starts_seeping) return; // the water of the faces makes the line, not the line theirs
    if (problem.water && !findings.has_errors()) FaceWater(scene, section, problem, findings).set();
}

std::optional<std::pair<double, double>> heads_of_line(const Scene& scene, const BackgroundGrid& grid,
                                                       const Boundary& boundary)
{
    if (scene.phreatic_line.empty() || !bears_still_water(boundary)) return std::nullopt;
    Range heads;
    for (const Segment& segment : boundary.segments) {
        for (const Vector2& point : marks_along(scene, segment)) {
            const double below = depth(scene, point);
            if (below > edge_rounding * grid.cell_size) heads.include(point.y() + below);
        }
    }
    if (heads.width() < 0.0) return std::nullopt;
    return std::pair(heads.least, heads.most);
}

} // namespace quicksand
