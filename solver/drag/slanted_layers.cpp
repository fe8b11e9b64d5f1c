#include "solver/drag/slanted_layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace quicksand {

namespace {

/// Of the strips on both sides of the node: turned, they cross its support from corner to corner.
constexpr double reach = 1.5; // [cells]
constexpr double strips_per_cell = 16.0;
constexpr int strip_count = 48; // 2 reach strips_per_cell
/// Of half the width of a strip with a domain's moment of inertia: the rectangle that stands for a piece
/// reaches beyond the face that cut it.
constexpr double inner_part = 0.8;

/// Weight, centre and moment of inertia per weight of a soil.
struct SoilMoments {
    double weight = 0.0;                              // [m3/m]
    Vector2 centre = Vector2::Zero();                 // [cells]
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero(); // [cells2]
};

/// Of the parts that belong to it, by weight(part).
template <class Weight, class Belongs>
SoilMoments moments_of(const std::vector<SoilPart>& parts, Weight&& weight, Belongs&& belongs)
{
    SoilMoments soil;
    for (const SoilPart& part : parts) {
        if (!belongs(part)) continue;
        soil.weight += weight(part);
        soil.centre += weight(part) * part.place;
    }
    if (!(soil.weight > 0.0)) return soil;
    soil.centre /= soil.weight;
    for (const SoilPart& part : parts) {
        if (!belongs(part)) continue;
        const Vector2 apart = part.place - soil.centre;
        const Eigen::Matrix2d own =
            part.edge_1 * part.edge_1.transpose() + part.edge_2 * part.edge_2.transpose();
        soil.spread += weight(part) / soil.weight * (apart * apart.transpose() + own / 3.0);
    }
    return soil;
}

Vector2 direction(double angle)
{
    return {std::cos(angle), std::sin(angle)};
}

/// The angle of least measure(angle) in half a turn.
template <class Measure>
double least_angle(Measure&& measure)
{
    constexpr int count = 12, refinements = 6;
    double step = std::numbers::pi / count, best = 0.0, least = measure(0.0);
    const auto take = [&](double angle) {
        const double value = measure(angle);
        if (!(value < least)) return;
        least = value;
        best = angle;
    };
    for (int k = 1; k < count; ++k) take(k * step);
    for (int k = 0; k < refinements; ++k) {
        step *= 0.5;
        const double middle = best;
        take(middle - step);
        take(middle + step);
    }
    return best;
}

/// The more and the less permeable soil, and both together.
struct TwoSoils {
    SoilMoments open, tight, all;

    /// The direction that tells them apart best.
    Vector2 normal() const
    {
        const auto term = [](const SoilMoments& soil, const Vector2& n) {
            return soil.weight * std::log(n.dot(soil.spread * n));
        };
        return direction(least_angle([&](double angle) {
            const Vector2 n = direction(angle);
            return term(open, n) + term(tight, n) - term(all, n);
        }));
    }
};

/// By weight(part); none where a soil has no weight.
template <class Weight>
std::optional<TwoSoils> two_soils(const std::vector<SoilPart>& parts, double middle_resistivity,
                                  Weight&& weight)
{
    const auto is_tight = [&](const SoilPart& part) { return part.resistivity > middle_resistivity; };
    TwoSoils soils{moments_of(parts, weight, [&](const SoilPart& part) { return !is_tight(part); }),
                   moments_of(parts, weight, is_tight),
                   moments_of(parts, weight, [](const SoilPart&) { return true; })};
    if (!(soils.open.weight > 0.0) || !(soils.tight.weight > 0.0)) return std::nullopt;
    return soils;
}

/// What a domain covers of the strips, in strips from the first.
struct Span {
    double low, high;
};

Span span_of(const SoilPart& part, const Vector2& normal)
{
    constexpr double least = 1e-6; // of a domain that lies along the strips
    const double middle = (part.place.dot(normal) + reach) * strips_per_cell,
                 half = inner_part * strips_per_cell *
                        std::hypot(part.edge_1.dot(normal), part.edge_2.dot(normal));
    const double low = std::clamp(middle - half, 0.0, strip_count - least);
    return {low, std::clamp(middle + half, low + least, 1.0 * strip_count)};
}

/// (sum W)^2 / sum (W^2 / R) over strips whose normal is given.
double drag_along_strips(const std::vector<SoilPart>& parts, const Vector2& normal)
{
    std::array<double, strip_count> volume{}, resistance{};
    for (const SoilPart& part : parts) {
        const Span span = span_of(part, normal);
        const double per_strip = part.volume / (span.high - span.low);
        const int last = std::min(static_cast<int>(span.high), strip_count - 1);
        for (int s = static_cast<int>(span.low); s <= last; ++s) {
            const double within =
                per_strip * std::max(std::min(span.high, s + 1.0) - std::max(span.low, 1.0 * s), 0.0);
            volume[static_cast<std::size_t>(s)] += within;
            resistance[static_cast<std::size_t>(s)] += within * part.resistivity;
        }
    }
    double whole = 0.0, flow = 0.0;
    for (std::size_t s = 0; s < strip_count; ++s) {
        whole += volume[s];
        if (resistance[s] > 0.0) flow += volume[s] * volume[s] / resistance[s];
    }
    return whole * whole / flow;
}

double sum_of_resistances(const std::vector<SoilPart>& parts)
{
    double sum = 0.0;
    for (const SoilPart& part : parts) sum += part.volume * part.resistivity;
    return sum;
}

/// Whether a place, the centre of the tight soil, lies between open soil along the normal.
bool lies_between(const std::vector<SoilPart>& parts, double middle_resistivity, const Vector2& normal,
                  const Vector2& place)
{
    constexpr double little = 0.02; // of all soil
    double before = 0.0, behind = 0.0, all = 0.0;
    for (const SoilPart& part : parts) {
        all += part.volume;
        if (part.resistivity > middle_resistivity) continue;
        (normal.dot(part.place - place) < 0.0 ? before : behind) += part.volume;
    }
    return std::min(before, behind) > little * all;
}

/// Whether a face is so near to the axes of the grid that strips along these do.
bool is_along_grid(const Vector2& normal)
{
    constexpr double near = 0.01; // sine of the angle
    return std::min(std::abs(normal.x()), std::abs(normal.y())) < near;
}

} // namespace

std::optional<SlantedDrag> slanted_drag(const std::vector<SoilPart>& parts)
{
    const auto [least, most] =
        std::minmax_element(parts.begin(), parts.end(), [](const SoilPart& a, const SoilPart& b) {
            return a.resistivity < b.resistivity;
        });
    if (parts.empty() || !(least->resistivity < most->resistivity)) return std::nullopt;
    const double middle = std::sqrt(least->resistivity * most->resistivity);
    const std::optional<TwoSoils> by_weight =
        two_soils(parts, middle, [](const SoilPart& part) { return part.volume; });
    if (!by_weight || is_along_grid(by_weight->normal())) return std::nullopt;
    const std::optional<TwoSoils> by_distance = two_soils(parts, middle, [](const SoilPart& part) {
        return part.whole * std::max(1.0 - part.place.squaredNorm(), 0.0);
    });
    const Vector2 normal = (by_distance ? *by_distance : *by_weight).normal(), layer(-normal.y(), normal.x());
    if (is_along_grid(normal)) return std::nullopt;
    const bool is_seam = lies_between(parts, middle, normal, by_weight->tight.centre);
    return SlantedDrag{drag_along_strips(parts, normal),
                       is_seam ? sum_of_resistances(parts) : drag_along_strips(parts, layer), layer};
}

} // namespace quicksand
