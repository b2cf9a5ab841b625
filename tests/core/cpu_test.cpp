#include "core/cpu.hpp"

#include <gtest/gtest.h>

namespace plumb {

namespace {

TEST(Cpu, theSelectedInstructionSetIsUsedAndUnsupportedOnesAreRejected) {
    const SimdWidth usual = simdWidth();
    EXPECT_TRUE(hasSimdWidth(usual));
    EXPECT_TRUE(hasSimdWidth(SimdWidth::Scalar));
    for (const SimdWidth width : {SimdWidth::Scalar, SimdWidth::Sse2, SimdWidth::Avx2, SimdWidth::Neon}) {
        ASSERT_TRUE(setSimdWidth(SimdWidth::Scalar));
        EXPECT_EQ(setSimdWidth(width), hasSimdWidth(width));
        EXPECT_EQ(simdWidth(), hasSimdWidth(width) ? width : SimdWidth::Scalar);
    }
    setSimdWidth(usual);
}

TEST(Cpu, noProcessorHasBothSse2AndNeon) {
    EXPECT_FALSE(hasSimdWidth(SimdWidth::Neon) && hasSimdWidth(SimdWidth::Sse2));
}

}  // namespace

}  // namespace plumb
