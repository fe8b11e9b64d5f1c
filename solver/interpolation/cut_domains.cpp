#include "solver/interpolation/cut_domains.hpp"

#include "solver/base/cross_product.hpp"
#include "solver/interpolation/cpdi.hpp"
#include "solver/interpolation/cpdi2.hpp"
#include "solver/particles/cell_lists.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace quicksand {

namespace {

/// Half the sum over the edges of x_c x x_{c+1}, from a point near by [m2].
double polygon_area(const std::vector<Vector2>& corners)
{
    const std::size_t count = corners.size();
    double twice = 0.0;
    for (std::size_t c = 1; c + 1 < count; ++c)
        twice += cross(corners[c] - corners[0], corners[c + 1] - corners[0]);
    return 0.5 * twice;
}

std::vector<Vector2> as_vector(const std::array<Vector2, 4>& corners)
{
    return {corners.begin(), corners.end()};
}

} // namespace

CutDomain make_cut_domain(std::vector<Vector2> corners)
{
    const std::size_t count = corners.size();
    const double twice_area = 2.0 * polygon_area(corners);
    CutDomain shape;
    double sum = 0.0;
    for (std::size_t c = 0; c < count; ++c) {
        const Vector2 &before = corners[(c + count - 1) % count], &after = corners[(c + 1) % count];
        shape.fractions.push_back(0.5 * (cross(before, corners[c]) + cross(corners[c], after)) / twice_area);
        sum += shape.fractions.back();
    }
    for (double& fraction : shape.fractions) fraction /= sum;
    shape.corners = std::move(corners);
    return shape;
}

void corners_in_frame(const CutDomain& shape, const Vector2& centre, const Vector2& half_edge_1,
                      const Vector2& half_edge_2, std::vector<Vector2>& corners)
{
    corners.clear();
    for (const Vector2& local : shape.corners)
        corners.push_back(centre + local.x() * half_edge_1 + local.y() * half_edge_2);
}

std::vector<Vector2> corners_in_frame(const CutDomain& shape, const Vector2& centre,
                                      const Vector2& half_edge_1, const Vector2& half_edge_2)
{
    std::vector<Vector2> corners;
    corners_in_frame(shape, centre, half_edge_1, half_edge_2, corners);
    return corners;
}

std::vector<Vector2> domain_polygon(const CutDomains& cut_domains, const Particles& particles, std::size_t p)
{
    const CutDomain* shape = cut_domains.find(particles.identifier[p]);
    if (shape == nullptr) return as_vector(quadrilateral_corners(particles, p));
    return corners_in_frame(*shape, particles.position[p], particles.half_edge_1[p],
                            particles.half_edge_2[p]);
}

std::vector<Vector2> reference_polygon(const CutDomains& cut_domains, const Particles& particles,
                                       std::size_t p)
{
    const CutDomain* shape = cut_domains.find(particles.identifier[p]);
    if (shape == nullptr) return as_vector(reference_corners(particles, p));
    return corners_in_frame(*shape, particles.reference_position[p], particles.reference_edge_1[p],
                            particles.reference_edge_2[p]);
}

double line_tolerance(const BackgroundGrid& grid, const Vector2& place)
{
    return std::max(grid.line_tolerance, 1e-12 + 4e-16 * place.cwiseAbs().maxCoeff() / grid.cell_size);
}

bool limit_polygon(double cell_size, const Vector2& centre, std::vector<Vector2>& corners)
{
    double farthest = 0.0;
    for (const Vector2& x : corners) farthest = std::max(farthest, (x - centre).cwiseAbs().maxCoeff());
    const double allowed = BackgroundGrid::domain_reach * cell_size;
    if (farthest <= allowed) return false;
    for (Vector2& x : corners) x = centre + allowed / farthest * (x - centre);
    return true;
}

void evaluate_polygon(const BackgroundGrid& grid, const CutDomain& shape, const std::vector<Vector2>& corners,
                      NodeStencil& stencil)
{
    const std::size_t count = corners.size();
    const double half = 0.5 / polygon_area(corners);
    thread_local std::vector<CornerWeights> weights; // its memory serves all domains
    weights.clear();
    for (std::size_t c = 0; c < count; ++c) {
        const Vector2& before = corners[c > 0 ? c - 1 : count - 1];
        const Vector2& after = corners[c + 1 < count ? c + 1 : 0];
        const Vector2 across = after - before;
        weights.push_back({corners[c], shape.fractions[c], half * Vector2(across.y(), -across.x())});
    }
    sum_corner_weights(grid, weights, stencil, line_tolerance(grid, corners.front()));
}

std::int64_t weigh_cut_domains(const BackgroundGrid& grid, const CutDomains& cut_domains,
                               const Particles& particles, const CellLists& lists, const Tile& tile,
                               StencilStore& store)
{
    const std::size_t first = lists.first_entry(tile);
    const auto particle = [&](std::size_t entry) {
        return static_cast<std::size_t>(lists.order[first + entry]);
    };
    if (store.cut_of != lists.changes) {
        store.cut_of = lists.changes;
        store.cut.clear();
        for (std::size_t k = 0; k < lists.last_entry(tile) - first; ++k)
            if (cut_domains.find(particles.identifier[particle(k)]) != nullptr)
                store.cut.push_back(static_cast<std::uint32_t>(k));
    }
    std::int64_t limited = 0;
    NodeStencil stencil;
    std::vector<Vector2> corners;
    for (const std::uint32_t k : store.cut) {
        const std::size_t p = particle(k);
        const CutDomain& shape = *cut_domains.find(particles.identifier[p]);
        ParallelogramDomain frame{particles.position[p], particles.half_edge_1[p], particles.half_edge_2[p]};
        corners_in_frame(shape, frame.centre, frame.half_edge_1, frame.half_edge_2, corners);
        if (limit_polygon(grid.cell_size, frame.centre, corners))
            limited += limit_domain(grid.cell_size, frame) ? 0 : 1;
        evaluate_polygon(grid, shape, corners, stencil);
        store.put(k, stencil);
    }
    return limited;
}

} // namespace quicksand
