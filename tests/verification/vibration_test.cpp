// The finite elements that are the reference of large vibrations, against published and independent numbers.
#include "solver/verification/bodies/elastic_block.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

/// E = 1 MPa, nu = 0.3, 1050 kg/m3.
SolidBody block(double width, double height)
{
    SolidBody body;
    body.law = NeoHookean{1e6 / 2.6, 0.3};
    body.density = 1050.0;
    body.upper = {width, height};
    return body;
}

TEST(ElasticBlock, BarAndCantileverAgreeWithIndependentElements)
{
    // another program's elements of the same kind: -1.650 m of the bar with 8, -3.744 m of the cantilever
    // with 4
    BlockSupports hung, clamped;
    hung.fixed_y[BlockSupports::top] = true;
    clamped.fixed_x[BlockSupports::left] = clamped.fixed_y[BlockSupports::left] = true;
    const Peak bar = first_peak(drop_block(block(1.0, 1.0), hung, 1000.0, 8, {0.5, 0.0}));
    EXPECT_NEAR(bar.displacement, -1.650, 0.0005);
    const Peak tip = first_peak(drop_block(block(4.0, 1.0), clamped, 10.0, 4, {4.0, 0.5}));
    EXPECT_NEAR(tip.displacement, -3.744, 0.0005);
    EXPECT_NEAR(tip.time, 1.085, 0.01);
}

TEST(ElasticBlock, BarBetweenWallsSwingsAsInOneDimension)
{
    // uniaxial strain, an independent solution: -1.40417 m at 0.08615 s
    BlockSupports supports;
    supports.fixed_y[BlockSupports::top] = true;
    supports.fixed_x[BlockSupports::left] = supports.fixed_x[BlockSupports::right] = true;
    const Peak peak = first_peak(drop_block(block(1.0, 1.0), supports, 1000.0, 32, {0.5, 0.0}));
    EXPECT_NEAR(peak.displacement, -1.40417, 0.001);
    EXPECT_NEAR(peak.time, 0.08615, 0.0005);
}

TEST(ElasticBlock, SmallStaticSagOfABarIsThatOfHooke)
{
    // suddenly applied gravity swings to twice the static sag rho g H^2 / (2 M)
    SolidBody body = block(0.25, 1.0);
    BlockSupports supports;
    supports.fixed_y[BlockSupports::top] = true;
    supports.fixed_x[BlockSupports::left] = supports.fixed_x[BlockSupports::right] = true;
    const Peak peak = first_peak(drop_block(body, supports, 0.01, 8, {0.125, 0.0}));
    const double sag = body.density * 0.01 / (2.0 * constrained_modulus(body.law));
    EXPECT_NEAR(peak.displacement, -2.0 * sag, 0.01 * sag);
    EXPECT_NEAR(peak.time, 2.0 / std::sqrt(constrained_modulus(body.law) / body.density), 0.005);
}

} // namespace
} // namespace quicksand
