#pragma once

#include <cstdint>

namespace plumb {

/// Which instructions handle several numbers at once. What is computed never depends on it, only how fast.
enum class SimdWidth : std::uint8_t {
    Scalar,
    Sse2,  ///< x86, 4 floats; every 64-bit x86 has it
    Avx2,  ///< x86, 8 floats; with the bit counting (BMI, POPCNT) that came with it
    Neon   ///< Arm, 4 floats
};

/// The widest that this build knows and this processor has, unless setSimdWidth() chose another.
SimdWidth simdWidth();

/// Chooses for whatever is made from now on; for tests. False, and nothing changes, where it cannot run.
bool setSimdWidth(SimdWidth width);

/// Whether it can run here.
bool hasSimdWidth(SimdWidth width);

}  // namespace plumb
