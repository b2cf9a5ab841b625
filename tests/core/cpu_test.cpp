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

TEST(Cpu, theWidestSetOfThisMachineIsTheDefaultAndNarrowerOnesAreSupported) {
#if defined(__x86_64__) && defined(__GNUC__)
    const bool hasAvx2 =
        __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("popcnt");
    EXPECT_TRUE(hasSimdWidth(SimdWidth::Sse2)) << "every 64-bit x86 has it";
    EXPECT_EQ(hasSimdWidth(SimdWidth::Avx2), hasAvx2);
    EXPECT_FALSE(hasSimdWidth(SimdWidth::Neon));
    EXPECT_EQ(simdWidth(), hasAvx2 ? SimdWidth::Avx2 : SimdWidth::Sse2);
#elif defined(__aarch64__) && defined(__ARM_NEON)
    EXPECT_EQ(simdWidth(), SimdWidth::Neon);
    EXPECT_FALSE(hasSimdWidth(SimdWidth::Sse2) || hasSimdWidth(SimdWidth::Avx2));
#endif
}

TEST(Cpu, noProcessorHasBothSse2AndNeon) {
    EXPECT_FALSE(hasSimdWidth(SimdWidth::Neon) && hasSimdWidth(SimdWidth::Sse2));
}

}  // namespace

}  // namespace plumb
