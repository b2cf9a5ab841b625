#include "math/easing.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
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

/// The curves by R. Penner's formulas, in double with the system's functions.
double expectedEase(Ease ease, double t) {
    const double pi = std::acos(-1.0);
    const auto back = [](double x, double excess) { return x * x * ((excess + 1.0) * x - excess); };
    const auto bounce = [](double x) {  // height 1 - the parabola around the middle of each part
        constexpr double kParts[][3] = {
            {4.0, 0.0, 0.0}, {8.0, 6.0, 0.75}, {10.0, 9.0, 0.9375}, {11.0, 10.5, 0.984375}};
        for (const auto& [end, middle, low] : kParts) {
            if (x <= end / 11.0) return std::pow((11.0 * x - middle) / 4.0, 2) + low;
        }
        return 1.0;
    };
    switch (ease) {
        case Ease::Linear: return t;
        case Ease::QuadIn: return std::pow(t, 2);
        case Ease::QuadOut: return t * (2.0 - t);
        case Ease::QuadInOut: return t < 0.5 ? 2.0 * t * t : 1.0 - 2.0 * std::pow(1.0 - t, 2);
        case Ease::CubicIn: return std::pow(t, 3);
        case Ease::CubicOut: return std::pow(t - 1.0, 3) + 1.0;
        case Ease::CubicInOut: return t < 0.5 ? 4.0 * t * t * t : 1.0 - 4.0 * std::pow(1.0 - t, 3);
        case Ease::SineIn: return 1.0 - std::cos(t * pi / 2.0);
        case Ease::SineOut: return std::sin(t * pi / 2.0);
        case Ease::SineInOut: return (1.0 - std::cos(t * pi)) / 2.0;
        case Ease::BackIn: return back(t, 1.70158);
        case Ease::BackOut: return 1.0 - back(1.0 - t, 1.70158);
        case Ease::BackInOut: {
            const double half = back(t < 0.5 ? 2.0 * t : 2.0 - 2.0 * t, 1.70158 * 1.525) / 2.0;
            return t < 0.5 ? half : 1.0 - half;
        }
        case Ease::ElasticOut: return std::pow(2.0, -10.0 * t) * std::sin((t - 0.075) * 2.0 * pi / 0.3) + 1.0;
        case Ease::BounceOut: return bounce(t);
    }
    return -1.0;
}

TEST(Easing, equalsPennersFormulas) {
    for (int i = 0; i < kCount; ++i) {
        for (int step = 1; step < 1000; ++step) {
            const float t = static_cast<float>(step) * 1e-3f;
            ASSERT_NEAR(double{eased(static_cast<Ease>(i), t)}, expectedEase(static_cast<Ease>(i), double{t}),
                        2e-6)
                << "curve " << i << " at " << t;
        }
    }
}

TEST(Easing, bounceTouchesItsEndBetweenItsParts) {
    for (const float part : {1.0f, 2.0f, 2.5f}) EXPECT_EQ(eased(Ease::BounceOut, part / 2.75f), 1.0f) << part;
}

TEST(Easing, hasTheSameBitsOnEveryMachine) {
    // Expected: computed on x86-64 with GCC 12; the tests above compare the values with exact ones.
    std::uint64_t bits = 0;
    for (int i = 0; i < kCount; ++i) {
        for (int step = 0; step <= 1024; ++step) {
            const float value = eased(static_cast<Ease>(i), static_cast<float>(step) / 1024.0f);
            bits = bits * 31 + std::bit_cast<std::uint32_t>(value);
        }
    }
    EXPECT_EQ(bits, 4734398756708077584ull);
}

TEST(Easing, backExceedsItsEndByATenth) {
    float highest = 0.0f;
    for (int step = 0; step <= 1000; ++step)
        highest = std::max(highest, eased(Ease::BackOut, static_cast<float>(step) * 1e-3f));
    EXPECT_NEAR(highest, 1.1f, 1e-3f);
}

}  // namespace
}  // namespace plumb
