#include "reflect/json_text.hpp"

#include <bit>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "core/text.hpp"
#include "reflect/json.hpp"
#include "tests/support/damage.hpp"

namespace plumb {
namespace {

Json parsed(std::string_view text) {
    const Result<Json> result = parseJson(text, "test.json");
    EXPECT_TRUE(result.ok()) << text << ": " << (result.ok() ? "" : result.error().text());
    return result.ok() ? *result : Json{};
}

TEST(JsonText, everyKindOfValueIsRead) {
    const Json json = parsed(
        R"( {"a": [1, -2, 3.5, 1e3], "b": true, "c": false, "d": null, "e": "x\n\u00e9\ud83d\ude00", "f": {} } )");

    EXPECT_EQ(json["a"][1].get<int>(), -2);
    EXPECT_EQ(json["a"][2].get<double>(), 3.5);
    EXPECT_EQ(json["a"][3].get<double>(), 1000.0);
    EXPECT_TRUE(json["b"].get<bool>());
    EXPECT_TRUE(json["d"].is_null());
    EXPECT_EQ(json["e"].get<std::string>(), "x\n\xc3\xa9\xf0\x9f\x98\x80");
    EXPECT_TRUE(json["f"].is_object());
}

TEST(JsonText, keysKeepTheirOrderAndLargeNumbersTheirDigits) {
    const Json json =
        parsed(R"({"z": 18446744073709551615, "a": -9223372036854775808, "m": 9007199254740993})");

    EXPECT_EQ(json.begin().key(), "z");
    EXPECT_EQ(json["z"].get<std::uint64_t>(), 18446744073709551615ull);
    EXPECT_EQ(json["m"].get<std::int64_t>(), 9007199254740993ll);
}

TEST(JsonText, theErrorNamesLineColumnWhatWasExpectedAndARemedy) {
    const Result<Json> result = parseJson("{\n  \"a\": 1\n  \"b\": 2\n}", "levels/cave.json");

    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().where, "levels/cave.json:3:3");
    EXPECT_EQ(result.error().what, "expected \",\" or \"}\", found a string");
    EXPECT_FALSE(result.error().remedy.empty());
}

TEST(JsonText, anUnclosedBracketIsReportedWhereItOpens) {
    struct Case {
        std::string_view text;
        std::string_view where;
        std::string_view what;
    };
    for (const Case& one : {
             Case{"{\n  \"at\": [1, 2\n}\n", "x:2:9", "the \"[\" that opens here is not closed"},
             Case{"{\n  \"at\": [1, 2,\n}\n", "x:2:9", "expected a value, found \"}\" in line 3"},
             Case{"{\n  \"at\": [1, 2,\n  \"next\": 3\n}\n", "x:2:9", "found \":\" in line 3"},
             Case{"[\n  [1, 2],\n  [3, 4]\n", "x:1:1", "found the end of the file"},
             Case{"[1, [2, 3], ", "x:1:1", "expected a value, found the end of the file"},
             Case{"[\n  {\"a\": 1\n]", "x:2:3", "the \"{\" that opens here is not closed"},
             Case{"{\n  \"a\": {\n    \"b\": 1\n", "x:2:8", "found the end of the file"},
         }) {
        const Result<Json> result = parseJson(one.text, "x");
        ASSERT_FALSE(result.ok()) << one.text;
        EXPECT_EQ(result.error().where, one.where) << one.text;
        EXPECT_NE(result.error().what.find(one.what), std::string::npos) << result.error().what;
    }
    // A missing comma is as likely: the error has the position of the unexpected text, the remedy names the
    // bracket.
    const Result<Json> result = parseJson("{\n  \"a\": {\n    \"b\": 1\n  \"c\": 2\n}", "x");
    EXPECT_EQ(result.error().where, "x:4:3");
    EXPECT_EQ(result.error().remedy, "put a comma between properties; the \"{\" of line 2 is not closed yet");
}

TEST(JsonText, invalidTextsAreRejectedWithPlaceTextAndRemedy) {
    const std::string_view broken[] = {"",
                                       " ",
                                       "{",
                                       "}",
                                       "[",
                                       "]",
                                       "[1",
                                       "[1,",
                                       "[1,]",
                                       "[,1]",
                                       "{\"a\"}",
                                       "{\"a\":}",
                                       "{\"a\":1,}",
                                       "{a:1}",
                                       "{'a':1}",
                                       "\"",
                                       "\"\\",
                                       "\"\\x\"",
                                       "\"\\u12\"",
                                       "\"\\u12g4\"",
                                       "\"\\ud800\"",
                                       "\"\\ud800\\u0041\"",
                                       "\"\\udc00\"",
                                       "\"a\nb\"",
                                       "01",
                                       "-",
                                       "-a",
                                       "1.",
                                       ".5",
                                       "1e",
                                       "1e+",
                                       "+1",
                                       "0x10",
                                       "1e999",
                                       "NaN",
                                       "Infinity",
                                       "nul",
                                       "nulll",
                                       "tru",
                                       "True",
                                       "1 2",
                                       "{} {}",
                                       "[1] // x",
                                       "/* */ 1",
                                       "\xff\xfe[]",
                                       "\"\xc3\"",
                                       "\"\xed\xa0\x80\"",
                                       "[\"a\" \"b\"]",
                                       "{\"a\":1 \"b\":2}"};
    for (const std::string_view text : broken) {
        const Result<Json> result = parseJson(text, "x");
        ASSERT_FALSE(result.ok()) << text;
        EXPECT_EQ(result.error().where.substr(0, 2), "x:") << text;
        EXPECT_FALSE(result.error().what.empty()) << text;
        EXPECT_FALSE(result.error().remedy.empty()) << text;
    }
    EXPECT_FALSE(parseJson(std::string_view{"[\0]", 3}, "x").ok());
}

TEST(JsonText, depthIsAcceptedAtTheLimitAndRejectedBeyond) {
    const auto nested = [](int depth) {
        return std::string(static_cast<std::size_t>(depth), '[') +
               std::string(static_cast<std::size_t>(depth), ']');
    };
    EXPECT_TRUE(parseJson(nested(limits::kJsonDepth - 1), "x").ok());
    EXPECT_TRUE(parseJson(nested(limits::kJsonDepth), "x").ok());
    EXPECT_FALSE(parseJson(nested(limits::kJsonDepth + 1), "x").ok());
    EXPECT_FALSE(parseJson(std::string(1000000, '['), "x").ok());
}

TEST(JsonText, stringsBytesAndValuesAreAcceptedAtTheirLimitAndRejectedBeyond) {
    const auto text = [](std::size_t length) { return '"' + std::string(length, 'a') + '"'; };
    for (const std::size_t below : {std::size_t{1}, std::size_t{0}}) {
        EXPECT_TRUE(parseJson(text(limits::kTextBytes - below), "x").ok());
    }
    EXPECT_FALSE(parseJson(text(limits::kTextBytes + 1), "x").ok());
    EXPECT_TRUE(parseJson("[1,2]", "x", nullptr, JsonLimits{.bytes = 5, .values = 3}).ok());
    EXPECT_FALSE(parseJson("[1,2]", "x", nullptr, JsonLimits{.bytes = 4}).ok());
    EXPECT_FALSE(parseJson("[1,2]", "x", nullptr, JsonLimits{.values = 2}).ok());
}

TEST(JsonText, aRepeatedKeyIsAnErrorOrAWarningIfProblemsAreCollected) {
    EXPECT_FALSE(parseJson(R"({"a": 1, "a": 2})", "x").ok());

    std::vector<Error> warnings;
    const Result<Json> result = parseJson(R"({"a": 1, "b": 5, "a": 2})", "x", &warnings);
    ASSERT_TRUE(result.ok());
    EXPECT_EQ((*result)["a"].get<int>(), 2);
    EXPECT_EQ(result->size(), 2u);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].where, "x:1:18");
}

