#include "reflect/json_text.hpp"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

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

/// True for a number of JSON. Source: RFC 8259, section 6: [ minus ] int [ frac ] [ exp ].
bool isNumberText(std::string_view text) {
    const auto takeDigits = [&] {
        std::size_t count = 0;
        for (; !text.empty() && text.front() >= '0' && text.front() <= '9'; ++count) text.remove_prefix(1);
        return count;
    };
    const auto take = [&](std::string_view oneOf) {
        const bool isThere = !text.empty() && oneOf.find(text.front()) != std::string_view::npos;
        if (isThere) text.remove_prefix(1);
        return isThere;
    };
    take("-");
    if (!take("0") && takeDigits() == 0) return false;
    if (take(".") && takeDigits() == 0) return false;
    if (take("eE")) {
        take("+-");
        if (takeDigits() == 0) return false;
    }
    return text.empty();
}

TEST(JsonTextProperty, exactlyTheNumbersOfTheStandardAreRead) {
    constexpr std::string_view kLetters = "0129-+.eE";
    int numbers = 0;
    for (std::size_t length = 1; length <= 5; ++length) {
        std::size_t count = 1;
        for (std::size_t i = 0; i < length; ++i) count *= kLetters.size();
        for (std::size_t which = 0; which < count; ++which) {
            std::string text;
            for (std::size_t i = 0, rest = which; i < length; ++i, rest /= kLetters.size())
                text += kLetters[rest % kLetters.size()];
            const Result<Json> json = parseJson(text, "x");
            if (isNumberText(text)) {
                const double exact = std::strtod(text.c_str(), nullptr);
                if (std::isinf(exact) ||
                    (exact == 0.0 && text.find_first_of("129") < text.find_first_of("eE")))
                    continue;  // beyond a double
                ASSERT_TRUE(json.ok()) << text;
                ASSERT_EQ(json->get<double>(), exact) << text;
                ASSERT_EQ(json->is_number_float(),
                          text == "-0" || text.find_first_of(".eE") != std::string::npos);
                ++numbers;
            } else {
                ASSERT_FALSE(json.ok()) << text;
            }
        }
    }
    EXPECT_GT(numbers, 1000);
}

/// The UTF-8 form of a character, from the table of its definition (RFC 3629, section 3).
std::string utf8Of(std::uint32_t code) {
    std::string bytes;
    int more = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    constexpr std::uint32_t kLeads[] = {0, 0xc0, 0xe0, 0xf0};
    bytes += static_cast<char>(static_cast<unsigned char>(kLeads[more] + (code >> (6 * more))));
    while (more-- > 0)
        bytes += static_cast<char>(static_cast<unsigned char>(0x80 + (code >> (6 * more)) % 64));
    return bytes;
}

TEST(JsonTextProperty, escapesOfAllCharactersAreRead) {
    const auto escaped = [](std::uint32_t unit) { return "\\u" + hexText(unit).substr(12); };
    for (std::uint32_t code = 0; code < 0x110000;
         code += code < 0x3000 || (code >= 0xd700 && code < 0xe100) ? 1 : 97) {
        const bool isHalf = code >= 0xd800 && code < 0xe000;
        const std::uint32_t above = code - 0x10000;
        const std::string text =
            code < 0x10000 ? escaped(code) : escaped(0xd800 + (above >> 10)) + escaped(0xdc00 + above % 1024);
        const Result<Json> json = parseJson("\"" + text + "\"", "x");
        ASSERT_EQ(json.ok(), !isHalf) << code;
        ASSERT_TRUE(isHalf || *json->get_ptr<const std::string*>() == utf8Of(code)) << code;
    }
    for (const std::uint32_t second : {0xdbffu, 0xdc00u, 0xdfffu, 0xe000u, 0x41u}) {
        const bool isPair = second >= 0xdc00 && second < 0xe000;
        EXPECT_EQ(parseJson("\"" + escaped(0xdbff) + escaped(second) + "\"", "x").ok(), isPair) << second;
    }
    for (const char* wrong : {R"("\ud800")", R"("\ud800x")", R"("\ud800\n")", R"("\ud800\u12")", R"("\u")",
                              R"("\u123")", R"("\uD83D\uDE0")"})
        EXPECT_FALSE(parseJson(wrong, "x").ok()) << wrong;
}

TEST(JsonTextProperty, allCharactersOfTextsReadBackAndControlCharactersAreEscaped) {
    for (int c = 1; c < 128; ++c) {
        const std::string one(1, static_cast<char>(c)), text = "a" + one + "b" + one;
        const std::string written = writeJson(Json(text));
        ASSERT_EQ(*parsed(written).get_ptr<const std::string*>(), text) << c;
        const bool isEscaped = c < 0x20 || c == '"' || c == '\\';
        ASSERT_EQ(written == "\"" + text + "\"\n", !isEscaped) << c;
        ASSERT_EQ(parseJson("\"" + text + "\"", "x").ok(), !isEscaped) << c;
    }
    EXPECT_EQ(writeJson(Json("\x1f\n\r\t\b")), "\"\\u001f\\n\\r\\t\\u0008\"\n");
    EXPECT_EQ(parsed(R"("\"\\\/\b\f\n\r\t")"), "\"\\/\b\f\n\r\t");
}

TEST(JsonText, nothingBehindAPartOfATextIsRead) {
    for (const std::string_view text :
         {"-12.5e+30 ", "0.5", "true ", "null", R"("a\u00e9\ud83d\ude00\n")", R"({"a": [1, 2]} )"}) {
        for (std::size_t size = 0; size < text.size(); ++size) {
            const std::string alone{text.substr(0, size)};
            const Result<Json> part = parseJson(text.substr(0, size), "x"), copy = parseJson(alone, "x");
            ASSERT_EQ(part.ok(), copy.ok()) << alone;
            EXPECT_EQ(part ? part->dump() : part.error().text(), copy ? copy->dump() : copy.error().text())
                << alone;
        }
    }
}

