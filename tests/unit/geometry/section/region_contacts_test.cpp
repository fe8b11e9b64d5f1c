#include "geometry/section/region_contacts.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

TEST(RegionContacts, AreTheCommonEdgesOnce)
{
    // a box of 2 x 2, one of 1 x 1 beside it against a part of its side, and one that touches none of them
    Section section;
    section.regions = {{"left", {{{{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}}, {}}}},
                       {"right", {{{{2.0, 0.5}, {3.0, 0.5}, {3.0, 1.5}, {2.0, 1.5}}, {}}}},
                       {"apart", {{{{5.0, 0.0}, {6.0, 0.0}, {6.0, 1.0}}, {}}}}};
    const std::vector<RegionContact> contacts = region_contacts(section);
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_EQ(contacts[0].left, 0U);
    EXPECT_EQ(contacts[0].right, 1U);
    EXPECT_EQ(contacts[0].edge.start, Vector2(2.0, 0.5));
    EXPECT_EQ(contacts[0].edge.end, Vector2(2.0, 1.5));
}

} // namespace
} // namespace quicksand