TEST(JsonText, aRepeatedKeyIsAlsoFoundInALargeObject) {
    std::string text = "{";
    for (int i = 0; i < 1000; ++i) text += format("\"key{}\": {}, ", i, i);
    std::vector<Error> warnings;

    EXPECT_FALSE(parseJson(text + "\"key7\": 0}", "x").ok());
    EXPECT_TRUE(parseJson(text + "\"key15\": 0, \"key16\": 0, \"key999\": 1}", "x", &warnings).ok());

    EXPECT_EQ(warnings.size(), 3u);
}

TEST(JsonText, theFileFormatHasOnePropertyPerLineAndNumbersInline) {
    const Json json = parsed(
        R"({"format":1,"position":[10,20.5],"names":["Space","Pad A"],"empty":{},"none":[],"points":[[0,0],[8,-8]],"list":[{"a":1}],"rows":["1 2 3 4 5 6 7 8 9","1 2 3"]})");

    EXPECT_EQ(writeJson(json), R"({
  "format": 1,
  "position": [10, 20.5],
  "names": ["Space", "Pad A"],
  "empty": {},
  "none": [],
  "points": [[0, 0], [8, -8]],
  "list": [
    {
      "a": 1
    }
  ],
  "rows": [
    "1 2 3 4 5 6 7 8 9",
    "1 2 3"
  ]
}
)");
}

