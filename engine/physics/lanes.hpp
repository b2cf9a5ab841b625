#pragma once

// SIMD lanes: constraints are packed into blocks of eight, one per lane, and the inner loops work on eight
// floats at a time. The same source is built once for each instruction set (kernels_*.cpp), each in its own
// namespace, so that the linker cannot mistake a function of one build for another's. Every operation works
// per lane and is exact or rounded as IEEE 754 prescribes, so all builds give the same bits. Kernels may only
// use functions of this file: the linker might keep the copy of an inline function of another header that was
// compiled for the wider instruction set.

#include <cstddef>
#include <cstdint>

#include "math/vec2.hpp"

#if defined(PLUMB_LANES_SCALAR)
#define PLUMB_LANES scalar
#elif defined(__AVX2__) && !defined(PLUMB_LANES_BASE)
#define PLUMB_LANES_AVX2
#define PLUMB_LANES avx2
#include <immintrin.h>
#elif defined(__SSE2__) || defined(_M_X64)
#define PLUMB_LANES sse2
#include <emmintrin.h>
#elif defined(__ARM_NEON) && defined(__aarch64__)
#define PLUMB_LANES neon
#include <arm_neon.h>
#else
#define PLUMB_LANES scalar
#define PLUMB_LANES_SCALAR
#endif

namespace plumb::physics {

inline constexpr int kLanes = 8;

/// Four floats of a body or contact, the unit that kernels gather and scatter.
struct alignas(16) Float4 {
    float x = 0.0f;
    float y = 0.0f;
    float z = 0.0f;
    float w = 0.0f;
};

/// Contacts or joints of a block: indices into the lists of the world. Entries from `count` on are unused.
struct BlockLanes {
    std::int32_t index[kLanes];
    std::int32_t count;
};

/// A vector in each lane.
struct VecLanes {
    float x[kLanes];
    float y[kLanes];

