#pragma once

// SIMD lanes: constraints are packed into blocks of eight, one per lane, and the inner loops work on eight
// floats at a time. The same source is built once for each instruction set (kernels_*.cpp), each in its own
// namespace, so that the linker cannot mistake a function of one build for another's. Every operation works
// per lane and is exact or rounded as IEEE 754 prescribes, so all builds give the same bits. Kernels may use
// only what is defined here: an inline function of another header would be built for the wider machine too,
// and the linker might keep that copy.

#include <cstdint>

#if defined(PLUMB_LANES_SCALAR)
#define PLUMB_LANES scalar
#define PLUMB_LANES_NAME "scalar"
#elif defined(__AVX2__) && !defined(PLUMB_LANES_BASE)
#define PLUMB_LANES_AVX2
#define PLUMB_LANES avx2
#define PLUMB_LANES_NAME "avx2"
#include <immintrin.h>
#elif defined(__SSE2__) || defined(_M_X64)
#define PLUMB_LANES sse2
#define PLUMB_LANES_NAME "sse2"
#include <emmintrin.h>
#elif defined(__ARM_NEON) && defined(__aarch64__)
#define PLUMB_LANES neon
#define PLUMB_LANES_NAME "neon"
#include <arm_neon.h>
#else
#define PLUMB_LANES scalar
#define PLUMB_LANES_NAME "scalar"
#define PLUMB_LANES_SCALAR
#endif

