#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace plumb {

/// FNV-1a over the characters: the id of a name or text, the same on every machine.
constexpr std::uint64_t hashText(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325ull;
    for (const char c : text) {
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    }
    return hash;
}

/// Mixes all bits of a word. Source: S. Vigna, "splitmix64", 2015.
constexpr std::uint64_t mixBits(std::uint64_t word) {
    word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9ull;
    word = (word ^ (word >> 27)) * 0x94d049bb133111ebull;
    return word ^ (word >> 31);
}

/// Hashes a sequence of values to 64 bits: the hash of a simulation state. Floats are
/// hashed by value: -0 as 0 and all NaNs as one value, so that equal states have equal hashes.
class Hasher {
public:
    void add(std::uint64_t word) { state_ = mixBits(state_ ^ word) + 0x9e3779b97f4a7c15ull; }
    void add(float value) {
        const float canonical = value == 0.0f ? 0.0f : value;
        add(std::uint64_t{canonical != canonical ? 0x7fc00000u : std::bit_cast<std::uint32_t>(canonical)});
    }
    void add(std::string_view text) { add(hashText(text)); }

    /// Raw memory, for types without padding.
    void addBytes(const void* bytes, std::size_t count) {
        const auto* at = static_cast<const unsigned char*>(bytes);
        for (; count >= 8; at += 8, count -= 8) {
            std::uint64_t word = 0;
            std::memcpy(&word, at, 8);
            add(word);
        }
        std::uint64_t rest = count;
        for (; count > 0; ++at, --count) {
            rest = rest << 8 | *at;
        }
        add(rest);
    }

    [[nodiscard]] std::uint64_t value() const { return mixBits(state_); }

private:
    std::uint64_t state_ = 0x243f6a8885a308d3ull;
};

/// Hashes large blocks of memory to 64 bits at memory bandwidth, by sixteen independent
/// hashes. Floats are hashed by their bits.
/// Source of the step: G. Marsaglia, "Random number generators", 2003 (multiply with carry).
class LaneHasher {
public:
    void add(std::uint64_t word) { single_ = mixBits(single_ ^ word) + 0x9e3779b97f4a7c15ull; }

    /// Raw memory, for types without padding. The length is hashed too.
    void addBytes(const void* bytes, std::size_t count);

    [[nodiscard]] std::uint64_t value() const;

private:
    static constexpr std::size_t kLanes = 16;
    static constexpr std::size_t kBlock = 8 * kLanes;  // bytes

    void addBlocks(const unsigned char* at, std::size_t blocks);

    static constexpr std::array<std::uint64_t, kLanes> startOfLanes() {
        std::array<std::uint64_t, kLanes> lanes{};
        for (std::size_t i = 0; i < kLanes; ++i) lanes[i] = mixBits(i + 1);
        return lanes;
    }

    std::array<std::uint64_t, kLanes> lanes_ = startOfLanes();
    std::uint64_t single_ = 0x243f6a8885a308d3ull;
};

}  // namespace plumb
