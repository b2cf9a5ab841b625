#pragma once

#include <cstdint>

namespace plumb {

/// A seeded generator with the same numbers on every machine. Plain data: restoring a
/// snapshot of the state that contains it repeats its numbers. Source: M. O'Neill, "PCG:
/// A Family of Simple Fast Space-Efficient Statistically Good Algorithms", 2014 (PCG32).
struct Random {
    static constexpr std::uint64_t kIncrement = 0xda3e39cb94b95bdbull;

    std::uint64_t state = 0x853c49e6748fea9bull;

    static constexpr Random seeded(std::uint64_t seed) {
        Random random{seed + kIncrement};
        static_cast<void>(random.next());
        return random;
    }

    /// Returns a uniform 32-bit number.
    constexpr std::uint32_t next() {
        const std::uint64_t old = state;
        state = old * 6364136223846793005ull + kIncrement;
        const auto shifted = static_cast<std::uint32_t>(((old >> 18u) ^ old) >> 27u);
        const auto turn = static_cast<std::uint32_t>(old >> 59u);
        return (shifted >> turn) | (shifted << ((32u - turn) & 31u));
    }

    constexpr std::uint64_t next64() {
        const std::uint64_t high = next();
        return high << 32 | next();
    }

    /// Uniform in 0..count-1; 0 when count is 0.
    constexpr std::uint32_t below(std::uint32_t count) {
        return static_cast<std::uint32_t>((std::uint64_t{next()} * count) >> 32);
    }

    /// Uniform in [0, 1), in multiples of 2^-24.
    constexpr float unit() { return static_cast<float>(next() >> 8) * 0x1p-24f; }

    /// Uniform in [low, high).
    constexpr float between(float low, float high) { return low + (high - low) * unit(); }
};

}  // namespace plumb