namespace plumb::physics {

inline constexpr int kLanes = 8;

/// What kernels gather and scatter: four floats of a body or contact.
struct alignas(16) Float4 {
    float x = 0.0f;
    float y = 0.0f;
    float z = 0.0f;
    float w = 0.0f;
};

namespace PLUMB_LANES {

#if defined(PLUMB_LANES_SCALAR)

struct Mask8 {
    bool lane[kLanes];
};
struct Float8 {
    float lane[kLanes];
};

#define PLUMB_EACH_LANE for (int i = 0; i < kLanes; ++i)
inline Float8 load(const float* p) {
    Float8 r;
    PLUMB_EACH_LANE r.lane[i] = p[i];
    return r;
}
inline void store(float* p, Float8 a) { PLUMB_EACH_LANE p[i] = a.lane[i]; }
inline Float8 all(float s) {
    Float8 r;
    PLUMB_EACH_LANE r.lane[i] = s;
    return r;
}
#define PLUMB_LANEWISE(signature, type, expression) \
    inline type signature {                         \
        type r;                                     \
        PLUMB_EACH_LANE r.lane[i] = expression;     \
        return r;                                   \
    }
PLUMB_LANEWISE(operator+(Float8 a, Float8 b), Float8, a.lane[i] + b.lane[i])
PLUMB_LANEWISE(operator-(Float8 a, Float8 b), Float8, a.lane[i] - b.lane[i])
PLUMB_LANEWISE(operator*(Float8 a, Float8 b), Float8, a.lane[i] * b.lane[i])
PLUMB_LANEWISE(operator/(Float8 a, Float8 b), Float8, a.lane[i] / b.lane[i])
PLUMB_LANEWISE(operator-(Float8 a), Float8, -a.lane[i])
PLUMB_LANEWISE(min(Float8 a, Float8 b), Float8, a.lane[i] < b.lane[i] ? a.lane[i] : b.lane[i])
PLUMB_LANEWISE(max(Float8 a, Float8 b), Float8, a.lane[i] > b.lane[i] ? a.lane[i] : b.lane[i])
PLUMB_LANEWISE(sqrt(Float8 a), Float8, __builtin_sqrtf(a.lane[i]))
PLUMB_LANEWISE(operator<(Float8 a, Float8 b), Mask8, a.lane[i] < b.lane[i])
PLUMB_LANEWISE(operator>(Float8 a, Float8 b), Mask8, a.lane[i] > b.lane[i])
PLUMB_LANEWISE(operator&(Mask8 a, Mask8 b), Mask8, a.lane[i] && b.lane[i])
PLUMB_LANEWISE(operator|(Mask8 a, Mask8 b), Mask8, a.lane[i] || b.lane[i])
PLUMB_LANEWISE(select(Mask8 m, Float8 a, Float8 b), Float8, m.lane[i] ? a.lane[i] : b.lane[i])
#undef PLUMB_LANEWISE
inline int bits(Mask8 m) {
    int r = 0;
    PLUMB_EACH_LANE r |= m.lane[i] ? 1 << i : 0;
    return r;
}

// Inlined by force: a compiler that sees many calls of gather() and scatter() would make functions of them,
// and eight registers would go through memory each time.

/// Loads the records at eight indices and transposes them into one register set per member.
[[gnu::always_inline]] inline void gather(const Float4* records, const std::int32_t* index,
                                          Float8 (&out)[4]) {
    PLUMB_EACH_LANE {
        const Float4& record = records[index[i]];
        out[0].lane[i] = record.x;
        out[1].lane[i] = record.y;
        out[2].lane[i] = record.z;
        out[3].lane[i] = record.w;
    }
}
/// The reverse, for the first `count` lanes.
[[gnu::always_inline]] inline void scatter(Float4* records, const std::int32_t* index, const Float8 (&in)[4],
                                           int count) {
    for (int i = 0; i < count; ++i) {
        records[index[i]] = {in[0].lane[i], in[1].lane[i], in[2].lane[i], in[3].lane[i]};
    }
}

/// As gather(), with byte offsets, which takes fewer instructions.
[[gnu::always_inline]] inline void gatherAt(const Float4* records, const std::uint32_t* offset,
                                            Float8 (&out)[4]) {
    std::int32_t index[kLanes];
    PLUMB_EACH_LANE index[i] = static_cast<std::int32_t>(offset[i] / sizeof(Float4));
    gather(records, index, out);
}
/// Only x and y of each record.
[[gnu::always_inline]] inline void gatherTwoAt(const Float4* records, const std::uint32_t* offset, Float8& x,
                                               Float8& y) {
    PLUMB_EACH_LANE {
        const Float4& record = records[offset[i] / sizeof(Float4)];
        x.lane[i] = record.x, y.lane[i] = record.y;
    }
}
/// The reverse, for the first `count` lanes.
[[gnu::always_inline]] inline void scatterTwoAt(Float4* records, const std::uint32_t* offset, Float8 x,
                                                Float8 y, int count) {
    for (int i = 0; i < count; ++i) {
        Float4& record = records[offset[i] / sizeof(Float4)];
        record.x = x.lane[i], record.y = y.lane[i];
    }
}
#undef PLUMB_EACH_LANE

#elif defined(PLUMB_LANES_AVX2)

struct Mask8 {
    __m256 v;
};
struct Float8 {
    __m256 v;
};

inline Float8 load(const float* p) { return {_mm256_loadu_ps(p)}; }
inline void store(float* p, Float8 a) { _mm256_storeu_ps(p, a.v); }
inline Float8 all(float s) { return {_mm256_set1_ps(s)}; }
inline Float8 operator+(Float8 a, Float8 b) { return {_mm256_add_ps(a.v, b.v)}; }
inline Float8 operator-(Float8 a, Float8 b) { return {_mm256_sub_ps(a.v, b.v)}; }
inline Float8 operator*(Float8 a, Float8 b) { return {_mm256_mul_ps(a.v, b.v)}; }
inline Float8 operator/(Float8 a, Float8 b) { return {_mm256_div_ps(a.v, b.v)}; }
inline Float8 operator-(Float8 a) { return {_mm256_xor_ps(a.v, _mm256_set1_ps(-0.0f))}; }
inline Float8 min(Float8 a, Float8 b) { return {_mm256_min_ps(a.v, b.v)}; }
inline Float8 max(Float8 a, Float8 b) { return {_mm256_max_ps(a.v, b.v)}; }
inline Float8 sqrt(Float8 a) { return {_mm256_sqrt_ps(a.v)}; }
inline Mask8 operator<(Float8 a, Float8 b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)}; }
inline Mask8 operator>(Float8 a, Float8 b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_GT_OQ)}; }
inline Mask8 operator&(Mask8 a, Mask8 b) { return {_mm256_and_ps(a.v, b.v)}; }
inline Mask8 operator|(Mask8 a, Mask8 b) { return {_mm256_or_ps(a.v, b.v)}; }
inline Float8 select(Mask8 m, Float8 a, Float8 b) { return {_mm256_blendv_ps(b.v, a.v, m.v)}; }
inline int bits(Mask8 m) { return _mm256_movemask_ps(m.v); }