    void set(int lane, Vec2 v) { x[lane] = v.x, y[lane] = v.y; }
    [[nodiscard]] Vec2 at(int lane) const { return {x[lane], y[lane]}; }
};

namespace PLUMB_LANES {

// For each instruction set: Part is a register with some of the eight lanes, MaskPart a mask for it.

#if defined(PLUMB_LANES_SCALAR)

using Part = float;
using PartAt = const float;
using MaskPart = bool;
inline Part minOf(Part a, Part b) { return a < b ? a : b; }
inline Part maxOf(Part a, Part b) { return a > b ? a : b; }
inline Part rootOf(Part a) { return __builtin_sqrtf(a); }
inline Part chosenOf(MaskPart m, Part a, Part b) { return m ? a : b; }
inline int bitsOf(MaskPart m) { return m ? 1 : 0; }

#elif defined(PLUMB_LANES_AVX2)

using Part = __m256;
using PartAt [[gnu::vector_size(32), gnu::aligned(4), gnu::may_alias]] = float;
using MaskPart = decltype(Part{} < Part{});
inline Part minOf(Part a, Part b) { return _mm256_min_ps(a, b); }
inline Part maxOf(Part a, Part b) { return _mm256_max_ps(a, b); }
inline Part rootOf(Part a) { return _mm256_sqrt_ps(a); }
inline Part chosenOf(MaskPart m, Part a, Part b) { return _mm256_blendv_ps(b, a, reinterpret_cast<Part>(m)); }
inline int bitsOf(MaskPart m) { return _mm256_movemask_ps(reinterpret_cast<Part>(m)); }

#else  // registers of four floats

using PartAt [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = float;
#if defined(__ARM_NEON)
using Part = float32x4_t;
using MaskPart = decltype(Part{} < Part{});
inline Part rootOf(Part a) { return vsqrtq_f32(a); }
inline Part chosenOf(MaskPart m, Part a, Part b) { return vbslq_f32(reinterpret_cast<uint32x4_t>(m), a, b); }
// vminq and vmaxq treat zeros and NaN differently from the other instruction sets.
inline Part minOf(Part a, Part b) { return chosenOf(a < b, a, b); }
inline Part maxOf(Part a, Part b) { return chosenOf(a > b, a, b); }
inline int bitsOf(MaskPart m) { return static_cast<int>(vaddvq_s32(m & MaskPart{1, 2, 4, 8})); }
inline void transpose(Part& a, Part& b, Part& c, Part& d) {
    const float32x4x2_t ab = vtrnq_f32(a, b), cd = vtrnq_f32(c, d);
    a = vcombine_f32(vget_low_f32(ab.val[0]), vget_low_f32(cd.val[0]));
    b = vcombine_f32(vget_low_f32(ab.val[1]), vget_low_f32(cd.val[1]));
    c = vcombine_f32(vget_high_f32(ab.val[0]), vget_high_f32(cd.val[0]));
    d = vcombine_f32(vget_high_f32(ab.val[1]), vget_high_f32(cd.val[1]));
}
#else
using Part = __m128;
using MaskPart = decltype(Part{} < Part{});
inline Part minOf(Part a, Part b) { return _mm_min_ps(a, b); }
inline Part maxOf(Part a, Part b) { return _mm_max_ps(a, b); }
inline Part rootOf(Part a) { return _mm_sqrt_ps(a); }
inline Part chosenOf(MaskPart m, Part a, Part b) {
    const Part mask = reinterpret_cast<Part>(m);
    return _mm_or_ps(_mm_and_ps(mask, a), _mm_andnot_ps(mask, b));
}
inline int bitsOf(MaskPart m) { return _mm_movemask_ps(reinterpret_cast<Part>(m)); }
inline void transpose(Part& a, Part& b, Part& c, Part& d) { _MM_TRANSPOSE4_PS(a, b, c, d); }
#endif
#endif

inline constexpr int kLanesOfPart = static_cast<int>(sizeof(Part) / sizeof(float));
inline constexpr std::size_t kParts = kLanes / kLanesOfPart;

struct Mask8 {
    MaskPart part[kParts];
};
struct Float8 {
    Part part[kParts];
};

/// Applies a function to each part.
template <class All, class Act, class... Args>
[[gnu::always_inline]] inline All each(Act act, const Args&... args) {
    if constexpr (kParts == 1) {
        return {{act(args.part[0]...)}};
    } else if constexpr (kParts == 2) {
        return {{act(args.part[0]...), act(args.part[1]...)}};
    } else {
        All all;
        for (std::size_t i = 0; i < kParts; ++i) all.part[i] = act(args.part[i]...);
        return all;
    }
}
#define PLUMB_OPERATOR(All, Each, op)                                  \
    inline All operator op(Each a, Each b) {                           \
        return each<All>([](auto x, auto y) { return x op y; }, a, b); \
    }
PLUMB_OPERATOR(Float8, Float8, +)
PLUMB_OPERATOR(Float8, Float8, -)
PLUMB_OPERATOR(Float8, Float8, *)
PLUMB_OPERATOR(Float8, Float8, /)
PLUMB_OPERATOR(Mask8, Float8, <)
PLUMB_OPERATOR(Mask8, Float8, >)
PLUMB_OPERATOR(Mask8, Mask8, &)
PLUMB_OPERATOR(Mask8, Mask8, |)
#undef PLUMB_OPERATOR
inline Float8 operator-(Float8 a) {
    return each<Float8>([](Part x) { return -x; }, a);
}
inline Float8 min(Float8 a, Float8 b) { return each<Float8>(minOf, a, b); }
inline Float8 max(Float8 a, Float8 b) { return each<Float8>(maxOf, a, b); }
inline Float8 sqrt(Float8 a) { return each<Float8>(rootOf, a); }
inline Float8 select(Mask8 m, Float8 a, Float8 b) { return each<Float8>(chosenOf, m, a, b); }
inline Float8 all(float s) {
    return each<Float8>([s](Part zero) { return s - zero; }, Float8{});
}

inline Float8 load(const float* p) {
    Float8 r;
    __builtin_memcpy(&r, p, sizeof r);
    return r;
}
inline void store(float* p, Float8 a) { __builtin_memcpy(p, &a, sizeof a); }

inline int bits(Mask8 m) {
    int all = 0;
    for (std::size_t i = 0; i < kParts; ++i) all |= bitsOf(m.part[i]) << (static_cast<int>(i) * kLanesOfPart);
    return all;
}

/// Returns a record by its index, or by its offset in bytes, which takes fewer instructions.
inline const float* rowOf(const Float4* records, std::int32_t index) { return &records[index].x; }
inline const float* rowOf(const Float4* records, std::uint32_t offset) {
    return reinterpret_cast<const float*>(reinterpret_cast<const char*>(records) + offset);
}
inline float* rowOf(Float4* records, std::int32_t index) { return &records[index].x; }
inline float* rowOf(Float4* records, std::uint32_t offset) {
    return reinterpret_cast<float*>(reinterpret_cast<char*>(records) + offset);
}

// Always inlined: each call that is not inlined would pass eight registers through memory.

#if defined(PLUMB_LANES_AVX2)

/// Transposes a 4 x 4 block in each half of the registers.
[[gnu::always_inline]] inline void transpose(Float8 (&rows)[4]) {
    const __m256 a = rows[0].part[0], b = rows[1].part[0], c = rows[2].part[0], d = rows[3].part[0];
    const __m256 ab0 = _mm256_unpacklo_ps(a, b), ab1 = _mm256_unpackhi_ps(a, b);
    const __m256 cd0 = _mm256_unpacklo_ps(c, d), cd1 = _mm256_unpackhi_ps(c, d);
    rows[0].part[0] = _mm256_shuffle_ps(ab0, cd0, 0x44);
    rows[1].part[0] = _mm256_shuffle_ps(ab0, cd0, 0xee);
    rows[2].part[0] = _mm256_shuffle_ps(ab1, cd1, 0x44);
    rows[3].part[0] = _mm256_shuffle_ps(ab1, cd1, 0xee);
}
inline Float8 joined(const float* low, const float* high) {
    return {{_mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(low)), _mm_load_ps(high), 1)}};
}
inline __m128 halfOf(Float8 rows, int half) {
    return half == 0 ? _mm256_castps256_ps128(rows.part[0]) : _mm256_extractf128_ps(rows.part[0], 1);
}
inline void storeFour(float* p, __m128 a) { _mm_store_ps(p, a); }

#elif !defined(PLUMB_LANES_SCALAR)

[[gnu::always_inline]] inline void transpose(Float8 (&rows)[4]) {
    transpose(rows[0].part[0], rows[1].part[0], rows[2].part[0], rows[3].part[0]);
    transpose(rows[0].part[1], rows[1].part[1], rows[2].part[1], rows[3].part[1]);
}
inline Float8 joined(const float* low, const float* high) {
    return {{*reinterpret_cast<const PartAt*>(low), *reinterpret_cast<const PartAt*>(high)}};
}
inline Part halfOf(Float8 rows, int half) { return rows.part[half]; }
inline void storeFour(float* p, Part a) { *reinterpret_cast<PartAt*>(p) = a; }

#endif

/// Loads the records at eight indices or offsets and transposes them into one Float8 per member.
template <class Place>
[[gnu::always_inline]] inline void gather(const Float4* records, const Place* place, Float8 (&out)[4]) {
#if defined(PLUMB_LANES_SCALAR)
    for (int i = 0; i < kLanes; ++i) {
        for (int k = 0; k < 4; ++k) out[k].part[i] = rowOf(records, place[i])[k];
    }
#else
    for (int i = 0; i < 4; ++i) out[i] = joined(rowOf(records, place[i]), rowOf(records, place[i + 4]));
    transpose(out);
#endif
}

/// The reverse of gather(), for the first `count` lanes.
template <class Place>
[[gnu::always_inline]] inline void scatter(Float4* records, const Place* place, const Float8 (&in)[4],
                                           int count) {
#if defined(PLUMB_LANES_SCALAR)
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < 4; ++k) rowOf(records, place[i])[k] = in[k].part[i];
    }
