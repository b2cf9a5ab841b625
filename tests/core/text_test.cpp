#include "core/text.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <limits>
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

/// Length of the UTF-8 sequence at the front by Unicode's table of well-formed sequences (Unicode 15, table
/// 3-7); 0 if it is invalid.
std::size_t expectedUtf8Length(std::string_view text) {
    struct Row {
        int firstLow, firstHigh, secondLow, secondHigh;
        std::size_t length;
    };
    constexpr Row kRows[] = {
        {0x00, 0x7f, 0, 0, 1},       {0xc2, 0xdf, 0x80, 0xbf, 2}, {0xe0, 0xe0, 0xa0, 0xbf, 3},
        {0xe1, 0xec, 0x80, 0xbf, 3}, {0xed, 0xed, 0x80, 0x9f, 3}, {0xee, 0xef, 0x80, 0xbf, 3},
        {0xf0, 0xf0, 0x90, 0xbf, 4}, {0xf1, 0xf3, 0x80, 0xbf, 4}, {0xf4, 0xf4, 0x80, 0x8f, 4}};
    const auto byte = [&](std::size_t i) { return static_cast<int>(static_cast<unsigned char>(text[i])); };
    for (const Row& row : kRows) {
        if (byte(0) < row.firstLow || byte(0) > row.firstHigh) continue;
        if (text.size() < row.length) return 0;
        for (std::size_t i = 1; i < row.length; ++i) {
            if (byte(i) < (i == 1 ? row.secondLow : 0x80) || byte(i) > (i == 1 ? row.secondHigh : 0xbf))
                return 0;
        }
        return row.length;
    }
    return 0;
}

bool expectedUtf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = expectedUtf8Length(text);
        if (length == 0) return false;
        text.remove_prefix(length);
    }
    return true;
}

TEST(TextProperty, sequencesOfBytesAtTheBordersOfUtf8AreDistinguished) {
    constexpr int kBytes[] = {0x00, 0x41, 0x7f, 0x80, 0x8f, 0x90, 0x9f, 0xa0, 0xbf, 0xc0, 0xc1, 0xc2, 0xdf,
                              0xe0, 0xe1, 0xec, 0xed, 0xee, 0xef, 0xf0, 0xf1, 0xf3, 0xf4, 0xf5, 0xf8, 0xff};
    std::string text;
    for (const int a : kBytes) {
        for (const int b : kBytes) {
            for (const int c : kBytes) {
                text.assign({static_cast<char>(a), static_cast<char>(b), static_cast<char>(c)});
                for (const std::size_t length : {1u, 2u, 3u}) {
                    const std::string_view part = std::string_view{text}.substr(0, length);
                    ASSERT_EQ(isUtf8(part), expectedUtf8(part)) << a << " " << b << " " << c;
                }
                for (const int d : {0x41, 0x7f, 0x80, 0xbf, 0xc0, 0xc2}) {
                    const std::string four = text + static_cast<char>(d);
                    ASSERT_EQ(isUtf8(four), expectedUtf8(four)) << a << " " << b << " " << c << " " << d;
                }
            }
        }
    }
}

/// Number of edits between two words without case, by recursion over their first characters.
// NOLINTNEXTLINE(misc-no-recursion)
std::size_t expectedDistance(std::string_view a, std::string_view b) {
    if (a.empty() || b.empty()) return a.size() + b.size();
    const std::string_view restA = a.substr(1), restB = b.substr(1);
    if (std::tolower(a[0]) == std::tolower(b[0])) return expectedDistance(restA, restB);
    return 1 +
           std::min({expectedDistance(restA, b), expectedDistance(a, restB), expectedDistance(restA, restB)});
}

TEST(TextProperty, theClosestNameIsTheFirstWithTheFewestEditsBelowALimit) {
    Random random = Random::seeded(3);
    constexpr std::string_view kLetters = "abAB[@zZ{`";
    const auto word = [&](std::uint32_t longest) {
        std::string text;
        for (std::uint32_t n = random.below(longest + 1); n > 0; --n) text += kLetters[random.below(10)];
        return text;
    };
    int found = 0;
    for (int i = 0; i < 3000; ++i) {
        const std::string wanted = word(6);
        const std::string names[] = {word(6), word(6), word(6)};
        const std::string_view views[] = {names[0], names[1], names[2]};
        std::string_view best;
        std::size_t least = 3;  // at most two edits
        for (const std::string_view name : views) {
            if (const std::size_t edits = expectedDistance(wanted, name); edits < least)
                best = name, least = edits;
        }
        ASSERT_EQ(closestName(wanted, views), best) << wanted << ": " << names[0] << ", " << names[1];
        if (!best.empty()) ++found;
    }
    EXPECT_GT(found, 300);
}

TEST(Text, aThirdOfALongWordMayBeWrong) {
    const auto isFound = [](std::size_t length, std::size_t wrong) {
        const std::string right(length, 'a');
        const std::string_view names[] = {right};
        return !closestName(std::string(length - wrong, 'a') + std::string(wrong, 'b'), names).empty();
    };
    for (std::size_t length = 3; length <= 64; ++length) {
        const std::size_t most = std::max<std::size_t>(2, length / 3);
        EXPECT_TRUE(isFound(length, most)) << length;
        EXPECT_FALSE(isFound(length, most + 1)) << length;
    }
    EXPECT_FALSE(isFound(65, 0)) << "longer words are not compared";
}