inline __m256 pairOf(const Float4* records, std::int32_t low, std::int32_t high) {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(&records[low].x)),
                                _mm_load_ps(&records[high].x), 1);
}
/// Transposes four 4 x 4 blocks, in each half of the registers.
[[gnu::always_inline]] inline void transpose(__m256& a, __m256& b, __m256& c, __m256& d) {
    const __m256 ab0 = _mm256_unpacklo_ps(a, b), ab1 = _mm256_unpackhi_ps(a, b);
    const __m256 cd0 = _mm256_unpacklo_ps(c, d), cd1 = _mm256_unpackhi_ps(c, d);
    a = _mm256_shuffle_ps(ab0, cd0, 0x44);
    b = _mm256_shuffle_ps(ab0, cd0, 0xee);
    c = _mm256_shuffle_ps(ab1, cd1, 0x44);
    d = _mm256_shuffle_ps(ab1, cd1, 0xee);
}
[[gnu::always_inline]] inline void gather(const Float4* records, const std::int32_t* index,
                                          Float8 (&out)[4]) {
    for (int i = 0; i < 4; ++i) out[i].v = pairOf(records, index[i], index[i + 4]);
    transpose(out[0].v, out[1].v, out[2].v, out[3].v);
}
[[gnu::always_inline]] inline void scatter(Float4* records, const std::int32_t* index, const Float8 (&in)[4],
                                           int count) {
    __m256 row[4] = {in[0].v, in[1].v, in[2].v, in[3].v};
    transpose(row[0], row[1], row[2], row[3]);
    if (count == kLanes) {
        for (int i = 0; i < 4; ++i) {
            _mm_store_ps(&records[index[i]].x, _mm256_castps256_ps128(row[i]));
            _mm_store_ps(&records[index[i + 4]].x, _mm256_extractf128_ps(row[i], 1));
        }
        return;
    }
    for (int i = 0; i < count; ++i) {
        const __m256 from = row[i & 3];
        _mm_store_ps(&records[index[i]].x,
                     i < 4 ? _mm256_castps256_ps128(from) : _mm256_extractf128_ps(from, 1));
    }
}

inline const float* rowAt(const Float4* records, std::uint32_t offset) {
    return reinterpret_cast<const float*>(reinterpret_cast<const char*>(records) + offset);
}
inline __m64* twoAt(Float4* records, std::uint32_t offset) {
    return reinterpret_cast<__m64*>(reinterpret_cast<char*>(records) + offset);
}
[[gnu::always_inline]] inline void gatherAt(const Float4* records, const std::uint32_t* offset,
                                            Float8 (&out)[4]) {
    for (int i = 0; i < 4; ++i) {
        out[i].v = _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(rowAt(records, offset[i]))),
                                        _mm_load_ps(rowAt(records, offset[i + 4])), 1);
    }
    transpose(out[0].v, out[1].v, out[2].v, out[3].v);
}
[[gnu::always_inline]] inline void gatherTwoAt(const Float4* records, const std::uint32_t* offset, Float8& x,
                                               Float8& y) {
    const auto pair = [&](int i) {
        const auto* low = reinterpret_cast<const __m128i*>(rowAt(records, offset[i]));
        const auto* high = reinterpret_cast<const __m64*>(rowAt(records, offset[i + 1]));
        return _mm_loadh_pi(_mm_castsi128_ps(_mm_loadl_epi64(low)), high);
    };
    const __m256 even = _mm256_insertf128_ps(_mm256_castps128_ps256(pair(0)), pair(4), 1);
    const __m256 odd = _mm256_insertf128_ps(_mm256_castps128_ps256(pair(2)), pair(6), 1);
    x.v = _mm256_shuffle_ps(even, odd, 0x88);
    y.v = _mm256_shuffle_ps(even, odd, 0xdd);
}
[[gnu::always_inline]] inline void scatterTwoAt(Float4* records, const std::uint32_t* offset, Float8 x,
                                                Float8 y, int count) {
    const __m256 even = _mm256_unpacklo_ps(x.v, y.v), odd = _mm256_unpackhi_ps(x.v, y.v);
    const __m128 rows[4] = {_mm256_castps256_ps128(even), _mm256_castps256_ps128(odd),
                            _mm256_extractf128_ps(even, 1), _mm256_extractf128_ps(odd, 1)};
    if (count == kLanes) {
        for (int i = 0; i < 4; ++i) {
            _mm_storel_pi(twoAt(records, offset[2 * i]), rows[i]);
            _mm_storeh_pi(twoAt(records, offset[2 * i + 1]), rows[i]);
        }
        return;
    }
    for (int i = 0; i < count; ++i) {
        (i & 1) == 0 ? _mm_storel_pi(twoAt(records, offset[i]), rows[i / 2])
                     : _mm_storeh_pi(twoAt(records, offset[i]), rows[i / 2]);
    }
}

#else  // two registers of four

