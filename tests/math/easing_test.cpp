#include "math/easing.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace plumb {
namespace {

constexpr int kCount = static_cast<int>(Ease::BounceOut) + 1;

TEST(Easing, startsAtZeroAndEndsAtOneExactly) {
    for (int i = 0; i < kCount; ++i) {
        const auto ease = static_cast<Ease>(i);
        for (const float before : {-1.0f, 0.0f, std::numeric_limits<float>::quiet_NaN()})
            EXPECT_EQ(eased(ease, before), 0.0f) << i;
        for (const float after : {1.0f, 2.0f, std::numeric_limits<float>::infinity()})
            EXPECT_EQ(eased(ease, after), 1.0f) << i;
    }
}

TEST(Easing, hasNoJumps) {
    for (int i = 0; i < kCount; ++i) {
        const auto ease = static_cast<Ease>(i);
        float before = 0.0f;
        for (int step = 1; step <= 10'000; ++step) {
            const float now = eased(ease, static_cast<float>(step) * 1e-4f);
            // The steepest curve is Elastic: 10 ln 2 + 2 pi / 0.3 at most, below 30 per unit of time.
            EXPECT_LT(std::abs(now - before), 30e-4f) << "curve " << i << " at " << step;
            before = now;
        }
    }
}

TEST(Easing, outIsInReversedAndInOutIsSymmetric) {
    for (int step = 0; step <= 100; ++step) {
        const float t = static_cast<float>(step) / 100.0f;
        EXPECT_NEAR(eased(Ease::QuadOut, t), 1.0f - eased(Ease::QuadIn, 1.0f - t), 1e-6f);
        EXPECT_NEAR(eased(Ease::CubicOut, t), 1.0f - eased(Ease::CubicIn, 1.0f - t), 1e-6f);
        EXPECT_NEAR(eased(Ease::SineOut, t), 1.0f - eased(Ease::SineIn, 1.0f - t), 1e-6f);
        EXPECT_NEAR(eased(Ease::BackOut, t), 1.0f - eased(Ease::BackIn, 1.0f - t), 1e-6f);
        for (const Ease ease : {Ease::QuadInOut, Ease::CubicInOut, Ease::SineInOut, Ease::BackInOut})
            EXPECT_NEAR(eased(ease, t), 1.0f - eased(ease, 1.0f - t), 1e-6f);
    }
    EXPECT_EQ(eased(Ease::QuadIn, 0.5f), 0.25f);
    EXPECT_EQ(eased(Ease::CubicIn, 0.5f), 0.125f);
    EXPECT_NEAR(eased(Ease::SineIn, 1.0f / 3.0f), 1.0f - std::cos(0.5235988f), 1e-6f);
}

TEST(Easing, backExceedsItsEndByATenth) {
    float highest = 0.0f;
    for (int step = 0; step <= 1000; ++step)
        highest = std::max(highest, eased(Ease::BackOut, static_cast<float>(step) * 1e-3f));
    EXPECT_NEAR(highest, 1.1f, 1e-3f);
}

}  // namespace
}  // namespace plumb
