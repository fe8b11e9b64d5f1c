#include "geometry/particle_sampler.hpp"

#include "geometry/region_locator.hpp"
#include "solver/cpdi2.hpp"
#include "solver/cross_product.hpp"
#include "solver/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

namespace quicksand {

namespace {

/// The lattice of domain-sized boxes laid over the grid's cells.
struct Lattice {
    Vector2 origin; // lower left corner of the first box [m]
    Vector2 size;   // of one box [m]
    int columns = 0, rows = 0;

    Vector2 centre(int i, int j) const { return origin + size.cwiseProduct(Vector2(i + 0.5, j + 0.5)); }
    std::size_t index(int i, int j) const
    {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i);
    }
};

/// Whether a segment runs through the inside of a box, given by its lower and upper corner.
bool crosses_box(const Vector2& start, const Vector2& end, const Vector2& lower, const Vector2& upper)
{
    double enter = 0.0, leave = 1.0;
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
        const double direction = end[axis] - start[axis];
        if (direction == 0.0) {
            if (start[axis] <= lower[axis] || start[axis] >= upper[axis]) return false;
            continue;
        }
        const double at_lower = (lower[axis] - start[axis]) / direction;
        const double at_upper = (upper[axis] - start[axis]) / direction;
        enter = std::max(enter, std::min(at_lower, at_upper));
        leave = std::min(leave, std::max(at_lower, at_upper));
    }
    return enter < leave;
}

void mark_boxes_on_edge(const Lattice& lattice, const Vector2& start, const Vector2& end,
                        std::vector<std::uint8_t>& cut)
{
    // an outline that runs along the sides of boxes cuts none, whatever its rounding
    const Vector2 slack = 1e-9 * lattice.size;
    const Vector2 from = (start.cwiseMin(end) - lattice.origin).cwiseQuotient(lattice.size);
    const Vector2 to = (start.cwiseMax(end) - lattice.origin).cwiseQuotient(lattice.size);
    const int first_i = std::max(0, static_cast<int>(std::floor(from.x())) - 1);
    const int first_j = std::max(0, static_cast<int>(std::floor(from.y())) - 1);
    const int last_i = std::min(lattice.columns - 1, static_cast<int>(std::floor(to.x())) + 1);
    const int last_j = std::min(lattice.rows - 1, static_cast<int>(std::floor(to.y())) + 1);
    for (int j = first_j; j <= last_j; ++j) {
        for (int i = first_i; i <= last_i; ++i) {
            const Vector2 lower = lattice.centre(i, j) - 0.5 * lattice.size + slack;
            const Vector2 upper = lattice.centre(i, j) + 0.5 * lattice.size - slack;
            if (crosses_box(start, end, lower, upper)) cut[lattice.index(i, j)] = 1;
        }
    }
}

void mark_boxes_on_ring(const Lattice& lattice, const Ring& ring, std::vector<std::uint8_t>& cut)
{
    for (std::size_t k = 0; k < ring.size(); ++k)
        mark_boxes_on_edge(lattice, ring[k], ring[(k + 1) % ring.size()], cut);
}

/// 1 for every box that an outline cuts.
std::vector<std::uint8_t> find_cut_boxes(const Section& section, const Lattice& lattice)
{
    std::vector<std::uint8_t> cut(
        static_cast<std::size_t>(lattice.columns) * static_cast<std::size_t>(lattice.rows), 0);
    for (const Region& region : section.regions) {
        for (const Polygon& polygon : region.polygons) {
            mark_boxes_on_ring(lattice, polygon.outer, cut);
            for (const Ring& hole : polygon.holes) mark_boxes_on_ring(lattice, hole, cut);
        }
    }
    return cut;
}

/// Split a box `parts` times each way and keep the parts whose centres lie in a region.
void sample_box(const RegionLocator& locator, const Vector2& centre, const Vector2& size, int parts,
                std::vector<ParticleDomain>& domains)
{
    const Vector2 part = size / parts;
    for (int j = 0; j < parts; ++j) {
        for (int i = 0; i < parts; ++i) {
            ParticleDomain domain;
            const Vector2 steps(i - 0.5 * (parts - 1), j - 0.5 * (parts - 1)); // from the box's centre
            domain.centre = centre + part.cwiseProduct(steps);
            const std::optional<std::size_t> region = locator.locate(domain.centre);
            if (!region) continue;
            domain.half_edge_1 = Vector2(0.5 * part.x(), 0.0);
            domain.half_edge_2 = Vector2(0.0, 0.5 * part.y());
            domain.volume = part.x() * part.y();
            domain.region = *region;
            domains.push_back(domain);
        }
    }
}

/// A sum whose error does not grow with the number of terms (Neumaier).
class ExactSum {
public:
    void add(double term)
    {
        const double next = sum_ + term;
        rest_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
        sum_ = next;
    }
    double value() const { return sum_ + rest_; }

private:
    double sum_ = 0.0, rest_ = 0.0;
};

