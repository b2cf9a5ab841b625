#include "math/logarithm.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "math/portable.hpp"

namespace plumb {
namespace {

TEST(Logarithm, equalsTheStandardLibraryWithinAMillionth) {
    for (int exponent = -44; exponent <= 38; ++exponent) {
        for (int i = 1; i < 100; ++i) {
            const auto x = static_cast<float>(std::pow(10.0, exponent) * (0.1 * i));
            if (!(x > 0.0f) || !std::isfinite(x)) continue;
            ASSERT_NEAR(static_cast<double>(logarithm10(x)), std::log10(static_cast<double>(x)), 4e-6) << x;
        }
    }
    EXPECT_EQ(logarithm10(1.0f), 0.0f);
    EXPECT_NEAR(exponential(logarithm10(123.0f) * 2.302585093f), 123.0f, 1e-3f);
}

TEST(Logarithm, invalidArgumentsReturnMinus45BelowAllValidResults) {
    for (const float x :
         {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()})
        EXPECT_EQ(logarithm10(x), -45.0f);
    EXPECT_GT(logarithm10(std::numeric_limits<float>::denorm_min()), -45.0f);
    EXPECT_GT(logarithm10(std::numeric_limits<float>::infinity()), 38.0f);
}

}  // namespace
}  // namespace plumb
