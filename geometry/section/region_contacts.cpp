#include "geometry/section/region_contacts.hpp"

#include "geometry/section/region_locator.hpp"
#include "geometry/section/section_rim.hpp"

namespace quicksand {

std::vector<RegionContact> region_contacts(const Section& section)
{
    const RegionLocator locator(section);
    std::vector<RegionContact> contacts;
    for (const Segment& edge : divided_edges(section)) {
        const auto [left, right] = regions_beside(locator, edge);
        // each piece of edge is there once from either side
        if (left && right && *left < *right) contacts.push_back({edge, *left, *right});
    }
    return contacts;
}

} // namespace quicksand
