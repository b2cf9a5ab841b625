#pragma once

#include <cmath>
#include <cstdint>

#if defined(__x86_64__) || defined(_M_X64)
#define PLUMB_HAS_SSE2
#include <immintrin.h>
#elif defined(__aarch64__) && defined(__ARM_NEON)
#define PLUMB_HAS_NEON
#include <arm_neon.h>
#endif

#if defined(PLUMB_HAS_SSE2) && defined(__GNUC__)
#define PLUMB_AVX2 __attribute__((target("avx2,bmi,popcnt")))
#else
#define PLUMB_AVX2
#endif

// Eight floats (and eight words) with the operations that the searches need, for each instruction set. Each
// lane is computed exactly as a single float would be, so results do not depend on the instruction set.
// Preconditions: no NaN in least() and most(); values to round are within 2^30; load() reads from multiples
// of 32 bytes, loadAny() from any address.

namespace plumb::physics {

namespace boxes_scalar {

struct Floats {
    float lane[8];
};
struct Words {
    std::uint32_t word;
};
using Mask = std::uint32_t;  // one bit for each lane

inline Floats load(const float* at) {
    Floats all;
    for (int i = 0; i < 8; ++i) all.lane[i] = at[i];
    return all;
}
inline Floats loadAny(const float* at) { return load(at); }
inline Floats spread(float x) { return {{x, x, x, x, x, x, x, x}}; }
inline Words spread(std::uint32_t word) { return {word}; }
inline Floats minus(const Floats& a, const Floats& b) {
    Floats all;
    for (int i = 0; i < 8; ++i) all.lane[i] = a.lane[i] - b.lane[i];
    return all;
}
inline Floats plus(const Floats& a, const Floats& b) {
    Floats all;
    for (int i = 0; i < 8; ++i) all.lane[i] = a.lane[i] + b.lane[i];
    return all;
}
inline Floats times(const Floats& a, const Floats& b) {
    Floats all;
    for (int i = 0; i < 8; ++i) all.lane[i] = a.lane[i] * b.lane[i];
    return all;
}
inline Floats roundedDown(const Floats& a) {
    Floats all;
    for (int i = 0; i < 8; ++i) all.lane[i] = std::floor(a.lane[i]);
    return all;
}
inline void storeWhole(const Floats& a, std::int32_t* to) {
    for (int i = 0; i < 8; ++i) to[i] = static_cast<std::int32_t>(a.lane[i]);
}
inline Floats minimum(const Floats& a, const Floats& b) {
    Floats all;
    for (int i = 0; i < 8; ++i) all.lane[i] = a.lane[i] < b.lane[i] ? a.lane[i] : b.lane[i];
    return all;
}
inline Floats maximum(const Floats& a, const Floats& b) {
    Floats all;
    for (int i = 0; i < 8; ++i) all.lane[i] = a.lane[i] > b.lane[i] ? a.lane[i] : b.lane[i];
    return all;
}
inline Floats absolute(const Floats& a) {
    Floats all;
    for (int i = 0; i < 8; ++i) all.lane[i] = std::fabs(a.lane[i]);
    return all;
}
inline Mask atMost(const Floats& a, const Floats& b) {
    Mask mask = 0;
    for (int i = 0; i < 8; ++i) mask |= static_cast<Mask>(a.lane[i] <= b.lane[i]) << i;
    return mask;
}
inline Mask above(const Floats& a, const Floats& b) {
    Mask mask = 0;
    for (int i = 0; i < 8; ++i) mask |= static_cast<Mask>(a.lane[i] > b.lane[i]) << i;
    return mask;
}
inline Mask haveCommon(const std::uint32_t* at, Words words) {
    Mask mask = 0;
    for (int i = 0; i < 8; ++i) mask |= static_cast<Mask>((at[i] & words.word) != 0) << i;
    return mask;
}
inline Mask both(Mask a, Mask b) { return a & b; }
inline std::uint32_t bitsOf(Mask mask) { return mask; }

}  // namespace boxes_scalar

#if defined(PLUMB_HAS_SSE2)

namespace boxes_sse2 {

struct Floats {
    __m128 low;
    __m128 high;
};
using Words = __m128i;
using Mask = Floats;

inline Floats load(const float* at) { return {_mm_load_ps(at), _mm_load_ps(at + 4)}; }
inline Floats loadAny(const float* at) { return {_mm_loadu_ps(at), _mm_loadu_ps(at + 4)}; }
inline Floats spread(float x) { return {_mm_set1_ps(x), _mm_set1_ps(x)}; }
inline Words spread(std::uint32_t word) { return _mm_set1_epi32(static_cast<int>(word)); }
inline Floats minus(Floats a, Floats b) { return {_mm_sub_ps(a.low, b.low), _mm_sub_ps(a.high, b.high)}; }
inline Floats plus(Floats a, Floats b) { return {_mm_add_ps(a.low, b.low), _mm_add_ps(a.high, b.high)}; }
inline Floats times(Floats a, Floats b) { return {_mm_mul_ps(a.low, b.low), _mm_mul_ps(a.high, b.high)}; }
inline Floats minimum(Floats a, Floats b) { return {_mm_min_ps(a.low, b.low), _mm_min_ps(a.high, b.high)}; }
inline Floats maximum(Floats a, Floats b) { return {_mm_max_ps(a.low, b.low), _mm_max_ps(a.high, b.high)}; }
inline __m128 fourRoundedDown(__m128 a) {
    const __m128 whole = _mm_cvtepi32_ps(_mm_cvttps_epi32(a));
    return _mm_sub_ps(whole, _mm_and_ps(_mm_cmplt_ps(a, whole), _mm_set1_ps(1.0f)));
}
inline Floats roundedDown(Floats a) { return {fourRoundedDown(a.low), fourRoundedDown(a.high)}; }
inline void storeWhole(Floats a, std::int32_t* to) {
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm_cvttps_epi32(a.low));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to + 4), _mm_cvttps_epi32(a.high));
}
inline Floats absolute(Floats a) {
    const __m128 sign = _mm_set1_ps(-0.0f);
    return {_mm_andnot_ps(sign, a.low), _mm_andnot_ps(sign, a.high)};
}
inline Mask atMost(Floats a, Floats b) { return {_mm_cmple_ps(a.low, b.low), _mm_cmple_ps(a.high, b.high)}; }
inline Mask above(Floats a, Floats b) { return {_mm_cmpgt_ps(a.low, b.low), _mm_cmpgt_ps(a.high, b.high)}; }
inline __m128 fourHaveCommon(const std::uint32_t* at, Words words) {
    const __m128i common = _mm_and_si128(_mm_load_si128(reinterpret_cast<const __m128i*>(at)), words);
    const __m128i none = _mm_cmpeq_epi32(common, _mm_setzero_si128());
    return _mm_castsi128_ps(_mm_xor_si128(none, _mm_set1_epi32(-1)));
}
inline Mask haveCommon(const std::uint32_t* at, Words words) {
    return {fourHaveCommon(at, words), fourHaveCommon(at + 4, words)};
}
inline Mask both(Mask a, Mask b) { return {_mm_and_ps(a.low, b.low), _mm_and_ps(a.high, b.high)}; }
inline std::uint32_t bitsOf(Mask mask) {
    return static_cast<std::uint32_t>(_mm_movemask_ps(mask.low) | _mm_movemask_ps(mask.high) << 4);
}

}  // namespace boxes_sse2

