// The order of the interpolations, measured with manufactured solutions at large deformation.
#include "solver/verification/bodies/manufactured_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace quicksand {
namespace {

std::vector<double> errors_of(ManufacturedRun run, const std::vector<int>& cells)
{
    std::vector<double> errors;
    for (const int n : cells) {
        run.cells = n;
        errors.push_back(run_manufactured(run).displacement_error);
    }
    return errors;
}

/// Order between the first and the last of grids that halve the cells each time.
double order_of(const std::vector<double>& errors)
{
    return std::log2(errors.front() / errors.back()) / static_cast<double>(errors.size() - 1);
}

TEST(ManufacturedSolution, AxisAlignedMotionIsSecondOrderWithEveryDomainThatDeforms)
{
    for (const Interpolation interpolation :
         {Interpolation::cpgimp, Interpolation::cpdi, Interpolation::cpdi2}) {
        const auto errors = errors_of({AxisAlignedMotion{0.05}, interpolation}, {8, 16, 32});
        EXPECT_GT(order_of(errors), 1.9);
        EXPECT_LT(errors[0], 0.075);
        EXPECT_LT(errors[1], 0.018);
        EXPECT_LT(errors[2], 0.0045);
    }
}

TEST(ManufacturedSolution, AxisAlignedMotionShowsThatPointsLoseConvergence)
{
    const auto errors = errors_of({AxisAlignedMotion{0.05}, Interpolation::linear}, {8, 16, 32});
    EXPECT_LT(order_of(errors), 0.0) << "the test can fail: cell crossing makes the error grow";
}

TEST(ManufacturedSolution, VortexIsSecondOrderWithCpdiAndCpdi2)
{
    for (const Interpolation interpolation : {Interpolation::cpdi, Interpolation::cpdi2}) {
        const auto errors = errors_of({VortexMotion{0.1}, interpolation}, {24, 48, 96});
        EXPECT_GT(order_of(errors), 1.9);
        EXPECT_LT(errors[0], 0.11);
        EXPECT_LT(errors[1], 0.032);
        EXPECT_LT(errors[2], 0.006);
    }
}

TEST(ManufacturedSolution, BoxesThatKeepTheirSizeLoseAnOrderOfSecond)
{
    const auto errors = errors_of({AxisAlignedMotion{0.05}, Interpolation::gimp}, {8, 16, 32});
    EXPECT_GT(order_of(errors), 1.2);
    EXPECT_LT(order_of(errors), 1.9) << "boxes that do not follow the stretch overlap and gap";
    EXPECT_LT(errors[2], 0.022);
}

TEST(ManufacturedSolution, StrongVortexKeepsItsOrderWithCpdi)
{
    // shear strains of 3.5
    const auto errors = errors_of({VortexMotion{0.5}, Interpolation::cpdi}, {24, 48});
    EXPECT_GT(order_of(errors), 1.9);
    EXPECT_LT(errors[0], 0.11);
    EXPECT_LT(errors[1], 0.026);
}

TEST(ManufacturedSolution, LargestVortexEndsOnACoarseGrid)
{
    // shear strains of 7 across four cells: the points drift apart in a cell unless null-space modes are
    // damped as fast as they arise, and the soil gets four times as stiff
    ManufacturedRun run{VortexMotion{1.0}, Interpolation::cpdi};
    run.cells = 24;
    EXPECT_LT(run_manufactured(run).displacement_error, 0.16);
}

TEST(ManufacturedSolution, LargestVortexIsSecondOrderUpToTheLargestShear)
{
    ManufacturedRun run{VortexMotion{1.0}, Interpolation::cpdi};
    run.end_time = 0.5;
    const auto errors = errors_of(run, {24, 48});
    EXPECT_GT(order_of(errors), 1.6) << "two of 24 cells across a flank of the vortex";
    EXPECT_LT(errors[0], 0.052);
    EXPECT_LT(errors[1], 0.014);
}

} // namespace
} // namespace quicksand
