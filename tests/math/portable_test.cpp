#include "math/portable.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace plumb {
namespace {

TEST(Portable, sineAndCosineStayWithinTheirStatedErrorOfTheExactValue) {
    Random random = Random::seeded(1);
    for (int i = 0; i < 200'000; ++i) {
        const float angle = random.between(-1.0e5f, 1.0e5f) * (i % 2 == 0 ? 1.0f : 1.0e-4f);
        const SinCos rotation = sinCos(angle);
        ASSERT_NEAR(rotation.sin, std::sin(static_cast<double>(angle)), 1.5e-7) << angle;
        ASSERT_NEAR(rotation.cos, std::cos(static_cast<double>(angle)), 1.5e-7) << angle;
    }
}

TEST(Portable, arcTangentStaysWithinItsStatedErrorInAllQuadrants) {
    Random random = Random::seeded(2);
    for (int i = 0; i < 200'000; ++i) {
        const float y = random.between(-3.0f, 3.0f);
        const float x = random.between(-3.0f, 3.0f);
        ASSERT_NEAR(arcTangent(y, x), std::atan2(static_cast<double>(y), static_cast<double>(x)), 4.0e-7);
    }
    EXPECT_EQ(arcTangent(0.0f, 0.0f), 0.0f);
    EXPECT_FLOAT_EQ(arcTangent(0.0f, -1.0f), kPi);
}

TEST(Portable, exponentialStaysWithinItsStatedErrorAndNeverOverflows) {
    for (float x = -86.0f; x < 88.0f; x += 0.01f) {
        const double exact = std::exp(static_cast<double>(x));
        ASSERT_NEAR(exponential(x) / exact, 1.0, 1.0e-6) << x;
    }
    EXPECT_TRUE(std::isfinite(exponential(1.0e30f)));
    EXPECT_EQ(exponential(-1.0e30f), 0.0f);
}

TEST(Portable, hugeAnglesAndNonFiniteNumbersHaveDefinedResults) {
    EXPECT_EQ(sine(std::nanf("")), 0.0f);
    EXPECT_EQ(cosine(INFINITY), 1.0f);
    EXPECT_EQ(floorToInt(std::nanf("")), 0);
    EXPECT_EQ(floorToInt(1.0e30f), 1 << 30);
    EXPECT_EQ(floorToInt(-0.5f), -1);
}

TEST(Portable, limitsAreExact) {
    const float billion = 1.0e9f;
    EXPECT_EQ(sine(billion), 0.0f);
    EXPECT_EQ(cosine(-billion), 1.0f);
    const float below = std::nextafter(billion, 0.0f);
    EXPECT_NEAR(sine(below), std::sin(double{below}), 1e-5);
    EXPECT_NEAR(exponential(-87.0f) / std::exp(-87.0), 1.0, 1e-6);
    EXPECT_EQ(exponential(std::nextafter(-87.0f, -100.0f)), 0.0f);
    EXPECT_NEAR(exponential(88.0f) / std::exp(88.0), 1.0, 1e-6);
    EXPECT_EQ(exponential(std::nextafter(88.0f, 100.0f)), std::numeric_limits<float>::max());
    EXPECT_EQ(exponential(std::nanf("")), 0.0f);
    EXPECT_EQ(exponential(0.0f), 1.0f);
}

TEST(Portable, arcTangentIsExactOnTheAxesAndDiagonals) {
    for (const float size : {1e-30f, 1.0f, 1e30f}) {
        for (int eighth = -4; eighth <= 4; ++eighth) {
            constexpr float kX[] = {-1.0f, -1.0f, 0.0f, 1.0f, 1.0f, 1.0f, 0.0f, -1.0f, -1.0f};
            constexpr float kY[] = {0.0f, -1.0f, -1.0f, -1.0f, 0.0f, 1.0f, 1.0f, 1.0f, 0.0f};
            const float angle = arcTangent(kY[eighth + 4] * size, kX[eighth + 4] * size);
            const auto exact = static_cast<float>(eighth * std::acos(-1.0) / 4.0);
            EXPECT_EQ(angle, eighth == -4 ? kPi : exact) << eighth << " " << size;
            EXPECT_TRUE(eighth != 0 || !std::signbit(angle));
        }
    }
    EXPECT_EQ(arcTangent(std::nanf(""), 1.0f), 0.0f);
}

TEST(Portable, floorToIntIsTheLargestIntegerNotAbove) {
    Random random = Random::seeded(4);
    for (int i = 0; i < 10'000; ++i) {
        const float x = random.between(-1.0e6f, 1.0e6f) * (i % 2 == 0 ? 1.0f : 1.0e-5f);
        ASSERT_EQ(floorToInt(x), static_cast<int>(std::floor(x)));
    }
    EXPECT_EQ(floorToInt(-1.0e30f), -(1 << 30));
    EXPECT_EQ(floorToInt(1073741760.0f), 1073741760) << "the largest float below 2^30";
    EXPECT_EQ(floorToInt(-1073741760.0f), -1073741760);
    EXPECT_EQ(floorToInt(7.0f), 7);
    EXPECT_EQ(floorToInt(-7.0f), -7);
}

TEST(Portable, hasTheSameBitsOnEveryMachine) {
    // Expected: computed on x86-64 with GCC 12; the tests above compare the values with exact ones.
    Random random = Random::seeded(5);
    std::uint64_t sines = 0, angles = 0, powers = 0;
    const auto add = [](std::uint64_t& bits, float value) {
        bits = bits * 31 + std::bit_cast<std::uint32_t>(value);
    };
    for (int i = 0; i < 50'000; ++i) {
        const SinCos rotation = sinCos(random.between(-10.0f, 10.0f));
        add(sines, rotation.sin), add(sines, rotation.cos);
        const float y = random.between(-1.0f, 1.0f);
        add(angles, arcTangent(y, random.between(-1.0f, 1.0f)));
        add(powers, exponential(random.between(-87.0f, 88.0f)));
    }
    EXPECT_EQ(sines, 457230890829864888ull);
    EXPECT_EQ(angles, 5325618397884769919ull);
    EXPECT_EQ(powers, 14909745434382750522ull);
}

}  // namespace
}  // namespace plumb
