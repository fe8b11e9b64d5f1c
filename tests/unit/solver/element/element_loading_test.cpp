#include "solver/base/failure.hpp"
#include "solver/element/element_loading.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

TEST(ElementLoading, AStressIsHeldAcrossTheJumpsOfTheSubsteps)
{
    // found by random tests: the stress is not continuous in the strain where the number of substeps changes
    const UbcSand law = make_ubcsand(ubcsand_from_blow_count(8.0));
    const CyclicTest test = perform(law, {5e3, 1.0}, OedometerLoading{{20e3, 1.6e3, 50e3}});
    EXPECT_NEAR(test.path.back().sigma_y, 50e3, 1e-4 * 50e3);
    for (const ElementPoint& point : test.path) EXPECT_EQ(point.strain_x, 0.0);
}

TEST(ElementLoading, StressesBelowTheLeastOfTheModelAreRefused)
{
    const UbcSand law = make_ubcsand(nevada_sand_55());
    EXPECT_THROW(perform(law, {100e3, 1.0}, IsotropicLoading{{200.0}}), InputError);
    EXPECT_THROW(perform(law, {300.0, 1.0}, MonotonicShear{}), InputError);
}

} // namespace
} // namespace quicksand
