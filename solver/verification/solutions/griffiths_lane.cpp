#include "solver/verification/solutions/griffiths_lane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace quicksand {

namespace {

constexpr int slices = 200;

double surface(const HomogeneousSlope& slope, double x)
{
    return std::clamp(x / slope.run, 0.0, slope.height);
}

/// The circle through both ends of the arc whose centre lies `distance` beyond the middle of the chord.
SlipCircle circle_through(double x0, double y0, double x1, double y1, double distance)
{
    const double dx = x1 - x0, dy = y1 - y0, chord = std::hypot(dx, dy);
    const double x = 0.5 * (x0 + x1) - distance * dy / chord, y = 0.5 * (y0 + y1) + distance * dx / chord;
    return {x, y, std::hypot(0.5 * chord, distance)};
}

/// Place of a circle in the search: exit before the crest, entry behind it, flatness of the arc; each 0 to 1.
using Place = std::array<double, 3>;

struct Arc {
    SlipCircle circle;
    double exit, entry;
};

/// The deepest circle between two points of the surface is the one that touches the base or enters
/// vertically; flatter ones follow as the flatness rises.
Arc arc_at(const HomogeneousSlope& slope, const Place& place)
{
    const double H = slope.height, crest = H * slope.run;
    const double reach = 2.0 * slope.depth_factor * H; // in front of the toe
    const double exit = -reach + place[0] * (reach + 0.9 * crest);
    const double entry = crest + 1e-3 * H + place[1] * 4.0 * H;
    const double y0 = surface(slope, exit), y1 = H, base = (1.0 - slope.depth_factor) * H;
    const auto allowed = [&](double distance) {
        const SlipCircle circle = circle_through(exit, y0, entry, y1, distance);
        const double lowest = circle.centre_x > exit ? circle.centre_y - circle.radius : y0;
        return circle.centre_y >= y1 && lowest >= base - 1e-12 * H;
    };
    double deep = 0.0, flat = 1e4 * H;
    for (int bisection = 0; bisection < 60; ++bisection) {
        const double middle = 0.5 * (deep + flat);
        (allowed(middle) ? flat : deep) = middle;
    }
    const double flatness = std::min(place[2], 0.99);
    const double distance = flat + H * flatness / (1.0 - flatness);
    return {circle_through(exit, y0, entry, y1, distance), exit, entry};
}

double factor_at(const HomogeneousSlope& slope, const Place& place)
{
    for (const double coordinate : place)
        if (coordinate < 0.0 || coordinate > 1.0) return std::numeric_limits<double>::infinity();
    const Arc arc = arc_at(slope, place);
    return bishop_factor_of_safety(slope, arc.circle, arc.exit, arc.entry);
}

/// The weakest place of a regular sampling of the search range.
Place coarse_search(const HomogeneousSlope& slope)
{
    constexpr int samples = 16;
    Place best = {};
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < samples * samples * samples; ++i) {
        const int x = i % samples, y = i / samples % samples, z = i / samples / samples;
        const Place place = {x / (samples - 1.0), y / (samples - 1.0), z / (samples - 1.0)};
        const double factor = factor_at(slope, place);
        if (factor >= least) continue;
        least = factor;
        best = place;
    }
    return best;
}

/// Try the 26 neighbours of a place at a distance; true if one is weaker, which is then the place.
bool step_down(const HomogeneousSlope& slope, double distance, Place& place, double& factor)
{
    const Place centre = place;
    const double before = factor;
    for (int i = 0; i < 27; ++i) {
        const int x = i % 3 - 1, y = i / 3 % 3 - 1, z = i / 9 - 1;
        const Place trial = {centre[0] + distance * x, centre[1] + distance * y, centre[2] + distance * z};
        const double trial_factor = factor_at(slope, trial);
        if (trial_factor >= factor) continue;
        factor = trial_factor;
        place = trial;
    }
    return factor < before;
}

} // namespace

double bishop_factor_of_safety(const HomogeneousSlope& slope, const SlipCircle& circle, double exit,
                               double entry)
{
    // W weight, alpha inclination of the slice's base (positive where it falls towards the toe), b width
    const double b = (entry - exit) / slices, tan_phi = std::tan(slope.friction_angle);
    std::array<double, slices> sine, cosine, strength;
    double driving = 0.0;
    for (int i = 0; i < slices; ++i) {
        const auto j = static_cast<std::size_t>(i);
        const double x = exit + (i + 0.5) * b, arm = x - circle.centre_x;
        const double drop = std::sqrt(std::max(0.0, circle.radius * circle.radius - arm * arm));
        const double bottom = circle.centre_y - drop, top = surface(slope, x);
        const double W = slope.unit_weight * b * std::max(0.0, top - bottom);
        sine[j] = arm / circle.radius;
        cosine[j] = drop / circle.radius;
        strength[j] = slope.cohesion * b + W * tan_phi;
        const double inertia_arm = (circle.centre_y - 0.5 * (top + bottom)) / circle.radius;
        driving += W * (sine[j] + slope.seismic_coefficient * inertia_arm);
    }
    if (driving <= 0.0) return std::numeric_limits<double>::infinity();
    double F = 1.0;
    for (int iteration = 0; iteration < 100; ++iteration) {
        double resisting = 0.0;
        for (std::size_t j = 0; j < slices; ++j) {
            const double m_alpha = cosine[j] + sine[j] * tan_phi / F;
            if (m_alpha < 0.1) return std::numeric_limits<double>::infinity(); // the method breaks down there
            resisting += strength[j] / m_alpha;
        }
        const double before = std::exchange(F, resisting / driving);
        if (std::abs(F - before) < 1e-12 * F) break;
    }
    return F;
}

CriticalCircle critical_circle(const HomogeneousSlope& slope)
{
    Place place = coarse_search(slope);
    double factor = factor_at(slope, place);
    for (double distance = 0.03; distance > 1e-4;)
        if (!step_down(slope, distance, place, factor)) distance *= 0.5;
    return {arc_at(slope, place).circle, factor};
}

} // namespace quicksand