#if defined(__ARM_NEON)
using Four = float32x4_t;
using FourMask = uint32x4_t;
inline Four four(float s) { return vdupq_n_f32(s); }
inline Four loadFour(const float* p) { return vld1q_f32(p); }
inline void storeFour(float* p, Four a) { vst1q_f32(p, a); }
inline Four addFour(Four a, Four b) { return vaddq_f32(a, b); }
inline Four subFour(Four a, Four b) { return vsubq_f32(a, b); }
inline Four mulFour(Four a, Four b) { return vmulq_f32(a, b); }
inline Four divFour(Four a, Four b) { return vdivq_f32(a, b); }
inline Four negFour(Four a) { return vnegq_f32(a); }
inline Four sqrtFour(Four a) { return vsqrtq_f32(a); }
inline FourMask lessFour(Four a, Four b) { return vcltq_f32(a, b); }
inline FourMask andFour(FourMask a, FourMask b) { return vandq_u32(a, b); }
inline FourMask orFour(FourMask a, FourMask b) { return vorrq_u32(a, b); }
inline Four selectFour(FourMask m, Four a, Four b) { return vbslq_f32(m, a, b); }
// vminq and vmaxq treat zeros and NaN differently from the other instruction sets.
inline Four minFour(Four a, Four b) { return selectFour(lessFour(a, b), a, b); }
inline Four maxFour(Four a, Four b) { return selectFour(lessFour(b, a), a, b); }
inline int bitsFour(FourMask m) {
    const std::uint32_t one[4] = {1, 2, 4, 8};
    return static_cast<int>(vaddvq_u32(vandq_u32(m, vld1q_u32(one))));
}
inline void transposeFour(Four& a, Four& b, Four& c, Four& d) {
    const float32x4x2_t ab = vtrnq_f32(a, b), cd = vtrnq_f32(c, d);
    a = vcombine_f32(vget_low_f32(ab.val[0]), vget_low_f32(cd.val[0]));
    b = vcombine_f32(vget_low_f32(ab.val[1]), vget_low_f32(cd.val[1]));
    c = vcombine_f32(vget_high_f32(ab.val[0]), vget_high_f32(cd.val[0]));
    d = vcombine_f32(vget_high_f32(ab.val[1]), vget_high_f32(cd.val[1]));
}
#else
using Four = __m128;
using FourMask = __m128;
inline Four four(float s) { return _mm_set1_ps(s); }
inline Four loadFour(const float* p) { return _mm_loadu_ps(p); }
inline void storeFour(float* p, Four a) { _mm_storeu_ps(p, a); }
inline Four addFour(Four a, Four b) { return _mm_add_ps(a, b); }
inline Four subFour(Four a, Four b) { return _mm_sub_ps(a, b); }
inline Four mulFour(Four a, Four b) { return _mm_mul_ps(a, b); }
inline Four divFour(Four a, Four b) { return _mm_div_ps(a, b); }
inline Four negFour(Four a) { return _mm_xor_ps(a, _mm_set1_ps(-0.0f)); }
inline Four sqrtFour(Four a) { return _mm_sqrt_ps(a); }
inline FourMask lessFour(Four a, Four b) { return _mm_cmplt_ps(a, b); }
inline FourMask andFour(FourMask a, FourMask b) { return _mm_and_ps(a, b); }
inline FourMask orFour(FourMask a, FourMask b) { return _mm_or_ps(a, b); }
inline Four selectFour(FourMask m, Four a, Four b) {
    return _mm_or_ps(_mm_and_ps(m, a), _mm_andnot_ps(m, b));
}
inline Four minFour(Four a, Four b) { return _mm_min_ps(a, b); }
inline Four maxFour(Four a, Four b) { return _mm_max_ps(a, b); }
inline int bitsFour(FourMask m) { return _mm_movemask_ps(m); }
inline void transposeFour(Four& a, Four& b, Four& c, Four& d) { _MM_TRANSPOSE4_PS(a, b, c, d); }
#endif

struct Mask8 {
    FourMask low, high;
};
struct Float8 {
    Four low, high;
};

