#include "physics/broadphase/box_searches.hpp"


#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__SSE2__)  // of WebAssembly
#include <emmintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

// For each instruction set: eight floats as compiler vectors, with the operations that the searches need.
// Each lane is computed as a single float, so results do not depend on the instruction set.

namespace plumb::physics {

namespace boxes_of_four {
namespace {

// Two vectors of four floats, which every 64-bit processor supports.
using FloatsAt [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = const float;
using WordsAt [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = const std::uint32_t;
using Four [[gnu::vector_size(16)]] = float;
using FourInts [[gnu::vector_size(16)]] = std::int32_t;

struct Floats {
    Four low, high;
};
/// Result of a comparison: each lane is -1 for true, 0 for false.
struct Mask {
    FourInts low, high;
};

inline Floats spread(float x) { return {x - Four{}, x - Four{}}; }
inline Floats load(const float* at) {
    return {*reinterpret_cast<FloatsAt*>(at), *reinterpret_cast<FloatsAt*>(at + 4)};
}
inline Floats operator+(const Floats& a, const Floats& b) { return {a.low + b.low, a.high + b.high}; }
inline Floats operator-(const Floats& a, const Floats& b) { return {a.low - b.low, a.high - b.high}; }
inline Floats operator*(const Floats& a, const Floats& b) { return {a.low * b.low, a.high * b.high}; }
inline Mask operator<=(const Floats& a, const Floats& b) { return {a.low <= b.low, a.high <= b.high}; }
inline Mask operator>(const Floats& a, const Floats& b) { return {a.low > b.low, a.high > b.high}; }
inline Mask operator&(const Mask& a, const Mask& b) { return {a.low & b.low, a.high & b.high}; }
inline Four absolute(Four a) { return reinterpret_cast<Four>(reinterpret_cast<FourInts>(a) & 0x7fffffff); }
inline Floats absolute(const Floats& a) { return {absolute(a.low), absolute(a.high)}; }
/// Returns the lanes that have a bit in common with a word.
inline Mask haveCommon(const std::uint32_t* at, std::uint32_t word) {
    return {(*reinterpret_cast<WordsAt*>(at) & word) != 0, (*reinterpret_cast<WordsAt*>(at + 4) & word) != 0};
}
inline int signsOf(FourInts lanes) {
#if defined(__SSE2__)
    return _mm_movemask_ps(reinterpret_cast<__m128>(lanes));
#elif defined(__aarch64__)
    return vaddvq_s32(lanes & FourInts{1, 2, 4, 8});
#else
    return (lanes[0] & 1) | (lanes[1] & 2) | (lanes[2] & 4) | (lanes[3] & 8);
#endif
}
/// Returns one bit for each lane.
inline std::uint32_t bitsOf(const Mask& mask) {
    return static_cast<std::uint32_t>(signsOf(mask.low) | signsOf(mask.high) << 4);
}

#define PLUMB_TARGET
#include "physics/broadphase/box_search.inl"
#undef PLUMB_TARGET

}  // namespace
}  // namespace boxes_of_four

#if defined(__x86_64__)
namespace boxes_avx2 {
namespace {

#define PLUMB_TARGET __attribute__((target("avx2,bmi,popcnt")))
using FloatsAt [[gnu::vector_size(32), gnu::aligned(4), gnu::may_alias]] = const float;
using WordsAt [[gnu::vector_size(32), gnu::aligned(4), gnu::may_alias]] = const std::uint32_t;
using Floats [[gnu::vector_size(32)]] = float;
using Mask [[gnu::vector_size(32)]] = std::int32_t;

PLUMB_TARGET inline Floats spread(float x) { return x - Floats{}; }
PLUMB_TARGET inline Floats load(const float* at) { return *reinterpret_cast<FloatsAt*>(at); }
PLUMB_TARGET inline Floats absolute(const Floats& a) {
    return reinterpret_cast<Floats>(reinterpret_cast<Mask>(a) & 0x7fffffff);
}
PLUMB_TARGET inline Mask haveCommon(const std::uint32_t* at, std::uint32_t word) {
    return (*reinterpret_cast<WordsAt*>(at) & word) != 0;
}
PLUMB_TARGET inline std::uint32_t bitsOf(const Mask& mask) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
}

#include "physics/broadphase/box_search.inl"
#undef PLUMB_TARGET

}  // namespace
}  // namespace boxes_avx2
#endif

const BoxSearches& boxSearchesFor(SimdWidth width) {
#if defined(__x86_64__)
    if (width == SimdWidth::Avx2) return boxes_avx2::kSearches;
#endif
    static_cast<void>(width);
    return boxes_of_four::kSearches;
}

}  // namespace plumb::physics
