#include "io/assembly/probe_places.hpp"

#include "io/keys/scene_units.hpp"
#include "solver/interpolation/cut_domains.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace quicksand {

namespace {

/// Calls visit(y) for the heights at which the domain's outline meets the vertical line at x.
template <class Visit>
void for_each_crossing(const std::vector<Vector2>& outline, double x, Visit&& visit)
{
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vector2& a = outline[k];
        const Vector2& b = outline[(k + 1) % outline.size()];
        if ((a.x() - x) * (b.x() - x) > 0.0) continue;
        if (a.x() == b.x()) {
            visit(std::max(a.y(), b.y()));
        } else {
            visit(a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x()));
        }
    }
}

/// The middle of a domain's width and half of it [m].
std::pair<double, double> width_of(const Problem& problem, const Particles& particles, std::size_t p)
{
    const CutDomain* shape = problem.cut_domains.find(particles.identifier[p]);
    if (shape == nullptr)
        return {particles.position.x[p],
                std::abs(particles.half_edge_1.x[p]) + std::abs(particles.half_edge_2.x[p])};
    double first = particles.position.x[p], last = first;
    for (const Vector2& corner : domain_polygon(problem.cut_domains, particles, p)) {
        first = std::min(first, corner.x());
        last = std::max(last, corner.x());
    }
    return {0.5 * (first + last), 0.5 * (last - first)};
}

} // namespace

std::size_t nearest_particle(const Particles& particles, const Vector2& point)
{
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double distance = (particles.reference_position[p] - point).squaredNorm();
        // Of equally near ones the lowest number, whatever the present order of the arrays.
        const bool tie = distance == least && particles.identifier[p] < particles.identifier[nearest];
        if (distance < least || tie) {
            nearest = p;
            least = distance;
        }
    }
    return nearest;
}

std::optional<std::string> outside_soil(const Problem& problem, const Particles& particles,
                                        const Vector2& point)
{
    const Vector2 found = particles.reference_position[nearest_particle(particles, point)];
    if ((found - point).norm() <= 2.0 * problem.grid.cell_size) return std::nullopt;
    return fmt::format("at ({}, {}) m lies outside the soil: the nearest particle is at {} m", point.x(),
                       point.y(), place_text(found));
}

std::vector<Vector2> points_of(const SceneProbe& probe)
{
    if (probe.kind != ProbeKind::profile || probe.points < 2) return {*probe.at};
    std::vector<Vector2> points;
    for (int k = 0; k < probe.points; ++k)
        points.push_back(*probe.at + (*probe.to - *probe.at) * (static_cast<double>(k) / (probe.points - 1)));
    return points;
}

namespace {

/// Let the surface be that of the particle p if it lies higher at x, or as high with a lower number.
void raise_to(const Problem& problem, const Particles& particles, std::size_t p, double x,
              SurfacePoint& surface)
{
    for_each_crossing(domain_polygon(problem.cut_domains, particles, p), x, [&](double y) {
        const bool tie = surface.found && y == surface.height &&
                         particles.identifier[p] < particles.identifier[surface.particle];
        if (!surface.found || y > surface.height || tie) surface = {true, p, y, surface.shift};
    });
}

/// Raise the surface to what there is at x; its shift stays. A hairline between two domains is no gap through
/// which the soil below them is seen: one that ends beside it counts if it lies a step higher.
void raise_surface(const Problem& problem, const Particles& particles, double x, SurfacePoint& surface)
{
    constexpr double rounding = 1e-9; // where two domains meet, x lies beside both or neither without it [-]
    constexpr double hairline = 0.01, step = 0.2; // of the half width of a domain [-]
    SurfacePoint beside;
    beside.shift = surface.shift;
    double reach_beside = 0.0; // [m]
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const auto [middle, reach] = width_of(problem, particles, p);
        const double apart = x - middle, rim = (1.0 - rounding) * reach;
        if (std::abs(apart) > (1.0 + hairline) * reach) continue;
        const double inside = std::abs(apart) > rim ? middle + std::copysign(rim, apart) : x;
        const bool ends_beside = std::abs(apart) > (1.0 + rounding) * reach;
        raise_to(problem, particles, p, inside, ends_beside ? beside : surface);
        if (beside.found && beside.particle == p) reach_beside = reach;
    }
    if (surface.found && beside.found && beside.height > surface.height + step * reach_beside)
        surface = beside;
}

} // namespace

SurfacePoint surface_point(const Problem& problem, const Particles& particles, double x)
{
    SurfacePoint surface;
    raise_surface(problem, particles, x, surface);
    constexpr double rounding = 1e-9; // of the width [-]
    if (!problem.tied_sides) return surface;
    const TiedSides& sides = *problem.tied_sides;
    const double period = sides.x_right - sides.x_left;
    if (x < sides.x_left - rounding * period || x > sides.x_right + rounding * period) return surface;
    double left = x, right = x; // of the soil, which may have drifted by many widths [m]
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const auto [middle, reach] = width_of(problem, particles, p);
        left = std::min(left, middle - reach);
        right = std::max(right, middle + reach);
    }
    const double first = std::ceil((left - x) / period), last = std::floor((right - x) / period);
    for (double k = first; k <= last; ++k) {
        if (k == 0.0) continue;
        SurfacePoint image;
        image.shift = k * period;
        raise_surface(problem, particles, x + image.shift, image);
        if (image.found && (!surface.found || image.height > surface.height)) surface = image;
    }
    return surface;
}

} // namespace quicksand
