#include "core/hash.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"

using namespace plumb;

namespace {

std::vector<unsigned char> randomBytes(std::size_t count, std::uint64_t seed) {
    Random random = Random::seeded(seed);
    std::vector<unsigned char> bytes(count);
    for (unsigned char& byte : bytes) byte = static_cast<unsigned char>(random.next());
    return bytes;
}

std::uint64_t hashOf(const std::vector<unsigned char>& bytes) {
    LaneHasher hash;
    hash.addBytes(bytes.data(), bytes.size());
    return hash.value();
}

}  // namespace

TEST(LaneHasher, hashIsTheSameOnEveryMachine) {
    std::vector<unsigned char> bytes(1000);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<unsigned char>(i * 7);
    EXPECT_EQ(hashOf(bytes), 6532663947403863856ull);
}

TEST(LaneHasher, anyFlippedBitChangesIt) {
    for (const std::size_t count : {1u, 7u, 8u, 127u, 128u, 129u, 400u}) {
        std::vector<unsigned char> bytes = randomBytes(count, count);
        const std::uint64_t before = hashOf(bytes);
        for (std::size_t bit = 0; bit < 8 * count; ++bit) {
            bytes[bit / 8] ^= static_cast<unsigned char>(1u << (bit % 8));
            EXPECT_NE(hashOf(bytes), before) << count << " bytes, bit " << bit;
            bytes[bit / 8] ^= static_cast<unsigned char>(1u << (bit % 8));
        }
    }
}

TEST(LaneHasher, aFlippedBitFlipsHalfOfItsBits) {
    std::vector<unsigned char> bytes = randomBytes(640, 3);
    const std::uint64_t before = hashOf(bytes);
    double flipped = 0.0;
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        bytes[bit / 8] ^= static_cast<unsigned char>(1u << (bit % 8));
        flipped += std::popcount(hashOf(bytes) ^ before);
        bytes[bit / 8] ^= static_cast<unsigned char>(1u << (bit % 8));
    }
    EXPECT_NEAR(flipped / static_cast<double>(8 * bytes.size()), 32.0, 0.5);
}

TEST(LaneHasher, lengthsOfZerosDiffer) {
    std::vector<std::uint64_t> seen;
    for (std::size_t count = 0; count < 300; ++count)
        seen.push_back(hashOf(std::vector<unsigned char>(count)));
    for (std::size_t i = 0; i < seen.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) EXPECT_NE(seen[i], seen[j]);
    }
}

TEST(LaneHasher, swappedBlocksChangeTheHash) {
    std::vector<unsigned char> bytes = randomBytes(512, 9);
    const std::uint64_t before = hashOf(bytes);
    std::vector<unsigned char> exchanged = bytes;
    std::swap_ranges(exchanged.begin(), exchanged.begin() + 128, exchanged.begin() + 128);
    EXPECT_NE(hashOf(exchanged), before);
    LaneHasher pieces;
    pieces.addBytes(bytes.data(), 256);
    pieces.addBytes(bytes.data() + 256, 256);
    EXPECT_NE(pieces.value(), before);
}

TEST(LaneHasher, theOrderOfWordsChangesTheHash) {
    LaneHasher a, b, c;
    a.add(1), a.add(2);
    b.add(2), b.add(1);
    c.add(1), c.add(2);
    EXPECT_NE(a.value(), b.value());
    EXPECT_EQ(a.value(), c.value());
}