TEST(TextProperty, partsOfASplitTextJoinToIt) {
    Random random = Random::seeded(5);
    for (int i = 0; i < 1000; ++i) {
        std::string text;
        for (std::uint32_t n = random.below(12); n > 0; --n) text += "ab//"[random.below(4)];
        const std::vector<std::string_view> parts = split(text, '/');
        std::string joined{parts[0]};
        for (std::size_t k = 1; k < parts.size(); ++k) joined += "/" + std::string{parts[k]};
        ASSERT_EQ(joined, text);
        for (const std::string_view part : parts) ASSERT_EQ(part.find('/'), std::string_view::npos) << text;
    }
    EXPECT_EQ(split("ab/cd//e/", '/'), (std::vector<std::string_view>{"ab", "cd", "", "e", ""}));
    EXPECT_EQ(split("", '/'), std::vector<std::string_view>{""});
}

TEST(Text, blanksAtBothEndsAreRemoved) {
    for (const std::string_view before : {"", " ", "\t\r\n "}) {
        for (const std::string_view after : {"", " ", "\n \t"}) {
            for (const std::string_view text : {"a", "a b", "ab \t c", ""})
                EXPECT_EQ(trimmed(std::string{before}.append(text).append(after)), text);
        }
    }
}

TEST(Text, startsAndEndsAreCompared) {
    for (const std::string_view whole : {"abcabc", "abc", "ab", ""}) {
        for (const std::string_view part : {"", "a", "c", "abc", "bc", "abcabc", "abcabcd", "xabcabc"}) {
            EXPECT_EQ(startsWith(whole, part), whole.find(part) == 0) << whole << " " << part;
            const bool isEnd = part.size() <= whole.size() && whole.rfind(part) == whole.size() - part.size();
            EXPECT_EQ(endsWith(whole, part), isEnd) << whole << " " << part;
        }
    }
}

TEST(Text, numbersOfEachTypeAreWrittenExactly) {
    EXPECT_EQ(format("{} {}", std::numeric_limits<int>::min(), std::numeric_limits<int>::max()),
              "-2147483648 2147483647");
    EXPECT_EQ(format("{} {}", std::numeric_limits<unsigned>::max(), std::numeric_limits<long>::min()),
              "4294967295 -9223372036854775808");
    EXPECT_EQ(format("{} {}", std::numeric_limits<unsigned long long>::max(),
                     std::numeric_limits<long long>::min()),
              "18446744073709551615 -9223372036854775808");
    EXPECT_EQ(format("{} {} {} {}", 0.1, 0.1f, 'x', true), "0.1 0.1 x true");
    EXPECT_EQ(format("{} {}", false, std::string{"text"}), "false text");
}

TEST(Text, fixedTextHasTheGivenNumberOfDecimals) {
    EXPECT_EQ(fixedText(3.14159, 2), "3.14");
    EXPECT_EQ(fixedText(-0.5, 0), "-0");
    EXPECT_EQ(fixedText(2.0, 3), "2.000");
    EXPECT_EQ(fixedText(std::numeric_limits<double>::max(), 20).size(), 309u + 1 + 20)
        << "the longest number";
}

TEST(TextProperty, hexTextsReadBack) {
    Random random = Random::seeded(7);
    for (int i = 0; i < 1000; ++i) {
        const std::uint64_t value = random.next64() >> random.below(64);
        const std::string text = hexText(value);
        ASSERT_EQ(text.size(), 16u);
        ASSERT_EQ(parseHex(text), value);
        char expected[17];
        std::snprintf(expected, sizeof expected, "%016llx", static_cast<unsigned long long>(value));
        ASSERT_EQ(text, expected);
    }
    EXPECT_EQ(parseHex("F"), 15u);
    EXPECT_FALSE(parseHex("12x").has_value());
    EXPECT_FALSE(parseHex("00000000000000001").has_value()) << "17 digits";
}

TEST(Text, wholeAndRealNumbersAreReadToTheirLimits) {
    EXPECT_EQ(parseInt("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
    EXPECT_EQ(parseInt("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
    EXPECT_FALSE(parseInt("9223372036854775808").has_value());
    EXPECT_EQ(parseFloat("-2.5e2"), -250.0f);
    for (const char* wrong : {"", "1.5x", "x", " 1", "1e99"})
        EXPECT_FALSE(parseFloat(wrong).has_value()) << wrong;
}

TEST(Text, aPlaceholderAtTheEndAndHalfOnesAreKept) {
    EXPECT_EQ(format("a{}", 1), "a1");
    EXPECT_EQ(format("{}{}", 1, 2), "12");
    EXPECT_EQ(format(runtimePattern("{"), 1), "{");
    EXPECT_EQ(format(runtimePattern("}{"), 1), "}{");
    EXPECT_EQ(format(runtimePattern("{{}}"), 1), "{1}");
    EXPECT_EQ(format(runtimePattern("{x}{ }"), 1), "{x}{ }");
}

TEST(Text, nothingBehindAPartOfATextIsRead) {
    constexpr std::string_view kDigits = "123456", kBraces = "a{}";
    EXPECT_EQ(parseInt(kDigits.substr(0, 2)), 12);
    EXPECT_EQ(parseFloat(kDigits.substr(0, 3)), 123.0f);
    EXPECT_EQ(parseHex(kDigits.substr(0, 2)), 0x12u);
    EXPECT_EQ(format(runtimePattern(kBraces.substr(0, 2)), 1), "a{");
    EXPECT_TRUE(isUtf8(std::string_view{"a\xff"}.substr(0, 1)));
    EXPECT_FALSE(isUtf8(std::string_view{"\xc3\xa9"}.substr(0, 1)));
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