TEST(JsonText, aTooWideArrayHasOneItemPerLine) {
    Json json = Json::object();
    for (int i = 0; i < 40; ++i) json["wide"].push_back(100 + i);

    const std::string text = writeJson(json);

    EXPECT_EQ(text.substr(0, 32), "{\n  \"wide\": [\n    100,\n    101,\n");
    EXPECT_EQ(writeJson(parsed(text)), text);
}

TEST(JsonText, theCompactFormatPutsEverythingThatFitsOnOneLine) {
    const Json json =
        parsed(R"({"a": {"b": [1, {"c": "x"}], "d": {}}, "list": ["a long text that stands here", 2]})");
    EXPECT_EQ(writeCompactJson(json), R"({
  "a": {"b": [1, {"c": "x"}], "d": {}},
  "list": ["a long text that stands here", 2]
}
)");
    Json wide = Json::object();
    for (int i = 0; i < 12; ++i) wide["wide"].push_back(Json::object({{"number", i}, {"text", "some"}}));
    const std::string text = writeCompactJson(wide);
    const std::string_view start = "{\n  \"wide\": [\n    {\"number\": 0, \"text\": \"some\"},\n    {";
    EXPECT_EQ(text.substr(0, start.size()), start);
    EXPECT_EQ(writeCompactJson(parsed(text)), text);
}

TEST(JsonText, everyFloatReadsBackToItsOwnBits) {
    Random random = Random::seeded(1);
    for (int i = 0; i < 50000; ++i) {
        const auto value = std::bit_cast<float>(random.next());
        if (!std::isfinite(value)) continue;
        const std::string text = writeJson(Json(value));
        ASSERT_EQ(std::bit_cast<std::uint32_t>(parsed(text).get<float>()),
                  std::bit_cast<std::uint32_t>(value))
            << text;
        ASSERT_EQ(writeJson(parsed(text)), text);
    }
    EXPECT_EQ(writeJson(Json(0.1f)), "0.1\n");
    EXPECT_EQ(writeJson(Json(-0.0f)), "-0\n");
    EXPECT_TRUE(std::signbit(parsed("-0").get<float>()));
}

Json randomJson(Random& random, int depth) {
    switch (random.below(depth > 4 ? 6 : 8)) {
        case 0: return nullptr;
        case 1: return random.below(2) == 1;
        case 2: return static_cast<std::int64_t>(random.next64());
        case 3: return random.between(-1000.0f, 1000.0f);
        case 4: return random.next64();
        case 5: {
            std::string text;
            for (std::uint32_t n = random.below(24); n > 0; --n) text += static_cast<char>(random.below(128));
            return text;
        }
        case 6: {
            Json array = Json::array();
            for (std::uint32_t n = random.below(6); n > 0; --n)
                array.push_back(randomJson(random, depth + 1));
            return array;
        }
        default: {
            Json object = Json::object();
            for (std::uint32_t n = random.below(6); n > 0; --n)
                object[format("k\"{}", n)] = randomJson(random, depth + 1);
            return object;
        }
    }
}

TEST(JsonText, randomValuesReadBackUnchanged) {
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const std::string text = writeJson(randomJson(random, 0));

        ASSERT_EQ(writeJson(parsed(text)), text);
    }
}

TEST(JsonText, randomBytesAndMutationsNeverCrash) {
    const std::string good =
        R"({"format": 1, "a": [1, 2.5e3, "x\u00e9\n"], "b": {"c": [true, false, null]}})";
    Random random = Random::seeded(5);
    for (int i = 0; i < 50000; ++i) {
        std::string text = test::withWrongBytes(good, random, 4);
        text.resize(random.below(static_cast<std::uint32_t>(text.size()) + 1));
        if (const Result<Json> result = parseJson(text, "x"); result.ok()) {
            EXPECT_TRUE(parseJson(writeJson(*result), "x").ok());
        }
    }
}

}  // namespace
}  // namespace plumb