#else
    Float8 rows[4] = {in[0], in[1], in[2], in[3]};
    transpose(rows);
    // Unrolled with an early exit, so that the rows stay in registers.
#pragma GCC unroll 8
    for (int i = 0; i < kLanes; ++i) {
        if (i >= count) return;
        storeFour(rowOf(records, place[i]), halfOf(rows[i & 3], i / 4));
    }
#endif
}

#if defined(PLUMB_LANES_AVX2)

/// Loads only x and y of each record.
[[gnu::always_inline]] inline void gatherTwo(const Float4* records, const std::uint32_t* offset, Float8& x,
                                             Float8& y) {
    const auto pair = [&](int i) {
        const auto* low = reinterpret_cast<const __m128i*>(rowOf(records, offset[i]));
        const auto* high = reinterpret_cast<const __m64*>(rowOf(records, offset[i + 1]));
        return _mm_loadh_pi(_mm_castsi128_ps(_mm_loadl_epi64(low)), high);
    };
    const __m256 even = _mm256_insertf128_ps(_mm256_castps128_ps256(pair(0)), pair(4), 1);
    const __m256 odd = _mm256_insertf128_ps(_mm256_castps128_ps256(pair(2)), pair(6), 1);
    x.part[0] = _mm256_shuffle_ps(even, odd, 0x88);
    y.part[0] = _mm256_shuffle_ps(even, odd, 0xdd);
}

