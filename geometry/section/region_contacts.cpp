#include "geometry/section/region_contacts.hpp"

#include "geometry/section/region_locator.hpp"
#include "geometry/section/section_rim.hpp"

namespace quicksand {

std::vector<RegionContact> region_contacts(const Section& section)
{
    constexpr double aside = 1e-6; // of the edge's length [-]
    const RegionLocator locator(section);
    std::vector<RegionContact> contacts;
    for (const Segment& edge : divided_edges(section)) {
        const Vector2 along = edge.end - edge.start, middle = 0.5 * (edge.start + edge.end);
        const Vector2 to_left = aside * Vector2(-along.y(), along.x());
        const auto left = locator.locate(middle + to_left), right = locator.locate(middle - to_left);
        // each piece of edge is there once from either side
        if (left && right && *left < *right) contacts.push_back({edge, *left, *right});
    }
    return contacts;
}

} // namespace quicksand
