// What a run says of a motion that leaves its base where it should not be.
#include "app/run/motion_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace quicksand {
namespace {

TEST(DriftWarning, OfARecordWithAVelocityAtItsEnd)
{
    const SampledMotion kick{0.01, {0.0, 1.0, 1.0, 0.0}};
    EXPECT_EQ(warn_of_drift(kick),
              "Warning: the motion leaves the base with a velocity of 0.02 m/s. "
              "That velocity should be zero: the record's baseline is off; see motion.baseline");
    EXPECT_EQ(warn_of_drift(SampledMotion{0.01, {0.0, 1.0, 0.0, -1.0, 0.0}}), "");
}

TEST(DriftWarning, OfASineThatBeginsAtOnce)
{
    SineMotion sine{1.0, 2.0, 8.0, 0.0};
    EXPECT_EQ(warn_of_drift(sine),
              "Warning: the motion leaves the base with a displacement of 0.32 m. "
              "The base has drifted: motion.ramp_cycles and motion.ramp_down_cycles bring it back to rest");
    sine.cycles = std::numeric_limits<double>::infinity();
    EXPECT_EQ(warn_of_drift(sine), "") << "it never ends";
    EXPECT_EQ(warn_of_drift(BaseMotion()), "");
}

TEST(CoarseRows, AreToldWhereTheirMeansMissPeaks)
{
    const SineMotion sine{1.0, 8.0, 8.0, 0.0};
    EXPECT_EQ(warn_of_coarse_rows(sine, 0.08),
              "Warning: probes write a row every 0.08 s, and the motion has frequencies of 8 Hz: "
              "accelerations are means "
              "from row to row and miss its peaks; output.probe_interval = 0.01 would show them");
    EXPECT_EQ(warn_of_coarse_rows(sine, 0.03), "");
    EXPECT_EQ(warn_of_coarse_rows(sine, 0.0), "") << "there are no probes";
    EXPECT_EQ(warn_of_coarse_rows(BaseMotion(), 1.0), "");
}

} // namespace
} // namespace quicksand
