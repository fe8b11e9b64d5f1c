#include "io/frames/observation_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {

TEST(ObservationClock, StrikesAtMultiplesAndAtTheEnd)
{
    ObservationClock clock(0.4, 1.0);
    const double expected[] = {0.0, 0.4, 0.8, 1.0};
    for (const double time : expected) {
        EXPECT_EQ(clock.next(), time);
        clock.advance();
    }
    EXPECT_TRUE(std::isinf(clock.next()));
}

TEST(ObservationClock, TimesOfDifferentIntervalsCoincideExactly)
{
    ObservationClock coarse(0.1, 100.0), fine(0.005, 100.0);
    for (int k = 0; k < 500; ++k) {
        EXPECT_EQ(coarse.next(), fine.next());
        coarse.advance();
        for (int m = 0; m < 20; ++m) fine.advance();
    }
}

TEST(ObservationClock, AMultipleThatMissesTheEndByRoundingIsTheEnd)
{
    ObservationClock clock(1.0 / 3.0, 2.0);
    int strikes = 0;
    for (; std::isfinite(clock.next()); clock.advance()) ++strikes;
    EXPECT_EQ(strikes, 7);
}

TEST(ObservationClock, StrikesEveryNanosecondAtMost)
{
    ObservationClock clock(2.5e-10, 5e-9);
    double last = -1.0;
    int strikes = 0;
    for (; std::isfinite(clock.next()); clock.advance()) {
        EXPECT_GT(clock.next(), last);
        last = clock.next();
        ++strikes;
    }
    EXPECT_EQ(strikes, 6);
}

TEST(ObservationClock, GoesOnAfterWhatWasObserved)
{
    ObservationClock clock(0.1, 1.0);
    clock.go_on(0.3, 0.2);
    EXPECT_EQ(clock.next(), 0.3);
    clock.go_on(0.3, 0.3);
    EXPECT_EQ(clock.next(), 0.4);
    clock.go_on(0.35, 0.3);
    EXPECT_EQ(clock.next(), 0.4);
    clock.go_on(1.0, 1.0);
    EXPECT_TRUE(std::isinf(clock.next()));
}

TEST(ObservationClock, NoIntervalNeverStrikes)
{
    ObservationClock clock(0.0, 1.0);
    clock.go_on(0.5, std::nullopt);
    EXPECT_TRUE(std::isinf(clock.next()));
}

} // namespace quicksand
