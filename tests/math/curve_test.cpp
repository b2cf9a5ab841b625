#include "math/curve.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace plumb {
namespace {

Curve randomCurve(Random& random) {
    Curve curve = Curve::constant(random.between(-2.0f, 2.0f));
    curve.keys[0].at = random.between(0.0f, 0.2f);
    curve.shape = random.below(4) == 0 ? CurveShape::Linear : CurveShape::Smooth;
    for (std::uint32_t more = random.below(8); more > 0; --more)
        curve.insert({random.unit(), random.between(-2.0f, 2.0f)});
    return curve;
}

TEST(Curves, areExactAtTheirKeysAndStayAtTheFirstAndTheLast) {
    Random random = Random::seeded(1);
    for (int i = 0; i < 2000; ++i) {
        const Curve curve = randomCurve(random);
        for (std::size_t k = 0; k < curve.size(); ++k)
            ASSERT_EQ(curve.valueAt(curve.keys[k].at), curve.keys[k].value) << i;
        EXPECT_EQ(curve.valueAt(-1.0f), curve.keys[0].value);
        EXPECT_EQ(curve.valueAt(2.0f), curve.keys[curve.size() - 1].value);
        EXPECT_EQ(curve.valueAt(std::numeric_limits<float>::quiet_NaN()), curve.keys[0].value);
    }
}

TEST(Curves, stayBetweenAdjacentKeysAndAreMonotoneIfTheKeysAre) {
    Random random = Random::seeded(2);
    for (int i = 0; i < 2000; ++i) {
        const Curve curve = randomCurve(random);
        for (std::size_t k = 1; k < curve.size(); ++k) {
            const CurveKey from = curve.keys[k - 1];
            const CurveKey to = curve.keys[k];
            float before = from.value;
            for (int step = 1; step <= 32; ++step) {
                const float value =
                    curve.valueAt(from.at + (to.at - from.at) * static_cast<float>(step) / 32.0f);
                ASSERT_GE(value, std::min(from.value, to.value));
                ASSERT_LE(value, std::max(from.value, to.value));
                constexpr float kRounding = 1e-5f;
                const float rise = to.value > from.value ? value - before : before - value;
                ASSERT_GE(rise, -kRounding) << i;
                before = value;
            }
        }
    }
}

TEST(Curves, areStraightIfLinearAndRoundIfSmooth) {
    Curve curve = Curve::hump(0.0f, 1.0f);
    curve.shape = CurveShape::Linear;
    EXPECT_FLOAT_EQ(curve.valueAt(0.25f), 0.5f);
    curve.shape = CurveShape::Smooth;
    EXPECT_GT(curve.valueAt(0.25f), 0.55f) << "it comes to the top without an edge";
    EXPECT_NEAR(curve.valueAt(0.499f), 1.0f, 1e-4f);
    EXPECT_FLOAT_EQ(Curve::line(2.0f, 4.0f).valueAt(0.25f), 2.5f);
}

TEST(Curves, haveTheSameBitsOnEveryMachine) {
    Random random = Random::seeded(3);
    std::uint64_t bits = 0;
    for (int i = 0; i < 500; ++i) {
        const Curve curve = randomCurve(random);
        for (int step = 0; step <= 16; ++step) {
            bits = bits * 31 + std::bit_cast<std::uint32_t>(curve.valueAt(static_cast<float>(step) / 16.0f));
        }
    }
    EXPECT_EQ(bits, 7984501653428533459ull);
}

TEST(Curves, keepTheirKeysInOrder) {
    Curve curve = Curve::line(0.0f, 1.0f);
    EXPECT_EQ(curve.insert({0.5f, 3.0f}), 1u);
    EXPECT_EQ(curve.insert({0.5f, 4.0f}), Curve::kKeys) << "there is one already";
    curve.move(1, {5.0f, 2.0f});
    EXPECT_EQ(curve.keys[1], (CurveKey{1.0f - Curve::kCloseness, 2.0f}));
    curve.move(0, {0.3f, 1.0f});
    EXPECT_EQ(curve.keys[0], (CurveKey{0.3f, 1.0f}));
    while (!curve.full())
        ASSERT_LT(curve.insert({0.4f + 0.01f * static_cast<float>(curve.size()), 0.0f}), 8u);
    EXPECT_EQ(curve.insert({0.9f, 0.0f}), Curve::kKeys);
    while (curve.size() > 1) curve.remove(0);
    curve.remove(0);
    EXPECT_EQ(curve.size(), 1u);
    Curve same = Curve::constant(1.0f);
    same.keys[0].at = 1.0f;
    EXPECT_EQ(curve, same) << "what was taken out leaves nothing behind";
}

}  // namespace
}  // namespace plumb
