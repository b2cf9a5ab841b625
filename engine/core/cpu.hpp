#pragma once

#include <cstdint>

namespace plumb {

/// The SIMD instruction set in use. It affects speed only, never results.
enum class SimdWidth : std::uint8_t {
    Scalar,
    Sse2,  ///< x86, 4 floats; every 64-bit x86 has it
    Avx2,  ///< x86, 8 floats; including the bit instructions (BMI, POPCNT) of the same generation
    Neon   ///< Arm, 4 floats
};

/// Returns the widest set that this build and this processor support, or the one of setSimdWidth().
SimdWidth simdWidth();

/// Selects a width for objects created from now on; for tests. Returns false if it is not supported.
bool setSimdWidth(SimdWidth width);

/// True if this machine supports it.
bool hasSimdWidth(SimdWidth width);

}  // namespace plumb
