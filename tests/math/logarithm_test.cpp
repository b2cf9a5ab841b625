#include "math/logarithm.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "math/portable.hpp"

namespace plumb {
namespace {

TEST(Logarithm, equalsTheStandardLibraryWithinItsStatedError) {
    for (int exponent = -44; exponent <= 38; ++exponent) {
        for (int i = 1; i < 100; ++i) {
            const auto x = static_cast<float>(std::pow(10.0, exponent) * (0.1 * i));
            if (!(x > 0.0f) || !std::isfinite(x)) continue;
            ASSERT_NEAR(static_cast<double>(logarithm10(x)), std::log10(static_cast<double>(x)), 2e-6) << x;
        }
    }
    EXPECT_EQ(logarithm10(1.0f), 0.0f);
    EXPECT_NEAR(logarithm10(std::numeric_limits<float>::max()), 38.53184f, 4e-6f);
    EXPECT_NEAR(exponential(logarithm10(123.0f) * 2.302585093f), 123.0f, 1e-3f);
}

TEST(Logarithm, isTheFloatNextToTheExactValue) {
    Random random = Random::seeded(1);
    for (int i = 0; i < 50'000; ++i) {
        const float x = std::bit_cast<float>(random.next() & 0x7fffffffu);
        if (!std::isfinite(x) || x == 0.0f) continue;
        const double exact = std::log10(double{x});
        const double half = 0.5000001 * std::ldexp(1.0, std::ilogb(exact) - 23);  // of a float's last bit
        ASSERT_NEAR(double{logarithm10(x)}, exact, std::max(half, 1e-9)) << x;
    }
}

TEST(Logarithm, hasTheSameBitsOnEveryMachine) {
    // Expected: computed on x86-64 with GCC 12; the tests above compare the values with exact ones.
    Random random = Random::seeded(2);
    std::uint64_t bits = 0;
    for (int i = 0; i < 50'000; ++i) {
        const float x =
            i % 2 == 0 ? random.between(0.5f, 2.0f) : std::bit_cast<float>(random.next() & 0x7fffffffu);
        bits = bits * 31 + std::bit_cast<std::uint32_t>(logarithm10(x));
    }
    EXPECT_EQ(bits, 12978225280506102656ull);
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