/// The reverse of gatherTwo(), for the first `count` lanes.
[[gnu::always_inline]] inline void scatterTwo(Float4* records, const std::uint32_t* offset, Float8 x,
                                              Float8 y, int count) {
    const Float8 even{{_mm256_unpacklo_ps(x.part[0], y.part[0])}};
    const Float8 odd{{_mm256_unpackhi_ps(x.part[0], y.part[0])}};
    const __m128 rows[4] = {halfOf(even, 0), halfOf(odd, 0), halfOf(even, 1), halfOf(odd, 1)};
    const auto put = [&](int i) {
        auto* row = reinterpret_cast<__m64*>(rowOf(records, offset[i]));
        (i & 1) == 0 ? _mm_storel_pi(row, rows[i / 2]) : _mm_storeh_pi(row, rows[i / 2]);
    };
    if (count == kLanes) {
        for (int i = 0; i < kLanes; ++i) put(i);
        return;
    }
    for (int i = 0; i < count; ++i) put(i);
}

#else

[[gnu::always_inline]] inline void gatherTwo(const Float4* records, const std::uint32_t* offset, Float8& x,
                                             Float8& y) {
    Float8 all[4];
    gather(records, offset, all);
    x = all[0], y = all[1];
}

[[gnu::always_inline]] inline void scatterTwo(Float4* records, const std::uint32_t* offset, Float8 x,
                                              Float8 y, int count) {
    float xs[kLanes], ys[kLanes];
    store(xs, x), store(ys, y);
    for (int i = 0; i < count; ++i) {
        float* row = rowOf(records, offset[i]);
        row[0] = xs[i], row[1] = ys[i];
    }
}

#endif

inline Float8& operator+=(Float8& a, Float8 b) { return a = a + b; }
inline Float8& operator-=(Float8& a, Float8 b) { return a = a - b; }
inline Float8 abs(Float8 a) { return max(a, -a); }
inline bool any(Mask8 mask) { return bits(mask) != 0; }
inline Float8 clamp(Float8 a, Float8 low, Float8 high) { return min(max(a, low), high); }

}  // namespace PLUMB_LANES
}  // namespace plumb::physics
