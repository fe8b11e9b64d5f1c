#include "solver/interpolation/cpdi2.hpp"

#include "solver/base/cross_product.hpp"
#include "solver/interpolation/cpdi.hpp"

#include <algorithm>

namespace quicksand {

namespace {

/// x_p - c: from the vertex mean to the centroid.
Vector2 centroid_offset(const Vector2& r1, const Vector2& r2, const Vector2& twist)
{
    return (cross(r1, twist) * r1 + cross(twist, r2) * r2) / (3.0 * cross(r1, r2));
}

Vector2 twist_of(const Particles& particles, std::size_t p)
{
    return particles.twist.x.empty() ? Vector2::Zero() : particles.twist[p];
}

std::array<Vector2, 4> corners_of(const QuadrilateralDomain& domain)
{
    const Vector2 &r1 = domain.half_edge_1, &r2 = domain.half_edge_2, &t = domain.twist;
    const Vector2 c = domain.centroid - centroid_offset(r1, r2, t);
    return {c - r1 - r2 + t, c + r1 - r2 - t, c + r1 + r2 + t, c - r1 + r2 - t};
}

} // namespace

double limit_corners(double cell_size, const Vector2& centre, std::array<Vector2, 4>& corners)
{
    double farthest = 0.0;
    for (const Vector2& x : corners) farthest = std::max(farthest, (x - centre).cwiseAbs().maxCoeff());
    const double allowed = BackgroundGrid::domain_reach * cell_size;
    if (farthest <= allowed) return 1.0;
    const double scale = allowed / farthest;
    for (Vector2& x : corners) x = centre + scale * (x - centre);
    return scale;
}

std::array<Vector2, 4> quadrilateral_corners(const Particles& particles, std::size_t p)
{
    return corners_of(
        {particles.position[p], particles.half_edge_1[p], particles.half_edge_2[p], twist_of(particles, p)});
}

std::array<Vector2, 4> reference_corners(const Particles& particles, std::size_t p)
{
    return corners_of({particles.reference_position[p], particles.reference_edge_1[p],
                       particles.reference_edge_2[p], twist_of(particles, p)});
}

QuadrilateralDomain quadrilateral_domain(const std::array<Vector2, 4>& corners)
{
    const auto& [x1, x2, x3, x4] = corners;
    QuadrilateralDomain domain;
    domain.half_edge_1 = 0.25 * (x2 + x3 - x1 - x4);
    domain.half_edge_2 = 0.25 * (x3 + x4 - x1 - x2);
    domain.twist = 0.25 * (x1 + x3 - x2 - x4);
    domain.centroid =
        0.25 * (x1 + x2 + x3 + x4) + centroid_offset(domain.half_edge_1, domain.half_edge_2, domain.twist);
    return domain;
}

void set_quadrilateral(const std::array<Vector2, 4>& corners, std::size_t p, Particles& particles)
{
    const QuadrilateralDomain domain = quadrilateral_domain(corners);
    particles.half_edge_1.set(p, domain.half_edge_1);
    particles.half_edge_2.set(p, domain.half_edge_2);
    particles.twist.set(p, domain.twist);
    particles.position.set(p, domain.centroid);
}

double domain_area(const Particles& particles, std::size_t p)
{
    return 4.0 * cross(particles.half_edge_1[p], particles.half_edge_2[p]);
}

bool Cpdi2::evaluate(const BackgroundGrid& grid, const Particles& particles, std::size_t p,
                     NodeStencil& stencil)
{
    std::array<Vector2, 4> x = quadrilateral_corners(particles, p);
    const double scale_of_domain = limit_corners(grid.cell_size, particles.position[p], x);
    const double V = domain_area(particles, p) * scale_of_domain * scale_of_domain;
    const double a = cross(x[3] - x[0], x[1] - x[2]), b = cross(x[2] - x[3], x[0] - x[1]);
    const double scale = 1.0 / (24.0 * V), half = 0.5 / V;
    const Vector2 g1 = half * Vector2(x[1].y() - x[3].y(), x[3].x() - x[1].x());
    const Vector2 g2 = half * Vector2(x[2].y() - x[0].y(), x[0].x() - x[2].x());
    const CornerWeights corners[4] = {{x[0], (6.0 * V - a - b) * scale, g1},
                                      {x[1], (6.0 * V - a + b) * scale, g2},
                                      {x[2], (6.0 * V + a + b) * scale, -g1},
                                      {x[3], (6.0 * V + a - b) * scale, -g2}};
    sum_corner_weights(grid, corners, stencil, grid.line_tolerance);
    return scale_of_domain < 1.0;
}

} // namespace quicksand
