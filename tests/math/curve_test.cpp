#include "math/curve.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <vector>

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

/// The value of a smooth curve by the Hermite basis with the slopes of Fritsch and Butland, in double.
double expectedValue(const Curve& curve, double at) {
    std::size_t right = 1;
    while (double{curve.keys[right].at} < at) ++right;
    const auto position = [&](std::size_t i) { return double{curve.keys[i].at}; };
    const auto value = [&](std::size_t i) { return double{curve.keys[i].value}; };
    const auto between = [&](std::size_t i) {
        return (value(i + 1) - value(i)) / (position(i + 1) - position(i));
    };
    const auto slope = [&](std::size_t i) {
        if (i == 0) return between(0);
        if (i + 1 == curve.size()) return between(i - 1);
        const double before = between(i - 1), after = between(i);
        if (before * after <= 0.0) return 0.0;
        const double left = position(i) - position(i - 1), width = position(i + 1) - position(i);
        const double share = (left + 2.0 * width) / (3.0 * (left + width));
        return before * after / (share * after + (1.0 - share) * before);
    };
    const double width = position(right) - position(right - 1), t = (at - position(right - 1)) / width;
    return value(right - 1) * (1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t) +
           value(right) * t * t * (3.0 - 2.0 * t) +
           width * t * (1.0 - t) * ((1.0 - t) * slope(right - 1) - t * slope(right));
}

TEST(Curves, equalTheFormulaOfFritschAndButland) {
    Random random = Random::seeded(5);
    for (int i = 0; i < 500; ++i) {
        Curve curve = randomCurve(random);
        if (curve.size() < 2) continue;
        curve.shape = CurveShape::Smooth;
        bool isNarrow = false;  // slopes of narrow parts are rounded more
        for (std::size_t k = 1; k < curve.size(); ++k)
            isNarrow |= curve.keys[k].at - curve.keys[k - 1].at < 0.01f;
        if (isNarrow) continue;
        const float first = curve.keys[0].at, last = curve.keys[curve.size() - 1].at;
        for (int step = 1; step < 20; ++step) {
            const float at = first + (last - first) * static_cast<float>(step) / 20.0f;
            ASSERT_NEAR(double{curve.valueAt(at)}, expectedValue(curve, double{at}), 2e-5)
                << i << " at " << at;
        }
    }
}

TEST(Curves, keepTheirKeysInOrderAndTheirUnusedKeysEmptyAfterAnyChanges) {
    Random random = Random::seeded(6);
    for (int i = 0; i < 100; ++i) {
        Curve curve = randomCurve(random);
        std::vector<CurveKey> model{curve.keys.begin(), curve.keys.begin() + curve.count};
        for (int step = 0; step < 60; ++step) {
            const std::size_t index = random.below(10);
            const CurveKey key{static_cast<float>(random.below(40)) / 39.0f, random.unit()};
            switch (random.below(3)) {
                case 0: {
                    const auto at = std::find_if(model.begin(), model.end(),
                                                 [&](const CurveKey& other) { return other.at >= key.at; });
                    const bool isNew = model.size() < Curve::kKeys && (at == model.end() || at->at != key.at);
                    const auto place = static_cast<std::size_t>(at - model.begin());
                    ASSERT_EQ(curve.insert(key), isNew ? place : Curve::kKeys);
                    if (isNew) model.insert(at, key);
                    break;
                }
                case 1:
                    curve.remove(index);
                    if (model.size() > 1 && index < model.size())
                        model.erase(model.begin() + static_cast<std::ptrdiff_t>(index));
                    break;
                default: {
                    curve.move(index, key);
                    if (index >= model.size()) break;
                    const float low = index == 0 ? 0.0f : model[index - 1].at + Curve::kCloseness;
                    const float high =
                        index + 1 == model.size() ? 1.0f : model[index + 1].at - Curve::kCloseness;
                    if (low <= high) model[index].at = std::min(std::max(key.at, low), high);
                    model[index].value = key.value;
                }
            }
            ASSERT_EQ(curve.size(), model.size());
            ASSERT_EQ(curve.full(), model.size() == Curve::kKeys);
            for (std::size_t k = 0; k < Curve::kKeys; ++k)
                ASSERT_EQ(curve.keys[k], k < model.size() ? model[k] : CurveKey{}) << "key " << k;
        }
    }
}

TEST(Curves, aKeyWithoutRoomBetweenItsNeighborsStaysAtItsPosition) {
    Curve curve = Curve::line(0.0f, 1.0f);
    curve.keys[0].at = 0.5f;
    curve.insert({0.504f, 0.0f});
    curve.insert({0.508f, 0.0f});
    curve.move(1, {0.9f, 7.0f});
    EXPECT_EQ(curve.keys[1], (CurveKey{0.504f, 7.0f}));
}

TEST(Curves, areExactAtKeysOfVeryDifferentValues) {
    for (const CurveShape shape : {CurveShape::Smooth, CurveShape::Linear}) {
        Curve curve = Curve::hump(1.7f, 1e-5f);
        curve.shape = shape;
        EXPECT_EQ(curve.valueAt(0.5f), 1e-5f) << "the sum of 1.7 and the difference is rounded";
    }
}

TEST(Curves, anInvalidCountReachesNoOtherMemory) {
    Curve curve = Curve::constant(3.0f);
    curve.count = 0;
    EXPECT_EQ(curve.valueAt(0.5f), 3.0f);
    curve.remove(0);
    EXPECT_EQ(curve.keys[0].value, 3.0f);
    curve.count = 1000;
    EXPECT_EQ(curve.size(), Curve::kKeys);
    EXPECT_EQ(curve.insert({0.3f, 1.0f}), Curve::kKeys);
    curve.move(Curve::kKeys, {0.3f, 1.0f});
    curve.remove(Curve::kKeys);
    EXPECT_EQ(curve.count, 1000u);
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
