#include "core/text.hpp"

#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/faults.hpp"

namespace plumb {
namespace {

TEST(TextProperty, everyFloatReadsBackFromItsShortestTextWithTheSameBits) {
    Random random = Random::seeded(1);
    for (int i = 0; i < 100'000; ++i) {
        const float value = std::bit_cast<float>(random.next());
        if (!std::isfinite(value)) continue;
        const auto back = parseFloat(shortestText(value));
        ASSERT_TRUE(back.has_value());
        ASSERT_EQ(std::bit_cast<std::uint32_t>(*back), std::bit_cast<std::uint32_t>(value));
    }
}

TEST(Text, aNumberWithOtherCharactersIsRejected) {
    EXPECT_EQ(parseInt("42"), 42);
    for (const char* wrong : {"", " 42", "42 ", "4x", "--4", "99999999999999999999"}) {
        EXPECT_FALSE(parseInt(wrong).has_value()) << wrong;
    }
}

TEST(Text, hexNumbersReadBackAndOtherTextIsRejected) {
    EXPECT_EQ(hexText(0xdeadbeef12345678ull), "deadbeef12345678");
    EXPECT_EQ(parseHex("deadbeef12345678"), 0xdeadbeef12345678ull);
    for (const char* wrong : {"", "xyz", "12345678123456781", "-1"}) {
        EXPECT_FALSE(parseHex(wrong).has_value()) << wrong;
    }
}

TEST(Text, wellFormedUtf8IsDistinguishedFromOverlongSurrogateAndTruncatedBytes) {
    for (const char* good : {"", "plain", "\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\x8e\xae"}) {
        EXPECT_TRUE(isUtf8(good)) << good;
    }
    for (const char* bad :
         {"\xff", "\xc0\x80", "\xc3", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "a\x80"}) {
        EXPECT_FALSE(isUtf8(bad));
    }
}

TEST(Text, theClosestNameIsFoundForAMistypedOne) {
    const std::string_view names[] = {"Transform", "Sprite", "Spin"};
    EXPECT_EQ(closestName("Spinn", names), "Spin");
    EXPECT_EQ(closestName("transform", names), "Transform");
    EXPECT_EQ(closestName("Banana", names), "");
}

TEST(Text, formatReplacesPlaceholdersInOrder) {
    EXPECT_EQ(format("{}x{} {}", 800, 600, 0.1f), "800x600 0.1");
}

// format() compiles only if these numbers agree: tests/rules/wrong_uses.cpp tries it.
static_assert(placeholdersIn("{}x{} {}") == 3);
static_assert(placeholdersIn("{ } {0} {:.2f}") == 0);
static_assert(placeholdersIn("{{}} {}}{") == 2);
static_assert(placeholdersIn("{") == 0);

TEST(Text, aPatternOfRunTimeMayHaveAnyNumberOfPlaceholders) {
    EXPECT_EQ(format(runtimePattern("{} of {}"), 1), "1 of {}");
    EXPECT_EQ(format(runtimePattern("{}"), 1, 2), "1");
    EXPECT_EQ(format(runtimePattern("{ {} {"), "{}"), "{ {} {") << "arguments are not patterns";
    EXPECT_EQ(format(runtimePattern("{}")), "{}");
    const char* none = nullptr;
    EXPECT_EQ(format("{}", none), "(null)");
}

TEST(LogText, aTextOfRunTimeIsWrittenAsItIs) {
    const test::Faults log;
    const std::string text = "{} and {";
    logNote("Game", text);
    logWarning("Game", text.c_str());
    logNote("Game", "{} coins", 3);
    EXPECT_EQ(log.lines(), (std::vector<std::string>{text, text, "3 coins"}));
}

}  // namespace
}  // namespace plumb
