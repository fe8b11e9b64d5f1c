#include "geometry/section/present_section.hpp"

#include "geometry/section/region_locator.hpp"
#include "geometry/section/section_rim.hpp"

#include <algorithm>
#include <utility>

namespace quicksand {

namespace {

/// Where the ends of soil's edges divide the segment: fractions of its length, from 0 to 1.
std::vector<double> divisions_by_edges(const std::vector<Segment>& edges, const Segment& segment)
{
    constexpr double on_segment = 1e-9; // distance from the segment over its length [-]
    const Vector2 along = segment.end - segment.start;
    std::vector<double> fractions = {0.0, 1.0};
    for (const Segment& edge : edges) {
        const Vector2 to_vertex = edge.start - segment.start; // the edges of a ring begin at all its vertices
        const double fraction = to_vertex.dot(along) / along.squaredNorm();
        const bool inside = fraction > on_segment && fraction < 1.0 - on_segment;
        if (inside && (to_vertex - fraction * along).norm() < on_segment * along.norm())
            fractions.push_back(fraction);
    }
    std::sort(fractions.begin(), fractions.end());
    fractions.erase(std::unique(fractions.begin(), fractions.end()), fractions.end());
    return fractions;
}

/// The parts of a segment that have soil beside them.
void keep_beside_soil(const std::vector<Segment>& edges, const RegionLocator& soil, const Segment& segment,
                      std::vector<Segment>& kept)
{
    if (segment.start == segment.end) return;
    const std::vector<double> fractions = divisions_by_edges(edges, segment);
    const auto point = [&](double fraction) -> Vector2 {
        return fraction < 1.0 ? segment.start + fraction * (segment.end - segment.start) : segment.end;
    };
    for (std::size_t k = 0; k + 1 < fractions.size(); ++k) {
        Segment part{point(fractions[k]), point(fractions[k + 1])};
        const auto [left, right] = regions_beside(soil, part);
        if (!left && !right) continue;
        if (!left) std::swap(part.start, part.end);
        kept.push_back(part);
    }
}

} // namespace

Section without_soil_of(const std::vector<bool>& absent, const Section& section)
{
    Section present = section;
    if (std::find(absent.begin(), absent.end(), true) == absent.end()) return present;
    for (std::size_t r = 0; r < present.regions.size(); ++r)
        if (r < absent.size() && absent[r]) present.regions[r].polygons.clear();
    const std::vector<Segment> edges = divided_edges(present);
    const RegionLocator soil(present);
    for (NamedCurve& curve : present.curves) {
        std::vector<Segment> kept;
        for (const Segment& segment : curve.segments) keep_beside_soil(edges, soil, segment, kept);
        curve.segments = std::move(kept);
    }
    return present;
}

} // namespace quicksand