namespace boxes_avx2 {

using Floats = __m256;
using Words = __m256i;
using Mask = __m256;

PLUMB_AVX2 inline Floats load(const float* at) { return _mm256_load_ps(at); }
PLUMB_AVX2 inline Floats loadAny(const float* at) { return _mm256_loadu_ps(at); }
PLUMB_AVX2 inline Floats spread(float x) { return _mm256_set1_ps(x); }
PLUMB_AVX2 inline Words spread(std::uint32_t word) { return _mm256_set1_epi32(static_cast<int>(word)); }
PLUMB_AVX2 inline Floats minus(Floats a, Floats b) { return _mm256_sub_ps(a, b); }
PLUMB_AVX2 inline Floats plus(Floats a, Floats b) { return _mm256_add_ps(a, b); }
PLUMB_AVX2 inline Floats times(Floats a, Floats b) { return _mm256_mul_ps(a, b); }
PLUMB_AVX2 inline Floats minimum(Floats a, Floats b) { return _mm256_min_ps(a, b); }
PLUMB_AVX2 inline Floats maximum(Floats a, Floats b) { return _mm256_max_ps(a, b); }
PLUMB_AVX2 inline Floats roundedDown(Floats a) { return _mm256_floor_ps(a); }
PLUMB_AVX2 inline void storeWhole(Floats a, std::int32_t* to) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_cvttps_epi32(a));
}
PLUMB_AVX2 inline Floats absolute(Floats a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), a); }
PLUMB_AVX2 inline Mask atMost(Floats a, Floats b) { return _mm256_cmp_ps(a, b, _CMP_LE_OQ); }
PLUMB_AVX2 inline Mask above(Floats a, Floats b) { return _mm256_cmp_ps(a, b, _CMP_GT_OQ); }
PLUMB_AVX2 inline Mask haveCommon(const std::uint32_t* at, Words words) {
    const __m256i common = _mm256_and_si256(_mm256_load_si256(reinterpret_cast<const __m256i*>(at)), words);
    const __m256i none = _mm256_cmpeq_epi32(common, _mm256_setzero_si256());
    return _mm256_castsi256_ps(_mm256_xor_si256(none, _mm256_set1_epi32(-1)));
}
PLUMB_AVX2 inline Mask both(Mask a, Mask b) { return _mm256_and_ps(a, b); }
PLUMB_AVX2 inline std::uint32_t bitsOf(Mask mask) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(mask));
}

}  // namespace boxes_avx2

