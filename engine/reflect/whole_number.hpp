#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace plumb {

/// The integer of 1, 2, 4 or 8 bytes at an address. Unsigned ones of 8 bytes keep their bits.
inline std::int64_t loadWhole(const void* from, std::size_t size, bool isSigned) {
    std::uint64_t bits = 0;  // little-endian machines only, as everywhere in the engine
    std::memcpy(&bits, from, size);
    const std::size_t unused = (8 - size) * 8;
    bits <<= unused;
    return isSigned ? static_cast<std::int64_t>(bits) >> unused : static_cast<std::int64_t>(bits >> unused);
}

/// Stores the low bytes of an integer.
inline void storeWhole(void* to, std::size_t size, std::uint64_t value) { std::memcpy(to, &value, size); }

}  // namespace plumb