inline Float8 load(const float* p) { return {loadFour(p), loadFour(p + 4)}; }
inline void store(float* p, Float8 a) { storeFour(p, a.low), storeFour(p + 4, a.high); }
inline Float8 all(float s) { return {four(s), four(s)}; }
inline Float8 operator+(Float8 a, Float8 b) { return {addFour(a.low, b.low), addFour(a.high, b.high)}; }
inline Float8 operator-(Float8 a, Float8 b) { return {subFour(a.low, b.low), subFour(a.high, b.high)}; }
inline Float8 operator*(Float8 a, Float8 b) { return {mulFour(a.low, b.low), mulFour(a.high, b.high)}; }
inline Float8 operator/(Float8 a, Float8 b) { return {divFour(a.low, b.low), divFour(a.high, b.high)}; }
inline Float8 operator-(Float8 a) { return {negFour(a.low), negFour(a.high)}; }
inline Float8 min(Float8 a, Float8 b) { return {minFour(a.low, b.low), minFour(a.high, b.high)}; }
inline Float8 max(Float8 a, Float8 b) { return {maxFour(a.low, b.low), maxFour(a.high, b.high)}; }
inline Float8 sqrt(Float8 a) { return {sqrtFour(a.low), sqrtFour(a.high)}; }
inline Mask8 operator<(Float8 a, Float8 b) { return {lessFour(a.low, b.low), lessFour(a.high, b.high)}; }
inline Mask8 operator>(Float8 a, Float8 b) { return b < a; }
inline Mask8 operator&(Mask8 a, Mask8 b) { return {andFour(a.low, b.low), andFour(a.high, b.high)}; }
inline Mask8 operator|(Mask8 a, Mask8 b) { return {orFour(a.low, b.low), orFour(a.high, b.high)}; }
inline Float8 select(Mask8 m, Float8 a, Float8 b) {
    return {selectFour(m.low, a.low, b.low), selectFour(m.high, a.high, b.high)};
}
inline int bits(Mask8 m) { return bitsFour(m.low) | bitsFour(m.high) << 4; }

[[gnu::always_inline]] inline void gather(const Float4* records, const std::int32_t* index,
                                          Float8 (&out)[4]) {
    for (int i = 0; i < 4; ++i) {
        out[i].low = loadFour(&records[index[i]].x);
        out[i].high = loadFour(&records[index[i + 4]].x);
    }
    transposeFour(out[0].low, out[1].low, out[2].low, out[3].low);
    transposeFour(out[0].high, out[1].high, out[2].high, out[3].high);
}
[[gnu::always_inline]] inline void scatter(Float4* records, const std::int32_t* index, const Float8 (&in)[4],
                                           int count) {
    Four row[8] = {in[0].low,  in[1].low,  in[2].low,  in[3].low,
                   in[0].high, in[1].high, in[2].high, in[3].high};
    transposeFour(row[0], row[1], row[2], row[3]);
    transposeFour(row[4], row[5], row[6], row[7]);
    for (int i = 0; i < count; ++i) storeFour(&records[index[i]].x, row[i]);
}

[[gnu::always_inline]] inline void gatherAt(const Float4* records, const std::uint32_t* offset,
                                            Float8 (&out)[4]) {
    const auto row = [&](int i) {
        return loadFour(reinterpret_cast<const float*>(reinterpret_cast<const char*>(records) + offset[i]));
    };
    for (int i = 0; i < 4; ++i) out[i] = {row(i), row(i + 4)};
    transposeFour(out[0].low, out[1].low, out[2].low, out[3].low);
    transposeFour(out[0].high, out[1].high, out[2].high, out[3].high);
}
[[gnu::always_inline]] inline void gatherTwoAt(const Float4* records, const std::uint32_t* offset, Float8& x,
                                               Float8& y) {
    Float8 all[4];
    gatherAt(records, offset, all);
    x = all[0], y = all[1];
}
[[gnu::always_inline]] inline void scatterTwoAt(Float4* records, const std::uint32_t* offset, Float8 x,
                                                Float8 y, int count) {
    float xs[kLanes], ys[kLanes];
    store(xs, x), store(ys, y);
    for (int i = 0; i < count; ++i) {
        auto* row = reinterpret_cast<float*>(reinterpret_cast<char*>(records) + offset[i]);
        row[0] = xs[i], row[1] = ys[i];
    }
}

#endif

inline Float8& operator+=(Float8& a, Float8 b) { return a = a + b; }
inline Float8& operator-=(Float8& a, Float8 b) { return a = a - b; }
inline Float8 abs(Float8 a) { return max(a, -a); }
inline bool any(Mask8 mask) { return bits(mask) != 0; }
/// For code that is written once for float and Float8.
template <class F>
F all(float s) {
    return all(s);
}
inline Float8 clamp(Float8 a, Float8 low, Float8 high) { return min(max(a, low), high); }

}  // namespace PLUMB_LANES
}  // namespace plumb::physics
