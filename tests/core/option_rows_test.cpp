#include "core/option_rows.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "core/text.hpp"

namespace plumb {
namespace {

constexpr std::size_t kColumn = 26, kRoom = 54;  // characters: before the description, and in it

/// Where a line of a description ends, by trying all lengths: before a blank or after a comma, as late as
/// there is room; a longer word is not divided.
std::size_t expectedLength(std::string_view text) {
    const auto mayEnd = [&](std::size_t length) {
        return length == text.size() || text[length] == ' ' || text[length - 1] == ',';
    };
    for (std::size_t length = std::min(kRoom, text.size()); length > 0; --length) {
        if (mayEnd(length)) return length;
    }
    for (std::size_t length = kRoom + 1;; ++length) {
        if (mayEnd(length)) return length;
    }
}

std::string expectedLines(std::string_view start, std::string_view doc) {
    std::string lines;
    for (std::string line{start}; !doc.empty(); line.clear()) {
        const std::size_t length = expectedLength(doc);
        line += std::string(kColumn - line.size(), ' ');
        lines += line.append(doc.substr(0, length)) + "\n";
        doc = trimmed(doc.substr(length));
    }
    return lines;
}

TEST(OptionRows, descriptionsStandInAColumnOfLinesOf80Characters) {
    const OptionHelp options[] = {
        {"--size", "WxH", "size of the window"},
        {"--fast", "", "a switch whose description is longer than the fifty-four characters of a line"}};
    EXPECT_EQ(optionLines(options),
              "  --size WxH              size of the window\n"
              "  --fast                  a switch whose description is longer than the\n"
              "                          fifty-four characters of a line\n");
    EXPECT_EQ(optionLines({}), "");
}

TEST(OptionRowsProperty, linesEndAtBlanksAndCommasAsLateAsPossible) {
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        Random random = Random::seeded(seed);
        const std::uint32_t longest = 2 + random.below(70);  // characters of a word
        std::string doc;
        for (std::uint32_t words = 1 + random.below(12); words > 0; --words) {
            doc += std::string(1 + random.below(longest), static_cast<char>('a' + words));
            if (words > 1) doc += random.below(3) == 0 ? "," : random.below(2) == 0 ? ", " : " ";
        }
        const OptionHelp option[] = {{"--name", "N", doc}};
        ASSERT_EQ(optionLines(option), expectedLines("  --name N", doc)) << seed;
    }
}

TEST(OptionRows, lineEndsAreExactAtTheLastColumn) {
    for (std::size_t before = kRoom - 3; before <= kRoom + 3; ++before) {
        for (const char* between : {" ", ",", ", "}) {
            for (const char* first : {"", "a ", "a,"}) {
                const std::string doc = first + std::string(before, 'b') + between + "c";
                const OptionHelp option[] = {{"--name", "N", doc}};
                EXPECT_EQ(optionLines(option), expectedLines("  --name N", doc)) << before << doc;
            }
        }
    }
}

struct Options {
    int count = 0;
    bool isFast = false;
    std::string name = "none";
};

const std::vector<OptionRow<Options>> kRows{
    {"--count", "N", "how many",
     [](Options& options, std::string_view value) {
         const auto number = parseInt(value);
         if (number) options.count = static_cast<int>(*number);
         return number.has_value();
     }},
    {"--fast", "", "a switch", [](Options& options, std::string_view) { return options.isFast = true; }},
    {"--name", "TEXT", "a name", [](Options& options, std::string_view value) {
         options.name = value;
         return true;
     }}};

struct Read {
    Options options;
    std::string words;
    std::string error;
};

Read read(std::vector<const char*> words) {
    Read read;
    const auto onWord = [&](std::string_view word) -> Result<Done> {
        if (word == "bad") return Error{"word", "bad", ""};
        read.words += std::string{word} + ";";
        return Done{};
    };
    const Result<Done> done =
        readOptions(std::span<const OptionRow<Options>>{kRows}, words, read.options, onWord);
    if (!done) read.error = done.error().text();
    return read;
}

TEST(OptionRows, valuesFollowAsTheNextWordOrAfterAnEqualsSign) {
    const Read both = read({"first", "--count", "7", "--fast", "--name=a=b", "last"});
    EXPECT_EQ(both.error, "");
    EXPECT_EQ(both.options.count, 7);
    EXPECT_TRUE(both.options.isFast);
    EXPECT_EQ(both.options.name, "a=b");
    EXPECT_EQ(both.words, "first;last;");
    EXPECT_EQ(read({"--name=", "--count=3"}).options.name, "") << "an empty value";
    EXPECT_EQ(read({"--name", "--fast"}).options.name, "--fast") << "the next word, whatever it is";
    EXPECT_FALSE(read({}).options.isFast);
}

TEST(OptionRows, errorsNameTheOptionAndTheRemedy) {
    EXPECT_EQ(read({"--cuont", "7"}).error,
              "command line: unknown option \"--cuont\"; did you mean --count?");
    EXPECT_EQ(read({"--something=7"}).error,
              "command line: unknown option \"--something\"; --help lists the options");
    EXPECT_EQ(read({"--count"}).error, "command line: --count needs a value; write --count N: how many");
    EXPECT_EQ(read({"--count", "x"}).error,
              "command line: invalid value \"x\" for --count; write --count N: how many");
    EXPECT_EQ(read({"a", "bad", "b"}).words, "a;") << "the first error ends the reading";
    const std::string_view value = "on";
    EXPECT_EQ(wrongValue({"--fast", "", "a switch"}, &value).text(),
              "command line: invalid value \"on\" for --fast; write --fast: a switch");
}

TEST(OptionRows, aPathOfAPictureEndsWithPngInLettersOfEitherCase) {
    std::string field;
    for (const char* good : {"a.png", "shot.PNG", "a/b.jpg.Png", ".png"}) {
        EXPECT_TRUE(setPngPath(good, field)) << good;
        EXPECT_EQ(field, good);
    }
    for (const char* bad : {"", "png", "a.jpg", "a.png.jpg", "a.pn", "a.png ", "a-png", "a\x0epng"})
        EXPECT_FALSE(setPngPath(bad, field)) << bad;
    EXPECT_TRUE(setText("a", field));
    EXPECT_EQ(field, "a");
    EXPECT_FALSE(setText("", field));
}

}  // namespace
}  // namespace plumb
