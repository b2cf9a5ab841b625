// LaneHasher without SSE2, as on Arm processors, in a namespace of its own: it must give the same hashes.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

#undef __SSE2__
#undef _M_X64
#define plumb plumb_scalar
#include "core/hash.cpp"
#undef plumb

std::uint64_t hashWithoutSse2(const void* bytes, std::size_t count);

std::uint64_t hashWithoutSse2(const void* bytes, std::size_t count) {
    plumb_scalar::LaneHasher hash;
    hash.addBytes(bytes, count);
    return hash.value();
}
