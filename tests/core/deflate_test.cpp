#include "core/deflate.hpp"

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "core/inflate.hpp"
#include "core/random.hpp"

namespace plumb {
namespace {

using Words = std::vector<std::uint32_t>;

std::string bytesOf(const Words& words) {
    std::string bytes;
    for (const std::uint32_t word : words) {
        for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 255u);
    }
    return bytes;
}

void expectSameAfterUnpacking(const Words& words) {
    const std::string packed = packZlib(words);
    const Result<std::string> unpacked = unpackZlib(packed, words.size() * 4, "packed");
    ASSERT_TRUE(unpacked.ok()) << unpacked.error().text();
    EXPECT_EQ(*unpacked, bytesOf(words));
}

TEST(Deflate, whateverIsPackedComesBack) {
    expectSameAfterUnpacking({});
    expectSameAfterUnpacking({0});
    expectSameAfterUnpacking({0x80000007u});
    expectSameAfterUnpacking({1, 2, 3});
    for (const std::size_t count : {2u, 63u, 64u, 65u, 128u, 129u, 16384u, 40000u})
        expectSameAfterUnpacking(Words(count, 0xffffffffu));
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const std::uint32_t kinds = 1u << random.below(20);
        const std::uint32_t longest = 1u + random.below(300);
        Words words;
        const std::size_t size = 1 + random.below(20000);
        while (words.size() < size) {
            const bool again = !words.empty() && random.below(3) == 0;
            const std::size_t from = again ? random.below(static_cast<std::uint32_t>(words.size())) : 0;
            const std::uint32_t word = random.below(kinds) * 2654435761u;
            for (std::uint32_t i = 1 + random.below(longest); i > 0; --i)
                words.push_back(again ? words[from + i % (words.size() - from)] : word);
        }
        expectSameAfterUnpacking(words);
    }
}

TEST(Deflate, codesStayAsShortAsReadersAllow) {
    // Counts that rise like this make a tree as deep as it has letters. The other three bytes see to it that
    // no word comes again while it could be found.
    Words words;
    std::size_t count = 1, next = 1;
    for (std::uint32_t letter = 0; letter < 24; ++letter) {
        for (std::size_t i = 0; i < count; ++i) {
            const auto other = static_cast<std::uint32_t>(words.size());
            words.push_back(letter | (100 + other % 24) << 8 | (100 + other / 24 % 24) << 16 |
                            (100 + other / 576 % 24) << 24);
        }
        next += count;
        count = next - count;
    }
    expectSameAfterUnpacking(words);
}

TEST(Deflate, whatRepeatsTakesLittle) {
    EXPECT_LT(packZlib(Words(16384, 47)).size(), 600u);
    Words rows;
    for (std::uint32_t i = 0; i < 16384; ++i) rows.push_back(i % 128 * 7919u);
    EXPECT_LT(packZlib(rows).size(), 1400u) << "rows that are alike";
}

}  // namespace
}  // namespace plumb
