#include "math/portable.hpp"

#include <cmath>

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

}  // namespace
}  // namespace plumb