#endif

#if defined(PLUMB_HAS_NEON)

namespace boxes_neon {

struct Floats {
    float32x4_t low;
    float32x4_t high;
};
using Words = uint32x4_t;
struct Mask {
    uint32x4_t low;
    uint32x4_t high;
};

inline Floats load(const float* at) { return {vld1q_f32(at), vld1q_f32(at + 4)}; }
inline Floats loadAny(const float* at) { return load(at); }
inline Floats spread(float x) { return {vdupq_n_f32(x), vdupq_n_f32(x)}; }
inline Words spread(std::uint32_t word) { return vdupq_n_u32(word); }
inline Floats minus(Floats a, Floats b) { return {vsubq_f32(a.low, b.low), vsubq_f32(a.high, b.high)}; }
inline Floats plus(Floats a, Floats b) { return {vaddq_f32(a.low, b.low), vaddq_f32(a.high, b.high)}; }
inline Floats times(Floats a, Floats b) { return {vmulq_f32(a.low, b.low), vmulq_f32(a.high, b.high)}; }
inline Floats minimum(Floats a, Floats b) { return {vminq_f32(a.low, b.low), vminq_f32(a.high, b.high)}; }
inline Floats maximum(Floats a, Floats b) { return {vmaxq_f32(a.low, b.low), vmaxq_f32(a.high, b.high)}; }
inline Floats roundedDown(Floats a) { return {vrndmq_f32(a.low), vrndmq_f32(a.high)}; }
inline void storeWhole(Floats a, std::int32_t* to) {
    vst1q_s32(to, vcvtq_s32_f32(a.low));
    vst1q_s32(to + 4, vcvtq_s32_f32(a.high));
}
inline Floats absolute(Floats a) { return {vabsq_f32(a.low), vabsq_f32(a.high)}; }
inline Mask atMost(Floats a, Floats b) { return {vcleq_f32(a.low, b.low), vcleq_f32(a.high, b.high)}; }
inline Mask above(Floats a, Floats b) { return {vcgtq_f32(a.low, b.low), vcgtq_f32(a.high, b.high)}; }
inline Mask haveCommon(const std::uint32_t* at, Words words) {
    return {vtstq_u32(vld1q_u32(at), words), vtstq_u32(vld1q_u32(at + 4), words)};
}
inline Mask both(Mask a, Mask b) { return {vandq_u32(a.low, b.low), vandq_u32(a.high, b.high)}; }
inline std::uint32_t bitsOf(Mask mask) {
    constexpr std::uint32_t kBits[8] = {1, 2, 4, 8, 16, 32, 64, 128};
    return vaddvq_u32(
        vorrq_u32(vandq_u32(mask.low, vld1q_u32(kBits)), vandq_u32(mask.high, vld1q_u32(kBits + 4))));
}

}  // namespace boxes_neon

#endif

}  // namespace plumb::physics
