// CPDI weights of a tile's particles, four nodes of a row at a time.
//
// In cells counted from the domain's lower left cell, a node a of a row and a corner at x have the hat
// function max(0, 1 - |x - a|); a corner's weight is the product of its hats along x and y.
#include "solver/base/lanes.hpp"
#include "solver/interpolation/cpdi.hpp"

#include <cmath>

namespace quicksand {

namespace {

/// Values of a domain that all rows use; corners counter-clockwise as in cpdi.hpp.
struct DomainRows {
    Lanes along_x[4];              // hats of each corner over the nodes of a row
    Lanes corners_y;               // of the corners, from the stencil's lowest row [cells]
    double g1_x, g1_y, g2_x, g2_y; // gradients of the corners 1 and 2 [1/m]
};

/// With corners nearer to a grid line than `tolerance` on it [cells].
inline Lanes hats(const Lanes& distance, double tolerance)
{
    const Lanes hat = positive_part(1.0 - absolute(distance)), one = all_lanes(1.0);
    const Lanes raised = hat > all_lanes(1.0 - tolerance) ? one : hat;
    return raised < all_lanes(tolerance) ? all_lanes(0.0) : raised;
}

/// Write row b of a stencil: phi and grad phi of four nodes.
inline void write_row(const DomainRows& domain, int b, double tolerance, double* value, double* gradient_x,
                      double* gradient_y)
{
    const Lanes along_y = hats(domain.corners_y - static_cast<double>(b), tolerance);
    const Lanes N1 = along_y[0] * domain.along_x[0], N2 = along_y[1] * domain.along_x[1];
    const Lanes N3 = along_y[2] * domain.along_x[2], N4 = along_y[3] * domain.along_x[3];
    const Lanes across_1 = N1 - N3, across_2 = N2 - N4;
    store_lanes(0.25 * ((N1 + N3) + (N2 + N4)), value);
    store_lanes(domain.g1_x * across_1 + domain.g2_x * across_2, gradient_x);
    store_lanes(domain.g1_y * across_1 + domain.g2_y * across_2, gradient_y);
}

/// Corner coordinates of one axis relative to the centre, in the order of the corners, from r_1 + r_2 and
/// r_1 - r_2.
inline Lanes corner_offsets(double sum, double apart)
{
    return Lanes{-sum, apart, sum, -apart};
}

/// Where the rows of a stencil start and how far they go, along one axis.
struct Extent {
    double centre; // of the domain, from the rim [cells]
    int first;     // node
    int nodes;
};

inline Extent extent(double coordinate, double rim, double inverse, double reach)
{
    const double centre = (coordinate - rim) * inverse;
    const int first = static_cast<int>(centre - reach), last = static_cast<int>(centre + reach);
    return {centre, first, last - first + 2};
}

/// The parts of a domain with the half edges r_1 and r_2.
inline DomainRows rows_of(double r1_x, double r1_y, double r2_x, double r2_y, double inverse,
                          double tolerance, const Extent& along, const Extent& up)
{
    const double sum_x = r1_x + r2_x, sum_y = r1_y + r2_y, apart_x = r1_x - r2_x, apart_y = r1_y - r2_y;
    const double scale = 0.25 / (r1_x * r2_y - r1_y * r2_x); // 1 / V
    const Lanes nodes = {0.0, 1.0, 2.0, 3.0};
    DomainRows domain;
    domain.g1_x = scale * apart_y, domain.g1_y = scale * -apart_x;
    domain.g2_x = scale * sum_y, domain.g2_y = scale * -sum_x;
    const Lanes corners_x = (along.centre - along.first) + inverse * corner_offsets(sum_x, apart_x);
    domain.corners_y = (up.centre - up.first) + inverse * corner_offsets(sum_y, apart_y);
    for (int c = 0; c < 4; ++c) domain.along_x[c] = hats(corners_x[c] - nodes, tolerance);
    return domain;
}

/// Where the weights of a store stand, and how many it has room for.
struct WeightArrays {
    double *value, *gradient_x, *gradient_y;
    std::size_t room;
};

inline WeightArrays arrays_of(StencilStore& store)
{
    return {store.value.data(), store.gradient_x.data(), store.gradient_y.data(), store.value.size()};
}

/// Store the stencil of a domain of any size as that of the particle `k` of the tile; returns whether the
/// domain was scaled down. Apart from the loop over the usual ones, which so keeps its numbers in registers.
[[gnu::noinline]] bool put_large_domain(const BackgroundGrid& grid, const Particles& particles, std::size_t p,
                                        std::size_t k, StencilStore& store)
{
    NodeStencil stencil;
    const bool limited = Cpdi::evaluate(grid, particles, p, stencil);
    store.put(k, stencil);
    return limited;
}

} // namespace

VECTOR_KERNEL
std::int64_t weigh_parallelograms(const BackgroundGrid& grid, const Particles& particles,
                                  const CellLists& lists, const Tile& tile, StencilStore& store)
{
    constexpr int widest = 4; // nodes that a row of lanes covers
    const double rim_x = grid.rim_origin().x(), rim_y = grid.rim_origin().y();
    const double inverse = 1.0 / grid.cell_size, tolerance = grid.line_tolerance;
    const std::size_t first = lists.first_entry(tile), last = lists.last_entry(tile);
    std::int64_t limited = 0;
    store.clear_for(last - first);
    StoredStencil* const stencils = store.stencils.data();
    WeightArrays arrays = arrays_of(store);
    std::size_t used = 0;
    for (std::size_t k = 0; k < last - first; ++k) {
        const auto p = static_cast<std::size_t>(lists.order[first + k]);
        const double r1_x = particles.half_edge_1.x[p], r1_y = particles.half_edge_1.y[p];
        const double r2_x = particles.half_edge_2.x[p], r2_y = particles.half_edge_2.y[p];
        const double x = particles.position.x[p], y = particles.position.y[p];
        const Extent along = extent(x, rim_x, inverse, inverse * (std::abs(r1_x) + std::abs(r2_x)));
        const Extent up = extent(y, rim_y, inverse, inverse * (std::abs(r1_y) + std::abs(r2_y)));
        if (along.nodes > widest || up.nodes > widest) {
            store.used = used;
            limited += put_large_domain(grid, particles, p, k, store);
            used = store.used;
            arrays = arrays_of(store);
            continue;
        }
        const auto count = static_cast<std::size_t>(along.nodes * up.nodes);
        if (used + count + StencilStore::lanes > arrays.room) {
            store.used = used;
            store.extend(count);
            arrays = arrays_of(store);
        }

        const DomainRows domain = rows_of(r1_x, r1_y, r2_x, r2_y, inverse, tolerance, along, up);
        stencils[k] = {along.first, up.first, static_cast<std::int32_t>(used),
                       static_cast<std::int16_t>(along.nodes), static_cast<std::int16_t>(up.nodes)};
        for (int b = 0; b < up.nodes; ++b) {
            const std::size_t at = used + static_cast<std::size_t>(b * along.nodes);
            write_row(domain, b, tolerance, arrays.value + at, arrays.gradient_x + at,
                      arrays.gradient_y + at);
        }
        used += count;
    }
    store.used = used;
    return limited;
}

} // namespace quicksand
