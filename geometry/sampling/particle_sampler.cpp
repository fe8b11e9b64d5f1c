#include "geometry/sampling/particle_sampler.hpp"

#include "geometry/sampling/box_cutting.hpp"
#include "geometry/sampling/water_cutting.hpp"
#include "geometry/section/region_locator.hpp"
#include "solver/base/cross_product.hpp"
#include "solver/base/failure.hpp"
#include "solver/interpolation/cpdi2.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

namespace quicksand {

namespace {

/// The domain of a whole box.
ParticleDomain domain_of_box(const Lattice& lattice, int i, int j, std::size_t region)
{
    ParticleDomain domain;
    domain.centre = lattice.centre(i, j);
    domain.half_edge_1 = Vector2(0.5 * lattice.size.x(), 0.0);
    domain.half_edge_2 = Vector2(0.0, 0.5 * lattice.size.y());
    domain.volume = lattice.size.x() * lattice.size.y();
    domain.region = region;
    return domain;
}

/// Area and its moments.
struct Moments {
    double area = 0.0;                // [m2]
    Vector2 first = Vector2::Zero();  // integrals of x and of y [m3]
    Vector2 second = Vector2::Zero(); // of x^2 and y^2 [m4]
};

/// About the origin, which lies in the polygon or beside it.
Moments moments_of(const Ring& corners)
{
    Moments sum;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vector2 &a = corners[k], &b = corners[(k + 1) % corners.size()];
        const double twice = cross(a, b);
        sum.area += twice / 2.0;
        sum.first += twice / 6.0 * (a + b);
        sum.second += twice / 12.0 * (a.cwiseProduct(a) + a.cwiseProduct(b) + b.cwiseProduct(b));
    }
    return sum;
}

/// Whether a polygon in the frame of its rectangle is that rectangle.
bool is_rectangle(const std::vector<Vector2>& corners)
{
    return corners.size() == 4 && std::all_of(corners.begin(), corners.end(), [](const Vector2& corner) {
               return (corner.cwiseAbs() - Vector2::Ones()).cwiseAbs().maxCoeff() < 1e-9;
           });
}

/// The domain of a piece of the box (i, j): at its centroid, with the half edges of the rectangle of the same
/// area and the same ratio of second moments.
void add_piece(const Lattice& lattice, int i, int j, const BoxPiece& piece, Sampling& sampling)
{
    std::vector<Vector2> corners; // from the first of them, then from the centroid
    for (const Vector2& corner : piece.corners)
        corners.push_back((corner - piece.corners.front()).cwiseProduct(lattice.size));
    const Moments about_first = moments_of(corners);
    const Vector2 centroid = about_first.first / about_first.area;
    for (Vector2& corner : corners) corner -= centroid;
    const Moments moments = moments_of(corners);
    const double slimness = std::sqrt(std::sqrt(moments.second.x() / moments.second.y()));
    const Vector2 half(0.5 * std::sqrt(moments.area) * slimness, 0.5 * std::sqrt(moments.area) / slimness);
    for (Vector2& corner : corners) corner = corner.cwiseQuotient(half);

    ParticleDomain domain;
    domain.centre =
        lattice.origin + lattice.size.cwiseProduct(Vector2(i, j) + piece.corners.front()) + centroid;
    domain.half_edge_1 = Vector2(half.x(), 0.0);
    domain.half_edge_2 = Vector2(0.0, half.y());
    domain.volume = moments.area;
    domain.region = piece.region;
    domain.is_piece = true;
    if (!is_rectangle(corners)) {
        domain.shape = static_cast<std::int32_t>(sampling.shapes.size());
        sampling.shapes.push_back(make_cut_domain(std::move(corners)));
    }
    sampling.domains.push_back(domain);
}

/// Part the soil of the box (i, j) where the line runs through it.
void part_box(const LineInBoxes& line, int i, int j, CutBox& box)
{
    if (!(box.filled_by || !box.pieces.empty()) || !line.crosses(i, j)) return;
    std::vector<BoxPiece> pieces = box.pieces;
    if (box.filled_by) pieces.push_back({*box.filled_by, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
    std::vector<BoxPiece> parts = line.part(i, j, pieces);
    if (parts.size() == pieces.size()) return;
    box.filled_by.reset();
    box.pieces = std::move(parts);
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

void report_regions(const Section& section, Sampling& sampling)
{
    const std::size_t count = section.regions.size();
    sampling.regions.assign(count, {});
    const std::vector<double> sampled = sum_volumes(sampling.domains, count);
    for (std::size_t k = 0; k < count; ++k) {
        RegionSampling& report = sampling.regions[k];
        report.area = area(section.regions[k]);
        if (sampled[k] <= 0.0) continue;
        report.area_error = (sampled[k] - report.area) / report.area;
        report.smallest_volume = std::numeric_limits<double>::infinity();
    }
    for (const ParticleDomain& domain : sampling.domains) {
        RegionSampling& report = sampling.regions[domain.region];
        ++report.particles;
        report.cut += domain.is_piece ? 1 : 0;
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
                        const std::vector<WaterLine>& water_lines)
{
    ENSURE(per_cell_x >= 1 && per_cell_y >= 1);
    Lattice lattice;
    lattice.origin = grid.origin;
    lattice.size = Vector2(grid.cell_size / per_cell_x, grid.cell_size / per_cell_y);
    lattice.columns = grid.cells_x * per_cell_x;
    lattice.rows = grid.cells_y * per_cell_y;

    const std::vector<CutBox> cut = cut_boxes(section, lattice);
    std::vector<LineInBoxes> lines;
    for (const WaterLine& line : water_lines) lines.emplace_back(lattice, line);
    const RegionLocator locator(section);
    Sampling sampling;
    auto next = cut.begin();
    for (int j = 0; j < lattice.rows; ++j) {
        for (int i = 0; i < lattice.columns; ++i) {
            const std::size_t index = lattice.index(i, j);
            const bool is_cut = next != cut.end() && next->index == index;
            CutBox box = is_cut ? *next++ : CutBox{index, locator.locate(lattice.centre(i, j)), {}};
            for (const LineInBoxes& line : lines) part_box(line, i, j, box);
            if (box.filled_by) sampling.domains.push_back(domain_of_box(lattice, i, j, *box.filled_by));
            for (const BoxPiece& piece : box.pieces) add_piece(lattice, i, j, piece, sampling);
        }
    }
    report_regions(section, sampling);
    count_cells(grid, sampling);
    return sampling;
}

Sampling sample_mesh(const Section& section, const BackgroundGrid& grid)
{
    Sampling sampling;
    sampling.domains.reserve(section.quads.size());
    for (const MeshQuad& quad : section.quads) sampling.domains.push_back(domain_of_quad(quad));
    report_regions(section, sampling);
    count_cells(grid, sampling);
    return sampling;
}

} // namespace quicksand
