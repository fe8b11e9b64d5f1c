#include "solver/sheared_domains.hpp"

#include "solver/lanes.hpp"
#include "solver/threads.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

/// What remains of |r_1 . r_2| beyond the square of the shorter edge; the largest of the particles [m2].
VECTOR_KERNEL
double largest_excess(const Vectors& r1, const Vectors& r2, std::size_t first, std::size_t last)
{
    Lanes most = all_lanes(0.0);
    std::size_t p = first;
    for (; p + 4 <= last; p += 4) {
        const Lanes x1 = load_lanes(r1.x.data() + p), y1 = load_lanes(r1.y.data() + p);
        const Lanes x2 = load_lanes(r2.x.data() + p), y2 = load_lanes(r2.y.data() + p);
        const Lanes a = x1 * x1 + y1 * y1, b = x2 * x2 + y2 * y2, along = x1 * x2 + y1 * y2;
        const Lanes shorter = a < b ? a : b, excess = absolute(along) - shorter;
        most = excess > most ? excess : most;
    }
    double result = std::max({most[0], most[1], most[2], most[3]});
    for (; p < last; ++p) {
        const double shorter = std::min(r1[p].squaredNorm(), r2[p].squaredNorm());
        result = std::max(result, std::abs(r1[p].dot(r2[p])) - shorter);
    }
    return result;
}

bool carries_a_curve(const Problem& problem, std::int32_t identifier)
{
    return std::any_of(problem.boundaries.begin(), problem.boundaries.end(), [&](const Boundary& boundary) {
        return std::any_of(boundary.pieces.begin(), boundary.pieces.end(),
                           [&](const BoundaryPiece& piece) { return piece.identifier == identifier; });
    });
}

/// Whether the soil flows at its strength: its stress then hangs on the path, not on the shape.
bool yields(const SkeletonLaw& law)
{
    return !std::holds_alternative<LinearElastic>(law) && !std::holds_alternative<NeoHookean>(law);
}

void subtract(double count, std::size_t p, const Vectors& from, Vectors& edge)
{
    edge.set(p, edge[p] - count * from[p]);
}

void shorten(const Problem& problem, std::size_t p, Particles& particles)
{
    Vectors &r1 = particles.half_edge_1, &r2 = particles.half_edge_2;
    const double a = r1[p].squaredNorm(), b = r2[p].squaredNorm(), shorter = std::min(a, b);
    const double along = r1[p].dot(r2[p]);
    if (std::abs(along) <= shorter || carries_a_curve(problem, particles.identifier[p])) return;
    const double count = std::round(along / shorter);
    if (a <= b) {
        subtract(count, p, r1, r2);
        subtract(count, p, particles.reference_edge_1, particles.reference_edge_2);
    } else {
        subtract(count, p, r2, r1);
        subtract(count, p, particles.reference_edge_2, particles.reference_edge_1);
    }
}

} // namespace

void shorten_sheared_domains(const Problem& problem, Particles& particles)
{
    const auto yields_at = [&](std::size_t p) {
        return yields(problem.materials[static_cast<std::size_t>(particles.material[p])].law);
    };
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        if (!(largest_excess(particles.half_edge_1, particles.half_edge_2, first, last) > 0.0)) return;
        for (std::size_t p = first; p < last; ++p)
            if (yields_at(p)) shorten(problem, p, particles);
    });
}

} // namespace quicksand