std::vector<double> sum_volumes(const std::vector<ParticleDomain>& domains, std::size_t regions)
{
    std::vector<ExactSum> sums(regions);
    for (const ParticleDomain& domain : domains) sums[domain.region].add(domain.volume);
    std::vector<double> volumes;
    for (const ExactSum& sum : sums) volumes.push_back(sum.value());
    return volumes;
}

/// Scale each region's volumes by one factor to the region's area, and report.
void correct_volumes(const Section& section, Sampling& sampling)
{
    const std::size_t count = section.regions.size();
    sampling.regions.assign(count, {});
    const std::vector<double> sampled = sum_volumes(sampling.domains, count);
    for (std::size_t k = 0; k < count; ++k) {
        RegionSampling& report = sampling.regions[k];
        report.area = area(section.regions[k]);
        if (sampled[k] <= 0.0) continue;
        report.area_error = (sampled[k] - report.area) / report.area;
        report.volume_factor = report.area / sampled[k];
        report.smallest_volume = std::numeric_limits<double>::infinity();
    }
    for (ParticleDomain& domain : sampling.domains) {
        RegionSampling& report = sampling.regions[domain.region];
        domain.volume *= report.volume_factor;
        ++report.particles;
        report.smallest_volume = std::min(report.smallest_volume, domain.volume);
        report.largest_volume = std::max(report.largest_volume, domain.volume);
    }
}

void count_cells(const BackgroundGrid& grid, Sampling& sampling)
{
    std::set<std::pair<std::int64_t, std::int64_t>> cells;
    for (const ParticleDomain& domain : sampling.domains) {
        const Vector2 cell = (domain.centre - grid.origin) / grid.cell_size;
        cells.emplace(static_cast<std::int64_t>(std::floor(cell.y())),
                      static_cast<std::int64_t>(std::floor(cell.x())));
    }
    sampling.occupied_cells = cells.size();
    if (cells.empty()) return;
    sampling.particles_per_cell =
        static_cast<double>(sampling.domains.size()) / static_cast<double>(cells.size());
}

bool is_convex(const MeshQuad& quad)
{
    for (int k = 0; k < 4; ++k) {
        const Vector2 &before = quad.corners[k], &corner = quad.corners[(k + 1) % 4],
                      &after = quad.corners[(k + 2) % 4];
        if (!(cross(corner - before, after - corner) > 0.0)) return false;
    }
    return true;
}

ParticleDomain domain_of_quad(const MeshQuad& quad)
{
    const QuadrilateralDomain shape =
        quadrilateral_domain({quad.corners[0], quad.corners[1], quad.corners[2], quad.corners[3]});
    if (!is_convex(quad)) {
        throw InputError(
            fmt::format("the mesh has a quadrilateral at ({:.6g}, {:.6g}) that is folded, flat or "
                        "not convex\n"
                        "hint: try another quad_size, or sample a lattice",
                        shape.centroid.x(), shape.centroid.y()));
    }
    ParticleDomain domain;
    domain.centre = shape.centroid;
    domain.half_edge_1 = shape.half_edge_1;
    domain.half_edge_2 = shape.half_edge_2;
    domain.twist = shape.twist;
    domain.volume = 4.0 * cross(domain.half_edge_1, domain.half_edge_2);
    domain.region = quad.region;
    return domain;
}

} // namespace

Sampling sample_lattice(const Section& section, const BackgroundGrid& grid, int per_cell_x, int per_cell_y,
                        int boundary_refinement)
{
    ENSURE(per_cell_x >= 1 && per_cell_y >= 1 && boundary_refinement >= 1);
    Lattice lattice;
    lattice.origin = grid.origin;
    lattice.size = Vector2(grid.cell_size / per_cell_x, grid.cell_size / per_cell_y);
    lattice.columns = grid.cells_x * per_cell_x;
    lattice.rows = grid.cells_y * per_cell_y;

    std::vector<std::uint8_t> cut;
    if (boundary_refinement > 1) cut = find_cut_boxes(section, lattice);
    const RegionLocator locator(section);
    Sampling sampling;
    for (int j = 0; j < lattice.rows; ++j) {
        for (int i = 0; i < lattice.columns; ++i) {
            const int parts = !cut.empty() && cut[lattice.index(i, j)] ? boundary_refinement : 1;
            sample_box(locator, lattice.centre(i, j), lattice.size, parts, sampling.domains);
        }
    }
    correct_volumes(section, sampling);
    count_cells(grid, sampling);
    return sampling;
}

Sampling sample_mesh(const Section& section, const BackgroundGrid& grid)
{
    Sampling sampling;
    sampling.domains.reserve(section.quads.size());
    for (const MeshQuad& quad : section.quads) sampling.domains.push_back(domain_of_quad(quad));
    correct_volumes(section, sampling);
    count_cells(grid, sampling);
    return sampling;
}

} // namespace quicksand
