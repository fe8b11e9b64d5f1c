#include "solver/motion/compact_domains.hpp"

#include "solver/base/lanes.hpp"
#include "solver/base/threads.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace quicksand {

namespace {

/// By how much |r_1 . r_2| is beyond the square of the shorter edge, or the square of the longer edge beyond
/// the longest; the largest of the particles, and 0 when all are compact [m2].
VECTOR_KERNEL
double largest_excess(const Vectors& r1, const Vectors& r2, double longest, std::size_t first,
                      std::size_t last)
{
    const Lanes limit = all_lanes(longest * longest);
    Lanes most = all_lanes(0.0);
    std::size_t p = first;
    for (; p + 4 <= last; p += 4) {
        const Lanes x1 = load_lanes(r1.x.data() + p), y1 = load_lanes(r1.y.data() + p);
        const Lanes x2 = load_lanes(r2.x.data() + p), y2 = load_lanes(r2.y.data() + p);
        const Lanes a = x1 * x1 + y1 * y1, b = x2 * x2 + y2 * y2;
        const Lanes shear = absolute(x1 * x2 + y1 * y2) - (a < b ? a : b);
        const Lanes length = (a < b ? b : a) - limit;
        most = shear > most ? shear : most;
        most = length > most ? length : most;
    }
    double result = std::max({most[0], most[1], most[2], most[3]});
    for (; p < last; ++p) {
        const double a = r1[p].squaredNorm(), b = r2[p].squaredNorm();
        result = std::max({result, std::abs(r1[p].dot(r2[p])) - std::min(a, b), std::max(a, b) - limit[0]});
    }
    return result;
}

/// Identifiers of the particles that carry pieces of curves, in order. Sorted anew in every step: there are
/// few, and pieces are renumbered where one column stands for all.
std::vector<std::int32_t> find_carriers(const Problem& problem)
{
    std::vector<std::int32_t> carriers;
    for (const Boundary& boundary : problem.boundaries) {
        for (const BoundaryPiece& piece : boundary.pieces) carriers.push_back(piece.identifier);
    }
    std::sort(carriers.begin(), carriers.end());
    return carriers;
}

/// The edges of one domain and of its reference, the shorter half edge first.
struct Edges {
    Vectors *shorter, *longer, *reference_of_shorter, *reference_of_longer;
};

Edges edges_of(std::size_t p, Particles& particles)
{
    Vectors &r1 = particles.half_edge_1, &r2 = particles.half_edge_2;
    Vectors &R1 = particles.reference_edge_1, &R2 = particles.reference_edge_2;
    if (r1[p].squaredNorm() <= r2[p].squaredNorm()) return {&r1, &r2, &R1, &R2};
    return {&r2, &r1, &R2, &R1};
}

void unshear(std::size_t p, const Edges& edges)
{
    const Vector2 shorter = (*edges.shorter)[p], longer = (*edges.longer)[p];
    const double along = shorter.dot(longer), square = shorter.squaredNorm();
    if (std::abs(along) <= square) return;
    const double count = std::round(along / square);
    edges.longer->set(p, longer - count * shorter);
    edges.reference_of_longer->set(p, (*edges.reference_of_longer)[p] -
                                          count * (*edges.reference_of_shorter)[p]);
}

void widen(double longest, std::size_t p, const Edges& edges)
{
    const double length = (*edges.longer)[p].norm();
    if (length <= longest) return;
    const double stretch = length / longest;
    for (Vectors* edge : {edges.longer, edges.reference_of_longer}) edge->set(p, (*edge)[p] / stretch);
    for (Vectors* edge : {edges.shorter, edges.reference_of_shorter}) edge->set(p, (*edge)[p] * stretch);
}

/// Stretches of the reference domain beyond the largest are cut along and made up for across: the area stays.
void limit_reference(std::size_t p, Particles& particles)
{
    Vectors &R1 = particles.reference_edge_1, &R2 = particles.reference_edge_2;
    const double area = R1.x[p] * R2.y[p] - R1.y[p] * R2.x[p];
    const Vector2 longer = R1[p].squaredNorm() < R2[p].squaredNorm() ? R2[p] : R1[p];
    const double fraction = largest_recorded_stretch * std::sqrt(area) / longer.norm();
    if (fraction >= 1.0) return;
    const Vector2 along = longer.normalized(), across(-along.y(), along.x());
    for (Vectors* edge : {&R1, &R2}) {
        const Vector2 R = (*edge)[p];
        edge->set(p, fraction * along.dot(R) * along + across.dot(R) / fraction * across);
    }
}

} // namespace

void keep_domains_compact(const Problem& problem, Particles& particles)
{
    const double longest = longest_half_edge * problem.grid.cell_size;
    const std::vector<std::int32_t> carriers = find_carriers(problem);
    const auto may_change = [&](std::size_t p) {
        return yields(problem.materials[static_cast<std::size_t>(particles.material[p])].law) &&
               !std::binary_search(carriers.begin(), carriers.end(), particles.identifier[p]);
    };
    const Vectors &r1 = particles.half_edge_1, &r2 = particles.half_edge_2;
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        if (largest_excess(r1, r2, longest, first, last) <= 0.0) return;
        for (std::size_t p = first; p < last; ++p) {
            if (largest_excess(r1, r2, longest, p, p + 1) <= 0.0 || !may_change(p)) continue;
            unshear(p, edges_of(p, particles));
            widen(longest, p, edges_of(p, particles));
            limit_reference(p, particles);
        }
    });
}

} // namespace quicksand
