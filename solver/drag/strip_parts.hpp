// Strips of a node's support along the axes of the grid: the parts that domains have in them, and what they
// resist together.
#pragma once

#include "solver/base/lanes.hpp"
#include "solver/drag/node_strips.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace quicksand {

/// Part of the area under the hat function of a node from its left end to t, in cells from the node [-].
inline Lanes hat_area_below(const Lanes& t)
{
    const Lanes one = all_lanes(1.0), half = all_lanes(0.5);
    const Lanes left = half * (one + t) * (one + t), right = one - half * (one - t) * (one - t);
    return t < all_lanes(0.0) ? left : right;
}

inline Lanes limited(const Lanes& t, double lower, double upper)
{
    const Lanes raised = t < all_lanes(lower) ? all_lanes(lower) : t;
    return raised > all_lanes(upper) ? all_lanes(upper) : raised;
}

/// Parts of the weight by strips, four by four [-].
using StripParts = std::array<Lanes, NodeStrips::count / 4>;

/// Of a domain from `lower` to `upper`, in cells from the node.
inline StripParts parts_of(double lower, double upper)
{
    constexpr double width = 1.0 / NodeStrips::per_cell, least = 1e-9;
    constexpr Lanes first_edges = {-1.0, -1.0 + width, -1.0 + 2.0 * width, -1.0 + 3.0 * width};
    double below[NodeStrips::count + 1]; // area under the hat function, up to the edges of the strips
    below[NodeStrips::count] = hat_area_below(all_lanes(std::clamp(1.0, lower, upper)))[0];
    StripParts parts;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const Lanes edges = first_edges + all_lanes(4.0 * width * static_cast<double>(k));
        store_lanes(hat_area_below(limited(edges, lower, upper)), below + 4 * k);
    }
    const double total = below[NodeStrips::count] - below[0];
    if (total > least) {
        for (std::size_t k = 0; k < parts.size(); ++k)
            parts[k] = (load_lanes(below + 4 * k + 1) - load_lanes(below + 4 * k)) * all_lanes(1.0 / total);
        return parts;
    }
    // the domain has next to nothing within the support: all lies in the outermost strip
    const double all_below = lower + upper < 0.0 ? 1.0 : 0.0;
    parts.fill(all_lanes(0.0));
    parts.front() = Lanes{all_below, 0.0, 0.0, 0.0};
    parts.back() = Lanes{0.0, 0.0, 0.0, 1.0 - all_below};
    return parts;
}

inline void add_parts(double amount, const StripParts& parts, double* strips)
{
    for (const Lanes& part : parts) {
        store_lanes(load_lanes(strips) + all_lanes(amount) * part, strips);
        strips += 4;
    }
}

/// (sum W)^2 / sum (W^2 / R) of the strips; zero where they are empty [N s/m2].
inline double resistance_of(const double* volume, const double* resistance)
{
    double whole = 0.0, flow = 0.0;
    for (std::size_t s = 0; s < NodeStrips::count; ++s) {
        if (!(volume[s] > 0.0) || !(resistance[s] > 0.0)) continue;
        whole += volume[s];
        flow += volume[s] * volume[s] / resistance[s];
    }
    return flow > 0.0 ? whole * whole / flow : 0.0;
}

} // namespace quicksand