TEST(JsonText, blanksAndAMarkOfUtf8AreSkipped) {
    EXPECT_EQ(parsed("\xef\xbb\xbf [ 1 ,\t2\r\n] \n").dump(), "[1,2]");
    EXPECT_EQ(parsed(" { \"a\" :\n1 , \"b\" : [ ] , \"c\" : { } } ").dump(), R"({"a":1,"b":[],"c":{}})");
    EXPECT_FALSE(parseJson("\f1", "x").ok());
    EXPECT_FALSE(parseJson("\v1", "x").ok());
}

TEST(JsonText, theFoundCharacterIsNamed) {
    const auto what = [](std::string_view text) { return parseJson(text, "x").error().what; };
    EXPECT_EQ(what(""), "expected a value, found the end of the file");
    EXPECT_EQ(what("?"), "expected a value, found \"?\"");
    EXPECT_EQ(what("~"), "expected a value, found \"~\"");
    EXPECT_EQ(what("\x7f"), "expected a value, found a character 127");
    EXPECT_EQ(what("\x1f"), "expected a value, found a character 31");
    EXPECT_EQ(what("[1 \"a\"]"), "expected \",\" or \"]\", found a string");
    EXPECT_EQ(what("1 !"), "expected the end of the file, found \"!\"");
    EXPECT_EQ(what("\xc3\xa9"), "expected a value, found a character 195");
    EXPECT_EQ(what("1e999"), "the number is too large for a double");
    EXPECT_EQ(what("{\"a\" 1}"), "expected \":\", found \"1\"");
}

TEST(JsonText, placesAreLinesAndColumnsFromOne) {
    const auto where = [](std::string_view text) { return parseJson(text, "x").error().where; };
    EXPECT_EQ(where("?"), "x:1:1");
    EXPECT_EQ(where("  ?"), "x:1:3");
    EXPECT_EQ(where("\n?"), "x:2:1");
    EXPECT_EQ(where("[\n\n  1,\n ?]"), "x:4:2");
    EXPECT_EQ(where("[1, \"a\nb\"]"), "x:1:7");
    EXPECT_EQ(where("[1, \"ab"), "x:1:5") << "where the text begins";
    EXPECT_EQ(where("{\"a\": 1,\n \"a\": 2}"), "x:2:2");
    EXPECT_EQ(where("[1] 2"), "x:1:5");
}

TEST(JsonText, wholeNumbersAreExactToTheirLimits) {
    for (const char* text : {"9223372036854775807", "9223372036854775808", "18446744073709551615",
                             "-9223372036854775808", "0", "-1"})
        EXPECT_EQ(parsed(text).dump(), text);
    EXPECT_TRUE(parsed("18446744073709551616").is_number_float());
    EXPECT_TRUE(parsed("-9223372036854775809").is_number_float());
    EXPECT_FALSE(parsed("1").is_number_float());
}

TEST(JsonText, repeatedKeysAreFoundInObjectsOfAllSizes) {
    for (int size = 1; size <= 40; ++size) {
        std::string text = "{";
        for (int i = 0; i < size; ++i) text += format("\"k{}\": {}, ", i, i);
        for (int i = 0; i < size; ++i) {
            std::vector<Error> warnings;
            const Result<Json> json = parseJson(text + format("\"k{}\": -1}", i), "x", &warnings);
            ASSERT_TRUE(json.ok());
            ASSERT_EQ(warnings.size(), 1u) << size << " " << i;
            ASSERT_EQ(json->size(), static_cast<std::size_t>(size));
            for (int k = 0; k < size; ++k) ASSERT_EQ((*json)[format("k{}", k)], k == i ? -1 : k);
        }
        std::vector<Error> warnings;
        ASSERT_TRUE(parseJson(text + "\"new\": 1}", "x", &warnings).ok());
        ASSERT_TRUE(warnings.empty()) << size;
    }
}

TEST(JsonText, escapedTextsCountToTheirLimit) {
    const JsonLimits limits{.textBytes = 3};
    EXPECT_TRUE(parseJson(R"("abc")", "x", nullptr, limits).ok());
    EXPECT_FALSE(parseJson(R"("abcd")", "x", nullptr, limits).ok());
    EXPECT_TRUE(parseJson(R"("a\u20ac")", "x", nullptr, JsonLimits{.textBytes = 4}).ok());
    EXPECT_FALSE(parseJson(R"("a\u20ac")", "x", nullptr, limits).ok());
    EXPECT_FALSE(parseJson(R"({"abcd": 1})", "x", nullptr, limits).ok()) << "names too";
    for (const int depth : {0, 1, 2}) {
        const std::string inner = depth == 0 ? "1" : depth == 1 ? "{\"a\": 1}" : "{\"a\": [1]}";
        EXPECT_TRUE(parseJson(inner, "x", nullptr, JsonLimits{.depth = depth}).ok());
        EXPECT_FALSE(parseJson("[" + inner + "]", "x", nullptr, JsonLimits{.depth = depth}).ok());
        EXPECT_FALSE(parseJson("{\"b\": " + inner + "}", "x", nullptr, JsonLimits{.depth = depth}).ok());
    }
    for (std::size_t values = 0; values < 5; ++values)
        EXPECT_EQ(parseJson(R"({"a": [1, 2], "b": 3})", "x", nullptr, JsonLimits{.values = values}).ok(),
                  false);
    EXPECT_TRUE(parseJson(R"({"a": [1, 2], "b": 3})", "x", nullptr, JsonLimits{.values = 5}).ok());
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
