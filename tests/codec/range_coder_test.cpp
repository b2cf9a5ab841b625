#include "codec/range_coder.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace plumb {
namespace {

/// A sequence of values of every kind, read or written.
template <class Coder>
void codeAll(Coder& coder, Random random, int count, std::vector<std::uint64_t>& values, bool reads) {
    std::array<BitModel, 3> bits{};
    BitTree<5> tree;
    NumberModel numbers;
    const auto next = [&](std::uint64_t made, const auto& code) {
        const std::uint64_t read = code(made);
        if (reads) values.push_back(read);
        if (!reads) values.push_back(made);
    };
    for (int i = 0; i < count; ++i) {
        const std::uint32_t kind = random.below(4);
        const std::uint64_t word = random.next64();
        const std::uint32_t size = random.below(64);
        const auto given = [&](std::uint64_t value) { return reads ? 0 : value; };
        if (kind == 0) {
            const std::size_t model = word % 3;  // rare, frequent and very frequent ones
            const bool one = (word >> 8) % (model == 0 ? 2 : model == 1 ? 10 : 10000) == 0;
            next(one ? 1 : 0,
                 [&](std::uint64_t v) { return std::uint64_t{coder.bit(bits[model], given(v) != 0)}; });
        } else if (kind == 1) {
            next(word >> 59, [&](std::uint64_t v) {
                return std::uint64_t{tree.code(coder, static_cast<unsigned>(given(v)))};
            });
        } else if (kind == 2) {
            next(size == 0 ? 0 : word >> (64 - size),
                 [&](std::uint64_t v) { return numbers.code(coder, given(v)); });
        } else {
            next(size == 0 ? 0 : word >> (64 - size),
                 [&](std::uint64_t v) { return coder.bits(given(v), static_cast<int>(size)); });
        }
    }
}

TEST(RangeCoder, valuesReadBackTheSameOverSeeds) {
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        const int count = static_cast<int>(seed % 300);
        std::vector<std::uint64_t> written, read;
        RangeEncoder encoder;
        codeAll(encoder, Random::seeded(seed), count, written, false);
        const std::string bytes = encoder.finish();
        RangeDecoder decoder{bytes};
        codeAll(decoder, Random::seeded(seed), count, read, true);
        ASSERT_EQ(read, written) << seed;
        ASSERT_TRUE(decoder.isAtEnd()) << seed;
    }
}

TEST(RangeCoder, carriesReachTheBytesBeforeThem) {
    // A stream of the upper ends of the range ends in bytes 0xff, which a carry turns into zeros.
    for (int ones = 1; ones < 400; ++ones) {
        std::vector<bool> bits(static_cast<std::size_t>(ones), true);
        for (const bool last : {false, true}) {
            RangeEncoder encoder;
            for (std::size_t i = 0; i < bits.size(); ++i) encoder.bits(1, 1);
            encoder.bits(last ? 1 : 0, 1);
            const std::string bytes = encoder.finish();
            RangeDecoder decoder{bytes};
            for (std::size_t i = 0; i < bits.size(); ++i) ASSERT_EQ(decoder.bits(0, 1), 1u);
            ASSERT_EQ(decoder.bits(0, 1), last ? 1u : 0u);
        }
    }
}

TEST(RangeCoder, theSizeIsNearTheEntropy) {
    // 20,000 bits of which one in 50 is a one have an entropy of 2829 bits.
    constexpr double kRatio = 0.02;
    Random random = Random::seeded(1);
    RangeEncoder encoder;
    BitModel model;
    constexpr int kBits = 20000;
    for (int i = 0; i < kBits; ++i) encoder.bit(model, random.unit() < static_cast<float>(kRatio));
    const double entropy = -kBits * (kRatio * std::log2(kRatio) + (1 - kRatio) * std::log2(1 - kRatio)) / 8;
    const auto size = static_cast<double>(encoder.finish().size());
    EXPECT_GT(size, 0.9 * entropy);
    EXPECT_LT(size, 1.1 * entropy);
}

TEST(RangeCoder, anyBytesAreReadAndTheEndIsSeen) {
    Random random = Random::seeded(7);
    for (int round = 0; round < 500; ++round) {
        std::string bytes(random.below(40), '\0');
        for (char& byte : bytes) byte = static_cast<char>(random.next());
        RangeDecoder decoder{bytes};
        EXPECT_FALSE(decoder.isBeyondEnd());
        NumberModel model;
        for (std::size_t i = 0; i < bytes.size() + 5; ++i) decoder.bits(0, 8);
        EXPECT_TRUE(decoder.isBeyondEnd());
        model.code(decoder, 0);  // and after it, without an end
    }
}

}  // namespace
}  // namespace plumb
