#include "app/step_clock.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace plumb {
namespace {

TEST(StepClock, anHourHasTheSameNumberOfTicksAtAnyDisplayRate) {
    for (const double rate : {24.0, 30.0, 59.94, 60.0, 75.0, 120.0, 144.0, 240.0}) {
        SCOPED_TRACE(rate);
        StepClock clock;
        long ticks = 0;
        const auto frames = static_cast<long>(600.0 * rate);
        for (long i = 0; i < frames; ++i) {
            ticks += clock.advance(1.0 / rate).ticks;
        }
        EXPECT_NEAR(static_cast<double>(ticks), static_cast<double>(frames) / rate * 60.0, 1.0);
    }
}

TEST(StepClock, aConstantSpeedSpriteMovesEvenlyOnDisplaysFrom30To240Hz) {
    constexpr double kSpeed = 120.0;  // px/s
    for (const double rate : {30.0, 60.0, 75.0, 100.0, 144.0, 240.0}) {
        SCOPED_TRACE(rate);
        StepClock clock;
        long tick = 0;
        double before = 0.0;
        for (int i = 0; i < 2000; ++i) {
            const auto frame = clock.advance(1.0 / rate);
            tick += frame.ticks;
            const double drawn =
                (static_cast<double>(tick - 1) + static_cast<double>(frame.alpha)) * kSpeed / 60.0;
            if (i > 10) {
                ASSERT_NEAR((drawn - before) / (kSpeed / rate), 1.0, 0.01);
            }
            before = drawn;
        }
    }
}

TEST(StepClock, aLongPauseIsClampedToAQuarterSecond) {
    StepClock clock;
    EXPECT_EQ(clock.advance(0.25).ticks, 15);
    EXPECT_EQ(clock.advance(3600.0).ticks, 15);
    EXPECT_EQ(clock.advance(1.0 / 60.0).ticks, 1);
}

TEST(StepClockProperty, alphaStaysBetweenZeroAndOneForAnyFrameTimes) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        StepClock clock;
        for (int i = 0; i < 1000; ++i) {
            const auto frame = clock.advance(static_cast<double>(random.between(-0.1f, 0.4f)));
            ASSERT_GE(frame.alpha, 0.0f);
            ASSERT_LE(frame.alpha, 1.0f);
            ASSERT_GE(frame.ticks, 0);
            ASSERT_LE(frame.ticks, StepClock::kMostTicks);
        }
        EXPECT_EQ(clock.advance(std::numeric_limits<double>::quiet_NaN()).ticks, 0);
    }
}

TEST(StepClock, aJitteringFrameTimeSnapsToTheDisplayAndARealHitchDoesNot) {
    EXPECT_DOUBLE_EQ(snappedToRefresh(0.0168, 60.0), 1.0 / 60.0);
    EXPECT_DOUBLE_EQ(snappedToRefresh(0.0331, 60.0), 2.0 / 60.0);
    EXPECT_DOUBLE_EQ(snappedToRefresh(0.0250, 60.0), 0.0250);
    EXPECT_DOUBLE_EQ(snappedToRefresh(0.5, 60.0), 0.5);
    EXPECT_DOUBLE_EQ(snappedToRefresh(0.016, 0.0), 0.016);
}

}  // namespace
}  // namespace plumb
