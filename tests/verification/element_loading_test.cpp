// Every test of the laboratory over densities, stresses and K_0: it ends, and its numbers are numbers.
#include "solver/element/element_loading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

std::vector<ElementLoading> all_loadings(double stress)
{
    return {StressCycles{0.1, 10.0, 0.1, 2.0},
            StressCycles{0.6, 5.0, 0.1, 2.0},
            StrainCycles{1e-5, 3.0},
            StrainCycles{0.01, 3.0},
            MonotonicShear{Drainage::undrained, 0.05},
            MonotonicShear{Drainage::drained, 0.02},
            BiaxialCompression{Drainage::undrained, 0.05},
            BiaxialCompression{Drainage::drained, 0.02},
            OedometerLoading{{4.0 * stress, 0.3 * stress, 8.0 * stress}},
            IsotropicLoading{{4.0 * stress, 0.3 * stress}}};
}

bool is_finite(const ElementPoint& point)
{
    return std::isfinite(point.gamma) && std::isfinite(point.strain_x) && std::isfinite(point.strain_y) &&
           std::isfinite(point.tau) && std::isfinite(point.mean_stress()) &&
           std::isfinite(point.deviator_stress()) && std::isfinite(point.ru);
}

TEST(ElementLoading, CanBeFollowedForAnySandStressAndK0)
{
    for (const double n1_60 : {1.0, 8.0, 30.0}) {
        const UbcSand law = make_ubcsand(ubcsand_from_blow_count(n1_60));
        for (const double stress : {5e3, 100e3, 1e6}) {
            for (const double k0 : {0.35, 1.0, 2.0}) {
                for (const ElementLoading& loading : all_loadings(stress)) {
                    const CyclicTest test = perform(law, {stress, k0}, loading);
                    EXPECT_GE(test.path.size(), 2u);
                    EXPECT_TRUE(std::all_of(test.path.begin(), test.path.end(), is_finite))
                        << "(N1)60 " << n1_60 << ", stress " << stress << ", k0 " << k0 << ", loading "
                        << loading.index();
                }
            }
        }
    }
}

} // namespace
} // namespace quicksand
