#include "core/hash.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"

using namespace plumb;

std::uint64_t hashWithoutSse2(const void* bytes, std::size_t count);  // hash_scalar.cpp

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

namespace {

constexpr std::uint64_t kStart = 0x243f6a8885a308d3ull, kStep = 0x9e3779b97f4a7c15ull;

/// LaneHasher by its definition, byte by byte: sixteen lanes of multiply with carry.
std::uint64_t expectedHash(const std::vector<unsigned char>& bytes) {
    std::uint64_t lanes[16];
    for (std::uint64_t i = 0; i < 16; ++i) lanes[i] = mixBits(i + 1);
    for (std::size_t block = 0; block < (bytes.size() + 127) / 128; ++block) {
        for (std::size_t lane = 0; lane < 16; ++lane) {
            std::uint64_t word = 0;
            for (std::size_t i = 0; i < 8; ++i) {
                const std::size_t at = block * 128 + lane * 8 + i;
                if (at < bytes.size()) word |= std::uint64_t{bytes[at]} << (8 * i);
            }
            const std::uint64_t mixed = lanes[lane] ^ word;
            lanes[lane] = (mixed & 0xffffffffu) * 0xfffeb81bu + (mixed >> 32);
        }
    }
    std::uint64_t hash = mixBits(kStart ^ bytes.size()) + kStep;
    for (const std::uint64_t lane : lanes) hash = mixBits(hash ^ lane) + kStep;
    return mixBits(hash);
}

}  // namespace

TEST(LaneHasher, equalsItsDefinitionForAllLengths) {
    for (std::size_t count = 0; count < 600; ++count) {
        const std::vector<unsigned char> bytes = randomBytes(count, count + 1);
        ASSERT_EQ(hashOf(bytes), expectedHash(bytes)) << count;
        ASSERT_EQ(hashWithoutSse2(bytes.data(), count), expectedHash(bytes)) << count;
    }
}

TEST(TextHash, equalsTheTestVectorsOfItsAuthors) {
    // Source: G. Fowler, L. Noll, K.-P. Vo, test vectors of FNV-1a with 64 bits.
    EXPECT_EQ(hashText(""), 0xcbf29ce484222325ull);
    EXPECT_EQ(hashText("a"), 0xaf63dc4c8601ec8cull);
    EXPECT_EQ(hashText("foobar"), 0x85944171f73967e8ull);
    EXPECT_NE(hashText("\xff"), hashText("\x7f"));
}

TEST(MixBits, equalsSplitmix64) {
    // The first numbers of splitmix64 for the seed 1234567, by S. Vigna's reference program.
    std::uint64_t state = 1234567;
    for (const std::uint64_t expected :
         {6457827717110365317ull, 3203168211198807973ull, 9817491932198370423ull, 4593380528125082431ull})
        EXPECT_EQ(mixBits(state += kStep), expected);
}

TEST(Hasher, hashesBytesAsWordsAndTheRestWithItsLength) {
    for (std::size_t count = 0; count < 40; ++count) {
        const std::vector<unsigned char> bytes = randomBytes(count, count + 1);
        Hasher whole, words;
        whole.addBytes(bytes.data(), count);
        for (std::size_t i = 0; i < count / 8; ++i) {
            std::uint64_t word = 0;
            for (std::size_t k = 8; k-- > 0;) word = word << 8 | bytes[8 * i + k];
            words.add(word);
        }
        std::uint64_t rest = count % 8;
        for (std::size_t i = count / 8 * 8; i < count; ++i) rest = rest * 256 + bytes[i];
        words.add(rest);
        ASSERT_EQ(whole.value(), words.value()) << count;
    }
}

TEST(Hasher, hashesFloatsByTheirValues) {
    const auto of = [](float value) {
        Hasher hash;
        hash.add(value);
        return hash.value();
    };
    EXPECT_EQ(of(-0.0f), of(0.0f));
    EXPECT_EQ(of(std::numeric_limits<float>::quiet_NaN()), of(-std::numeric_limits<float>::quiet_NaN()));
    EXPECT_NE(of(1.0f), of(-1.0f));
    EXPECT_EQ(of(1.0f), mixBits(mixBits(kStart ^ 0x3f800000u) + kStep));
}
