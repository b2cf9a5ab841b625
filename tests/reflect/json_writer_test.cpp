#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/text.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"

// Where writeJson(), writeCompactJson() and appendJson() break lines.

namespace plumb {
namespace {

constexpr std::size_t kLineWidth = 110;  // characters

/// An array of numbers whose text on one line has `width` characters.
Json arrayOfWidth(std::size_t width) {
    Json array = Json::array();
    std::size_t left = width - 2;  // the brackets
    for (; left > 22; left -= 12) array.push_back(1234567890);
    array.push_back(static_cast<std::int64_t>(std::stoll(std::string(left > 18 ? left - 12 : left, '1'))));
    if (left > 18) array.push_back(1234567890);
    return array;
}

std::string onOneLine(const Json& array) {
    std::string text;
    for (const Json& item : array) text += (text.empty() ? "" : ", ") + item.dump();
    return "[" + text + "]";
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    for (const std::string_view line : split(text, '\n')) lines.emplace_back(line);
    return lines;
}

TEST(JsonWriter, anArrayStandsOnOneLineUpToTheLastColumn) {
    for (std::size_t width = 90; width <= 115; ++width) {
        const Json array = arrayOfWidth(width);
        const std::string inlined = onOneLine(array);
        ASSERT_EQ(inlined.size(), width);
        EXPECT_EQ(writeJson(array) == inlined + "\n", width <= kLineWidth) << width;
        // With the name and the indentation of a property, and at a deeper level.
        const std::string one = writeJson(Json{{"a", array}});
        EXPECT_EQ(linesOf(one)[1] == "  \"a\": " + inlined, width + 7 <= kLineWidth) << width;
        const std::string two = writeJson(Json{{"x", 1}, {"list", {{{"a", array}}}}});
        EXPECT_EQ(linesOf(two).at(4) == "      \"a\": " + inlined, width + 11 <= kLineWidth) << width;
    }
}

TEST(JsonWriter, appendedTextCountsFromTheStartOfItsOwnLine) {
    for (const std::string before : {"", "a long first line\n", "\n", "x\ny\n"}) {
        for (const std::size_t start : {0u, 9u}) {
            for (std::size_t width = 97; width <= 113; ++width) {
                const Json array = arrayOfWidth(width);
                std::string text = before + std::string(start, ' ');
                appendJson(text, array, 4);
                const bool isInline = text == before + std::string(start, ' ') + onOneLine(array);
                EXPECT_EQ(isInline, start + width <= kLineWidth) << before << start << " " << width;
                if (!isInline) {
                    const std::string items = text.substr(before.size() + start);
                    EXPECT_EQ(items.substr(0, 20), "[\n      1234567890,\n");
                    EXPECT_EQ(items.substr(items.size() - 6), "\n    ]") << "at the given indentation";
                }
            }
        }
    }
}

TEST(JsonWriter, onlyNumbersAndShortWordsStandInline) {
    const std::string sixteen(16, 'a'), seventeen(17, 'a');
    EXPECT_EQ(writeJson(Json{1, true, nullptr, sixteen, 1.5}), "[1, true, null, \"" + sixteen + "\", 1.5]\n");
    EXPECT_EQ(writeJson(Json{1, seventeen}), "[\n  1,\n  \"" + seventeen + "\"\n]\n");
    EXPECT_EQ(writeJson(Json{1, Json::object()}), "[\n  1,\n  {}\n]\n");
    EXPECT_EQ(writeJson(Json::array({Json{1, 2}, Json::array(), Json{sixteen}})),
              "[[1, 2], [], [\"" + sixteen + "\"]]\n");
    EXPECT_EQ(writeJson(Json::array({Json{1, seventeen}})),
              "[\n  [\n    1,\n    \"" + seventeen + "\"\n  ]\n]\n");
    EXPECT_EQ(writeJson(Json::array({Json::array({Json{1, 2}})})), "[\n  [[1, 2]]\n]\n")
        << "arrays of arrays, but no deeper";
}

TEST(JsonWriter, objectsHaveOnePropertyPerLineAndEmptyOnesNone) {
    EXPECT_EQ(writeJson(Json::object()), "{}\n");
    EXPECT_EQ(writeJson(Json::array()), "[]\n");
    EXPECT_EQ(writeJson(Json{{"a", {{"b", Json::object()}}}, {"c", 2}}),
              "{\n  \"a\": {\n    \"b\": {}\n  },\n  \"c\": 2\n}\n");
    EXPECT_EQ(writeJson(Json{{{"a", 1}, {"b", 2}}, {{"c", 3}}}),
              "[\n  {\n    \"a\": 1,\n    \"b\": 2\n  },\n  {\n    \"c\": 3\n  }\n]\n");
}

TEST(JsonWriter, scalarsOfAllKinds) {
    EXPECT_EQ(writeJson(Json(true)) + writeJson(Json(false)) + writeJson(Json()), "true\nfalse\nnull\n");
    EXPECT_EQ(writeJson(Json(-5)) + writeJson(Json(~std::uint64_t{0})), "-5\n18446744073709551615\n");
    EXPECT_EQ(writeJson(Json(std::numeric_limits<double>::infinity())), "null\n");
    EXPECT_EQ(writeJson(Json(0.1)), "0.1\n");
    EXPECT_EQ(writeJson(Json(double{0.1f})), "0.1\n") << "the shortest text of the float";
    EXPECT_EQ(writeJson(Json(1.0 / 3.0)), "0.3333333333333333\n") << "no float";
    EXPECT_EQ(writeJson(Json(double{1.0f / 3.0f})), "0.33333334\n");
    EXPECT_EQ(parseJson(writeJson(Json(1e300)), "x")->get<double>(), 1e300);
}

TEST(JsonWriter, aCompactValueStandsOnOneLineIfItFitsWithItsComma) {
    for (std::size_t width = 90; width <= 112; ++width) {
        for (const bool isObject : {false, true}) {
            const std::string text(width - (isObject ? 9 : 4), 'a');  // {"k": "aaa"} or ["aaa"]
            const Json value = isObject ? Json{{"k", text}} : Json::array({text});
            const std::string flat = isObject ? "{\"k\": \"" + text + "\"}" : "[\"" + text + "\"]";
            const std::string wide =
                isObject ? "{\n    \"k\": \"" + text + "\"\n  }" : "[\n    \"" + text + "\"\n  ]";
            ASSERT_EQ(flat.size(), width);
            const bool fits = 2 + width + 1 <= kLineWidth - 2;
            EXPECT_EQ(writeCompactJson(Json::array({value, 1})),
                      "[\n  " + (fits ? flat : wide) + ",\n  1\n]\n")
                << width;
        }
    }
}

TEST(JsonWriter, aDeepCompactValueThatFitsNowhereHasOneBracketPerLine) {
    constexpr int kDepth = 60;  // the innermost ones begin beyond the last column
    Json json(std::string(120, 'a'));
    for (int i = 0; i < kDepth; ++i) json = Json::array({json});
    const std::string text = writeCompactJson(json);
    EXPECT_EQ(linesOf(text).size(), 2u * kDepth + 2);
    EXPECT_EQ(parseJson(text, "x")->dump(), json.dump());
}

TEST(JsonWriter, compactValuesOfAllKindsAreSeparatedByCommasAndBlanks) {
    EXPECT_EQ(
        writeCompactJson(Json{{"a", {1, {{"b", 2}, {"c", Json::array()}}, Json::object()}}, {"d", "text"}}),
        "{\n  \"a\": [1, {\"b\": 2, \"c\": []}, {}],\n  \"d\": \"text\"\n}\n");
    EXPECT_EQ(writeCompactJson(Json(5)), "5\n");
    EXPECT_EQ(writeCompactJson(Json::array()), "[\n]\n") << "the outermost value is always divided";
    EXPECT_EQ(writeCompactJson(Json::object()), "{}\n");
}

}  // namespace
}  // namespace plumb
