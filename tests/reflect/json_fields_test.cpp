#include "reflect/json_fields.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "reflect/json.hpp"

namespace plumb {
namespace {

using Texts = std::vector<std::string>;

struct Fields : testing::Test {
    std::vector<Error> problems;
    Json json;

    JsonFields of(Json object) {
        json = std::move(object);
        return {json, "x", problems};
    }
    /// The problems since the last call.
    Texts taken() {
        Texts texts;
        for (const Error& problem : std::exchange(problems, {})) texts.push_back(problem.text());
        return texts;
    }
};

TEST_F(Fields, missingPropertiesHaveTheirFallbackWithoutAProblem) {
    JsonFields fields = of(Json::object());
    EXPECT_EQ(fields.find("a"), nullptr);
    EXPECT_EQ(fields.text("a", "none"), "none");
    EXPECT_TRUE(fields.flag("a", true));
    EXPECT_FALSE(fields.flag("a", false));
    EXPECT_EQ(fields.whole("a", 7, 0, 9), 7);
    EXPECT_EQ(fields.number("a", 0.5f, 0.0f, 1.0f), 0.5f);
    EXPECT_EQ(fields.vec2("a", {1.0f, 2.0f}), (Vec2{1.0f, 2.0f}));
    EXPECT_EQ(fields.choice("a", 1, {}), 1u);
    EXPECT_TRUE(fields.objects("a", 5).empty());
    EXPECT_EQ(fields.array("a"), nullptr);
    EXPECT_TRUE(fields.kept("a").empty());
    EXPECT_EQ(taken(), Texts{});
    EXPECT_EQ(fields.where(), "x");
}

TEST_F(Fields, valuesAreReadAndWrongOnesReportedWithTheFallback) {
    JsonFields fields =
        of({{"text", "t"}, {"flag", true}, {"off", false}, {"pair", {1.5, -2}}, {"word", "two"}});
    EXPECT_EQ(fields.text("text", "none"), "t");
    EXPECT_TRUE(fields.flag("flag", false));
    EXPECT_FALSE(fields.flag("off", true));
    EXPECT_EQ(fields.vec2("pair", {}), (Vec2{1.5f, -2.0f}));
    constexpr std::string_view kNames[] = {"one", "two"};
    EXPECT_EQ(fields.choice("word", 0, kNames), 1u);
    EXPECT_EQ(taken(), Texts{});
    EXPECT_EQ(fields.text("flag", "none"), "none");
    EXPECT_EQ(fields.flag("text", true), true);
    EXPECT_EQ(fields.whole("text", 7, 0, 9), 7);
    EXPECT_EQ(fields.number("text", 0.5f, 0.0f, 9.0f), 0.5f);
    EXPECT_EQ(fields.vec2("text", {3.0f, 4.0f}), (Vec2{3.0f, 4.0f}));
    EXPECT_EQ(fields.choice("text", 0, kNames), 0u);
    EXPECT_EQ(fields.array("text"), nullptr);
    EXPECT_TRUE(fields.kept("text").empty());
    EXPECT_EQ(taken(), (Texts{"x.flag: expected a string, found true; put it in double quotes",
                              "x.text: expected true or false, found \"t\"; write true or false",
                              "x.text: expected a whole number from 0 to 9, found \"t\"; correct it",
                              "x.text: expected a number from 0 to 9, found \"t\"; correct it",
                              "x.text: expected two numbers, found \"t\"; write [x, y]",
                              "x.text: unknown value \"t\"; write one of: one, two",
                              "x.text: expected an array, found \"t\"; write [ ... ]",
                              "x.text: expected an object, found \"t\"; write { \"name\": value }"}));
}

TEST_F(Fields, numbersAreReadUpToTheirLimits) {
    for (const double value : {-3.0, -2.0, -1.5, 0.0, 0.5, 4.0, 4.5, 5.0}) {
        JsonFields fields = of({{"n", value}});
        const bool isIn = value >= -2.0 && value <= 4.0, isWhole = value == std::floor(value);
        EXPECT_EQ(fields.number("n", 99.0f, -2.0f, 4.0f), isIn ? static_cast<float>(value) : 99.0f);
        EXPECT_EQ(taken().size(), isIn ? 0u : 1u) << value;
        EXPECT_EQ(fields.whole("n", 99, -2, 4), isIn && isWhole ? static_cast<int>(value) : 99);
        EXPECT_EQ(taken().size(), isIn && isWhole ? 0u : 1u) << value;
    }
}

TEST_F(Fields, pairsHaveTwoNumbers) {
    for (const Json& wrong :
         {Json{1}, Json{1, 2, 3}, Json{1, "b"}, Json{"a", 2}, Json::array(), Json{1, 1e300}}) {
        EXPECT_EQ(of({{"p", wrong}}).vec2("p", {3.0f, 4.0f}), (Vec2{3.0f, 4.0f})) << wrong;
        EXPECT_EQ(taken().size(), 1u) << wrong;
    }
}

TEST_F(Fields, objectsOfAnArrayAreReadUpToALimitEachWithItsPath) {
    for (const std::size_t limit : {0u, 1u, 2u, 3u}) {
        std::vector<JsonFields> items = of({{"list", {{{"n", 5}}, {{"n", 6}}}}}).objects("list", limit);
        ASSERT_EQ(items.size(), std::min<std::size_t>(limit, 2));
        for (std::size_t i = 0; i < items.size(); ++i) {
            EXPECT_EQ(items[i].where(), "x.list[" + std::to_string(i) + "]");
            EXPECT_EQ(items[i].whole("n", 0, 0, 9), static_cast<int>(5 + i));
        }
        EXPECT_EQ(taken(), limit < 2 ? Texts{"x.list: 2 items, the limit is " + std::to_string(limit) +
                                             "; remove some"}
                                     : Texts{});
    }
    const std::vector<JsonFields> items = of({{"list", {3, Json::object()}}}).objects("list", 9);
    EXPECT_EQ(items.size(), 2u);
    EXPECT_EQ(taken(), Texts{"x.list[0]: expected an object, found 3; write { ... }"});
}

TEST_F(Fields, anythingButAnObjectIsReadAsAnEmptyOne) {
    for (const Json& other : {Json{1}, Json{}, Json("text")}) {
        JsonFields fields = of(other);
        EXPECT_EQ(taken().size(), 1u);
        EXPECT_EQ(fields.find("a"), nullptr);
        EXPECT_TRUE(fields.keepUnknown().empty());
    }
}

TEST_F(Fields, formatsUpToTheNewestAreAccepted) {
    EXPECT_TRUE(of(Json::object()).acceptFormat(3));
    for (const int stated : {1, 2, 3}) EXPECT_TRUE(of({{"format", stated}}).acceptFormat(3)) << stated;
    EXPECT_EQ(taken(), Texts{});
    EXPECT_FALSE(of({{"format", 4}}).acceptFormat(3));
    EXPECT_EQ(taken(),
              Texts{"x.format: the file has format 4, this program reads up to 3; update the program"});
    EXPECT_TRUE(of({{"format", 0}}).acceptFormat(3)) << "no format: read as the newest, with a problem";
    EXPECT_EQ(taken().size(), 1u);
}

TEST_F(Fields, propertiesThatWereNotReadAreReportedAndKept) {
    JsonFields fields = of({{"speed", 1}, {"sped", {1, 2}}, {"zzzzzz", "t"}, {"tiled", 5}});
    EXPECT_EQ(fields.whole("speed", 0, 0, 9), 1);
    const std::vector<KeptProperty> kept = fields.keepUnknown();
    EXPECT_EQ(kept, (std::vector<KeptProperty>{{"sped", "[1,2]"}, {"zzzzzz", "\"t\""}, {"tiled", "5"}}));
    EXPECT_EQ(taken(), (Texts{"x.sped: unknown property; did you mean \"speed\"?",
                              "x.zzzzzz: unknown property; remove it"}))
        << "notes of importers are kept without a problem";
    Json back = Json::object({{"speed", 1}});
    writeKept(back, kept);
    EXPECT_EQ(back.dump(), json.dump());
    writeKept(back, {{"broken", "[1"}});
    EXPECT_TRUE(back["broken"].is_null());
}

TEST_F(Fields, nestedObjectsAreKeptUnchanged) {
    EXPECT_EQ(of({{"custom", {{"a", 1}, {"b", {2}}}}}).kept("custom"),
              (std::vector<KeptProperty>{{"a", "1"}, {"b", "[2]"}}));
    EXPECT_EQ(taken(), Texts{});
}

TEST_F(Fields, valuesAreShownShortly) {
    EXPECT_EQ(briefText(Json::array()), "[]");
    EXPECT_EQ(briefText(Json{1}), "[...]");
    EXPECT_EQ(briefText(Json::object()), "{}");
    EXPECT_EQ(briefText(Json{{"a", 1}}), "{...}");
    EXPECT_EQ(briefText(Json(1.5)), "1.5");
    EXPECT_EQ(briefText(Json(std::string(38, 'a'))), "\"" + std::string(38, 'a') + "\"") << "40 bytes";
    EXPECT_EQ(briefText(Json(std::string(39, 'a'))), "\"" + std::string(39, 'a') + "...");
}

}  // namespace
}  // namespace plumb
