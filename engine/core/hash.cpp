#include "core/hash.hpp"

#if defined(__SSE2__) || defined(_M_X64)
#include <emmintrin.h>
#endif

namespace plumb {

namespace {

constexpr std::uint64_t kFactor = 0xfffeb81bu;

#if defined(__SSE2__) || defined(_M_X64)

struct TwoLanes {
    __m128i value;

    void load(const void* at) { value = _mm_loadu_si128(static_cast<const __m128i*>(at)); }
    void store(void* at) const { _mm_storeu_si128(static_cast<__m128i*>(at), value); }
    void fold(const TwoLanes& words) {
        const __m128i mixed = _mm_xor_si128(value, words.value);
        const __m128i factor = _mm_set1_epi64x(static_cast<long long>(kFactor));
        value = _mm_add_epi64(_mm_mul_epu32(mixed, factor), _mm_srli_epi64(mixed, 32));
    }
};

#else

struct TwoLanes {
    std::uint64_t value[2];

    void load(const void* at) { std::memcpy(value, at, sizeof value); }
    void store(void* at) const { std::memcpy(at, value, sizeof value); }
    void fold(const TwoLanes& words) {
        for (int i = 0; i < 2; ++i) {
            const std::uint64_t mixed = value[i] ^ words.value[i];
            value[i] = (mixed & 0xffffffffu) * kFactor + (mixed >> 32);
        }
    }
};

#endif

}  // namespace

void LaneHasher::addBlocks(const unsigned char* at, std::size_t blocks) {
    constexpr std::size_t kPairs = kLanes / 2;
    std::array<TwoLanes, kPairs> pairs;
    for (std::size_t i = 0; i < kPairs; ++i) pairs[i].load(&lanes_[2 * i]);
    for (; blocks > 0; --blocks, at += kBlock) {
        for (std::size_t i = 0; i < kPairs; ++i) {
            TwoLanes words;
            words.load(at + 16 * i);
            pairs[i].fold(words);
        }
    }
    for (std::size_t i = 0; i < kPairs; ++i) pairs[i].store(&lanes_[2 * i]);
}

void LaneHasher::addBytes(const void* bytes, std::size_t count) {
    add(count);
    const auto* at = static_cast<const unsigned char*>(bytes);
    addBlocks(at, count / kBlock);
    const std::size_t rest = count % kBlock;
    if (rest == 0) return;
    std::array<unsigned char, kBlock> last{};
    std::memcpy(last.data(), at + (count - rest), rest);
    addBlocks(last.data(), 1);
}

std::uint64_t LaneHasher::value() const {
    std::uint64_t hash = single_;
    for (const std::uint64_t lane : lanes_) hash = mixBits(hash ^ lane) + 0x9e3779b97f4a7c15ull;
    return mixBits(hash);
}

}  // namespace plumb
