// CPDI weights of a tile's particles, four nodes of a row at a time.
//
// In cells counted from the domain's lower left cell, a node a of a row and a corner at x have the hat
// function max(0, 1 - |x - a|); a corner's weight is the product of its hats along x and y.
#include "solver/cpdi.hpp"
#include "solver/lanes.hpp"

#include <cmath>

namespace quicksand {

namespace {

/// Parts of a domain that the rows share; corners counter-clockwise as in cpdi.hpp.
struct DomainRows {
    Lanes along_x[4];              // hats of each corner over the nodes of a row
    Lanes corners_y;               // of the corners, from the patch's lowest row [cells]
    double g1_x, g1_y, g2_x, g2_y; // gradients of the corners 1 and 2 [1/m]
};

inline Lanes hats(const Lanes& distance)
{
    return positive_part(1.0 - absolute(distance));
}

/// Write row b of a patch: phi and grad phi of four nodes.
inline void write_row(const DomainRows& domain, int b, double* value, double* gradient_x, double* gradient_y)
{
    const Lanes along_y = hats(domain.corners_y - static_cast<double>(b));
    const Lanes N1 = along_y[0] * domain.along_x[0], N2 = along_y[1] * domain.along_x[1];
    const Lanes N3 = along_y[2] * domain.along_x[2], N4 = along_y[3] * domain.along_x[3];
    const Lanes across_1 = N1 - N3, across_2 = N2 - N4;
    store_lanes(0.25 * ((N1 + N3) + (N2 + N4)), value);
    store_lanes(domain.g1_x * across_1 + domain.g2_x * across_2, gradient_x);
    store_lanes(domain.g1_y * across_1 + domain.g2_y * across_2, gradient_y);
}

/// Corner coordinates of one axis relative to the centre, in the order of the corners.
inline Lanes corner_offsets(double r1, double r2)
{
    return Lanes{-r1 - r2, r1 - r2, r1 + r2, r2 - r1};
}

/// Where the rows of a patch start and how far they go, along one axis.
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

} // namespace

VECTOR_KERNEL
std::int64_t weigh_parallelograms(const BackgroundGrid& grid, const Particles& particles,
                                  const CellLists& lists, const Tile& tile, PatchStore& store)
{
    constexpr int widest = 4; // nodes that a row of lanes covers
    const Vector2 rim = grid.rim_origin();
    const double h = grid.cell_size, inverse = 1.0 / h;
    const int columns = grid.nodes_x();
    const Lanes nodes = {0.0, 1.0, 2.0, 3.0};
    std::int64_t limited = 0;
    store.clear_for(lists.last_entry(tile) - lists.first_entry(tile));
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        const double r1_x = particles.half_edge_1.x[p], r1_y = particles.half_edge_1.y[p];
        const double r2_x = particles.half_edge_2.x[p], r2_y = particles.half_edge_2.y[p];
        const double x = particles.position.x[p], y = particles.position.y[p];
        const Extent along = extent(x, rim.x(), inverse, inverse * (std::abs(r1_x) + std::abs(r2_x)));
        const Extent up = extent(y, rim.y(), inverse, inverse * (std::abs(r1_y) + std::abs(r2_y)));
        if (along.nodes > widest || up.nodes > widest) {
            NodePatch patch;
            limited += Cpdi::evaluate(grid, particles, p, patch);
            store.push_back(patch);
            continue;
        }

        const double scale = 0.25 / (r1_x * r2_y - r1_y * r2_x); // 1 / V
        DomainRows domain;
        domain.g1_x = scale * (r1_y - r2_y), domain.g1_y = scale * (r2_x - r1_x);
        domain.g2_x = scale * (r1_y + r2_y), domain.g2_y = -scale * (r1_x + r2_x);
        const Lanes corners_x = (along.centre - along.first) + inverse * corner_offsets(r1_x, r2_x);
        domain.corners_y = (up.centre - up.first) + inverse * corner_offsets(r1_y, r2_y);
        for (int c = 0; c < 4; ++c) domain.along_x[c] = hats(corners_x[c] - nodes);

        const int count = along.nodes * up.nodes;
        store.extend(static_cast<std::size_t>(count));
        store.patches.push_back({up.first * columns + along.first, static_cast<std::int16_t>(along.nodes),
                                 static_cast<std::int16_t>(up.nodes), static_cast<std::int32_t>(store.used),
                                 rim.x() + along.first * h - x, rim.y() + up.first * h - y});
        for (int b = 0; b < up.nodes; ++b) {
            const std::size_t at = store.used + static_cast<std::size_t>(b * along.nodes);
            write_row(domain, b, &store.value[at], &store.gradient_x[at], &store.gradient_y[at]);
        }
        store.used += static_cast<std::size_t>(count);
    }
    return limited;
}

} // namespace quicksand
