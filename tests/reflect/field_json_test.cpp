#include "reflect/field_json.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/limits.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "math/color.hpp"
#include "reflect/compare.hpp"
#include "reflect/component_json.hpp"
#include "reflect/json.hpp"
#include "reflect/type_registry.hpp"
#include "tests/support/plain_context.hpp"

namespace plumb {
namespace {

enum class Mood : std::uint8_t { Calm, Angry };

struct Sample {
    bool flag = false;
    int count = 3;
    std::uint8_t small = 0;
    std::uint64_t large = 0;
    float rate = 1.5f;
    Vec2 place;
    Rect part;
    Color tint;
    TextId title;
    Mood mood = Mood::Calm;
    EntityId target;
    TextureId picture;
    FixedList<float, 3> numbers;
    int hidden = 0;

    static void describe(TypeBuilder<Sample>& type) {
        type.name("Sample");
        type.field<&Sample::flag>("flag");
        type.field<&Sample::count>("count").range(-10.0f, 10.0f);
        type.field<&Sample::small>("small");
        type.field<&Sample::large>("large");
        type.field<&Sample::rate>("rate").unit(Unit::RadiansPerSecond).range(-20.0f, 20.0f).was("speed");
        type.field<&Sample::place>("place").unit(Unit::Pixels);
        type.field<&Sample::part>("part").unit(Unit::Pixels);
        type.field<&Sample::tint>("tint");
        type.field<&Sample::title>("title");
        type.field<&Sample::mood>("mood").names({{"calm", 0}, {"angry", 1}});
        type.field<&Sample::target>("target");
        type.field<&Sample::picture>("picture");
        type.field<&Sample::numbers>("numbers");
        type.field<&Sample::hidden>("hidden").transient();
    }
};

struct FieldJson : testing::Test {
    TypeRegistry types;
    const TypeInfo& type = types.add<Sample>();
    test::PlainContext context;
    Sample sample;

    Result<Done> read(std::string_view field, const Json& json) {
        return fieldFromJson(*type.find(field), &sample, json, context);
    }
    Json write(std::string_view field) { return fieldToJson(*type.find(field), &sample, context); }
};

TEST_F(FieldJson, aWrongValueIsReportedWithFieldFoundValueAndRemedy) {
    const auto result = read("rate", "fast");

    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().text(),
              "rate: expected a number, found \"fast\"; write radians per second, e.g. 1.5");
    EXPECT_EQ(sample.rate, 1.5f);
}

TEST_F(FieldJson, aNumberOutsideItsRangeIsClampedAndReported) {
    ASSERT_TRUE(read("rate", 100));
    ASSERT_TRUE(read("count", -1000));

    EXPECT_EQ(sample.rate, 20.0f);
    EXPECT_EQ(sample.count, -10);
    ASSERT_EQ(context.warnings.size(), 2u);
    EXPECT_EQ(context.warnings[0].text(),
              "rate: 100 is outside -20 to 20; using 20; write a value inside the range");
}

TEST_F(FieldJson, nonFiniteNumbersAreRejected) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300}) {
        EXPECT_FALSE(read("rate", bad));
        EXPECT_FALSE(read("place", Json::array({1.0, bad})));
        EXPECT_FALSE(read("numbers", Json::array({bad})));
    }
    EXPECT_EQ(sample.rate, 1.5f);
    EXPECT_EQ(sample.place, Vec2{});
}

TEST_F(FieldJson, aMistypedNameIsReportedWithTheClosestOne) {
    const auto result = read("mood", "angri");

    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().remedy, "did you mean \"angry\"?");
}

TEST_F(FieldJson, aPathThatLeavesTheProjectIsRefused) {
    for (const char* path :
         {"../secret.png", "/etc/passwd", "C:/x.png", "a\\b.png", "a/../../b.png", "a\nb"}) {
        SCOPED_TRACE(path);
        EXPECT_FALSE(read("picture", path));
    }
    EXPECT_TRUE(read("picture", "engine:icons/star.png"));
    EXPECT_TRUE(read("picture", "assets/a..b.png"));
}

TEST_F(FieldJson, entitiesAreWrittenByTheirStableIds) {
    ASSERT_TRUE(read("target", "ab"));
    EXPECT_EQ(sample.target, (EntityId{7, 1}));
    EXPECT_EQ(write("target"), "00000000000000ab");
    ASSERT_FALSE(read("target", "cd"));
    EXPECT_EQ(sample.target, (EntityId{7, 1}));
    ASSERT_TRUE(read("target", nullptr));
    EXPECT_TRUE(write("target").is_null());
}

TEST_F(FieldJson, theLargestUnsignedNumberSurvives) {
    ASSERT_TRUE(read("large", std::numeric_limits<std::uint64_t>::max()));
    EXPECT_EQ(write("large"), std::numeric_limits<std::uint64_t>::max());
    ASSERT_TRUE(read("small", 300));
    EXPECT_EQ(sample.small, 255);
}

TEST_F(FieldJson, colorsReadInBothFormsAndAreWrittenInOne) {
    ASSERT_TRUE(read("tint", "#ff8000"));
    EXPECT_EQ(write("tint"), "#ff8000ff");
    ASSERT_TRUE(read("tint", "#01020304"));
    EXPECT_EQ(sample.tint, (Color{1, 2, 3, 4}));
    EXPECT_FALSE(read("tint", "red"));
    EXPECT_FALSE(read("tint", "#12345"));
}

TEST_F(FieldJson, aListReadsValidItemsAndReportsOthers) {
    ASSERT_TRUE(read("numbers", Json::array({1, 2, 3, 4})));
    EXPECT_EQ(sample.numbers.size(), 3u);
    EXPECT_EQ(context.warnings.size(), 1u);
    EXPECT_FALSE(read("numbers", Json::array({1, "x"})));
    EXPECT_EQ(sample.numbers.size(), 3u);
}

TEST_F(FieldJson, onlyFieldsThatDifferFromTheDefaultsAreWritten) {
    sample.count = 5;
    sample.hidden = 9;
    const Sample defaults;

    EXPECT_EQ(componentToJson(type, &sample, &defaults, context).dump(), R"({"count":5})");
}

TEST_F(FieldJson, oldNamesStillLoadAndUnknownOnesAreReported) {
    const Json json = {{"speed", 2.0}, {"ratee", 3.0}, {"hidden", 4}};
    std::vector<FieldProblem> problems;
    componentFromJson(type, &sample, json, context, problems);

    EXPECT_EQ(sample.rate, 2.0f);
    EXPECT_EQ(sample.hidden, 0);
    ASSERT_EQ(problems.size(), 2u);
    EXPECT_EQ(problems[0].key, "ratee");
    EXPECT_EQ(problems[0].error.where, "Sample.ratee");
    EXPECT_NE(problems[0].error.remedy.find("did you mean \"rate\"?"), std::string::npos);
    EXPECT_EQ(problems[1].key, "hidden");
}

TEST_F(FieldJson, floatsAreReadUpToTheirLimits) {
    constexpr float kMax = std::numeric_limits<float>::max();
    for (const double sign : {1.0, -1.0}) {
        EXPECT_TRUE(read("place", Json::array({0, sign * double{kMax}})));
        EXPECT_FALSE(read("place", Json::array({0, sign * std::nextafter(double{kMax}, 1e300)})));
    }
    context.warnings.clear();
    for (const double value : {-20.0, 20.0, 0.0}) ASSERT_TRUE(read("rate", value));
    EXPECT_TRUE(context.warnings.empty());
    for (const double value : {-20.5, 20.5}) {
        ASSERT_TRUE(read("rate", value));
        EXPECT_EQ(sample.rate, value < 0 ? -20.0f : 20.0f);
    }
    EXPECT_EQ(context.warnings.size(), 2u);
    ASSERT_TRUE(read("rate", -0.0));
    EXPECT_TRUE(std::signbit(sample.rate));
}

TEST_F(FieldJson, groupsOfNumbersHaveTheirExactSizeAndNameTheWrongOne) {
    EXPECT_EQ(read("place", Json::array({1})).error().text(),
              "place: expected [x, y], found a list of 1; write 2 numbers in pixels");
    EXPECT_EQ(read("part", Json::array({1, 2, 3, 4, 5})).error().text(),
              "part: expected [x, y, width, height], found a list of 5; write 4 numbers in pixels");
    EXPECT_EQ(read("part", Json::array({1, 2, "w", 4})).error().where, "part[2]");
    ASSERT_TRUE(read("part", Json::array({1, 2.5, -3, 4})));
    EXPECT_EQ(sample.part, (Rect{1.0f, 2.5f, -3.0f, 4.0f}));
    EXPECT_EQ(write("part").dump(), "[1.0,2.5,-3.0,4.0]");
    EXPECT_FALSE(read("place", 1));
}

TEST_F(FieldJson, unitsAreNamedInRemedies) {
    const std::pair<Unit, std::string_view> units[] = {
        {Unit::None, "a number"},
        {Unit::Pixels, "pixels"},
        {Unit::PixelsPerSecond, "pixels per second"},
        {Unit::PixelsPerSecondSquared, "pixels per second squared"},
        {Unit::Seconds, "seconds"},
        {Unit::Radians, "radians"},
        {Unit::RadiansPerSecond, "radians per second"},
        {Unit::Ratio, "a ratio"},
        {Unit::Kilograms, "kilograms"},
        {Unit::Tiles, "tiles"},
        {Unit::Ticks, "ticks"},
        {Unit::Degrees, "degrees"}};
    for (const auto& [unit, words] : units) {
        FieldInfo field = *type.find("rate");
        field.unit = unit;
        float value = 0.0f;
        EXPECT_EQ(valueFromJson(field, &value, "x", context).error().remedy,
                  format("write {}, e.g. 1.5", words));
    }
}

TEST_F(FieldJson, colorsHaveAHashAndSixOrEightHexDigits) {
    for (const char* wrong :
         {"", "#", "ff8000", "#ff800", "#ff80001", "#ff8000000", "xff8000", "#ff80g0", "#-f8000"})
        EXPECT_FALSE(read("tint", wrong)) << wrong;
    Random random = Random::seeded(1);
    for (int i = 0; i < 100; ++i) {
        const std::string text = "#" + hexText(random.next()).substr(8);
        ASSERT_TRUE(read("tint", text));
        EXPECT_EQ(write("tint"), text);
        const std::uint32_t all =
            sample.tint.r * 0x1000000u + sample.tint.g * 0x10000u + sample.tint.b * 0x100u + sample.tint.a;
        EXPECT_EQ("#" + hexText(all).substr(8), text);
    }
}

TEST_F(FieldJson, textsAreReadUpToTheirLimitInUtf8) {
    ASSERT_TRUE(read("title", std::string(limits::kTextBytes, 'a')));
    EXPECT_EQ(context.text(sample.title).size(), limits::kTextBytes);
    EXPECT_FALSE(read("title", std::string(limits::kTextBytes + 1, 'a')));
    EXPECT_EQ(read("title", "\xff").error().text(), "title: the string is not UTF-8; write it as UTF-8");
    EXPECT_FALSE(read("picture", "\xff"));
    EXPECT_FALSE(read("title", 3));
    ASSERT_TRUE(read("title", ""));
    EXPECT_TRUE(sample.title.empty());
}

TEST_F(FieldJson, pathsOfAssetsStayInTheProject) {
    for (const char* good : {"", "a", ":a", "a b.png", "...", "a/.../b", "ab:c"})
        EXPECT_TRUE(read("picture", good)) << good;
    for (const char* bad : {"..", "a/..", "/", "\\a", "a:", "a:b", "a\x1f", "\x01"})
        EXPECT_FALSE(read("picture", bad)) << bad;
}

TEST_F(FieldJson, theIdZeroIsNoEntity) {
    ASSERT_TRUE(read("target", "ab"));
    for (const Json& wrong : {Json("0"), Json("0000000000000000"), Json("xyz"), Json(1)}) {
        EXPECT_FALSE(read("target", wrong));
        EXPECT_EQ(sample.target, (EntityId{7, 1}));
    }
}

TEST_F(FieldJson, enumsOfOneByteAreUnsignedAndLargerOnesSigned) {
    FieldInfo field = *type.find("mood");
    field.names = {{"low", -1}, {"high", 200}};
    std::int32_t value = 0;
    field.size = 1;
    ASSERT_TRUE(valueFromJson(field, &value, "high", context));
    EXPECT_EQ(value, 200);
    EXPECT_EQ(valueToJson(field, &value, context), "high");
    field.size = 4;
    ASSERT_TRUE(valueFromJson(field, &value, "low", context));
    EXPECT_EQ(value, -1);
    EXPECT_EQ(valueToJson(field, &value, context), "low");
    value = -5;
    EXPECT_EQ(valueToJson(field, &value, context), -5) << "without a name";
    EXPECT_EQ(valueFromJson(field, &value, "zzzzzz", context).error().text(),
              "mood: expected one of low, high, found \"zzzzzz\"; write one of these names in quotes");
    EXPECT_FALSE(valueFromJson(field, &value, 200, context));
}

TEST_F(FieldJson, listsReadAllItemsOrNone) {
    ASSERT_TRUE(read("numbers", Json::array({1, 2, 3})));
    EXPECT_TRUE(context.warnings.empty()) << "as many as there is room for";
    EXPECT_EQ(write("numbers").dump(), "[1.0,2.0,3.0]");
    EXPECT_EQ(read("numbers", Json::array({1, 2, "x"})).error().where, "numbers[2]");
    EXPECT_EQ(sample.numbers.size(), 3u);
    ASSERT_TRUE(read("numbers", Json::array({4})));
    EXPECT_EQ(sample.numbers.items[1], 0.0f) << "unused items have no value";
    EXPECT_EQ(sample.numbers.size(), 1u);
    ASSERT_TRUE(read("numbers", Json::array({1, 2, 3, 4})));
    EXPECT_EQ(context.warnings.at(0).what, "4 items, the limit is 3");
    sample.numbers.count = 1000;
    EXPECT_EQ(write("numbers").size(), 3u) << "a wrong count";
    EXPECT_FALSE(read("numbers", 1));
    EXPECT_EQ(write("flag"), false);
    ASSERT_TRUE(read("flag", true));
    EXPECT_EQ(write("flag"), true);
}

TEST_F(FieldJson, foundValuesAreShownShortly) {
    EXPECT_EQ(foundText(nullptr), "null");
    EXPECT_EQ(foundText(true), "true");
    EXPECT_EQ(foundText(false), "false");
    EXPECT_EQ(foundText(-3), "-3");
    EXPECT_EQ(foundText(~std::uint64_t{0}), "18446744073709551615");
    EXPECT_EQ(foundText(1.5), "1.5");
    EXPECT_EQ(foundText(Json::array({1, 2})), "a list of 2");
    EXPECT_EQ(foundText(Json::object()), "an object");
    EXPECT_EQ(foundText(Json::binary({1})), "raw bytes");
    EXPECT_EQ(foundText(std::string(40, 'a')), "\"" + std::string(40, 'a') + "\"");
    EXPECT_EQ(foundText(std::string(41, 'a')), "\"" + std::string(40, 'a') + "...\"");
    // No character is cut: e with an accent has two bytes, the euro sign three.
    EXPECT_EQ(foundText(std::string(39, 'a') + "\xc3\xa9"
                                               "b"),
              "\"" + std::string(39, 'a') + "...\"");
    EXPECT_EQ(foundText(std::string(38, 'a') + "\xe2\x82\xac"
                                               "b"),
              "\"" + std::string(38, 'a') + "...\"");
    EXPECT_EQ(foundText(std::string(38, 'a') + "\xc3\xa9"
                                               "b"),
              "\"" + std::string(38, 'a') + "\xc3\xa9...\"");
}

TEST_F(FieldJson, everyFieldKindRejectsWrongValuesWithoutChanging) {
    const Json values[] = {nullptr,
                           true,
                           -1,
                           1.5,
                           1e300,
                           "text",
                           "#ffffff",
                           Json::array(),
                           Json::object(),
                           "0000001",
                           Json::array({1, 2})};
    for (const FieldInfo& field : type.fields) {
        for (const Json& value : values) {
            SCOPED_TRACE(std::string{field.name} + " " + value.dump());
            const Sample before = sample;
            const auto result = fieldFromJson(field, &sample, value, context);
            if (result) continue;
            EXPECT_TRUE(componentsEqual(type, &before, &sample));
            EXPECT_FALSE(result.error().what.empty());
            EXPECT_FALSE(result.error().remedy.empty());
        }
    }
}

TEST_F(FieldJson, propertyWrittenValuesReadBackBitIdentical) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        Sample made;
        made.flag = random.below(2) == 1;
        made.count = static_cast<int>(random.below(21)) - 10;
        made.large = random.next64();
        made.rate = random.between(-20.0f, 20.0f);
        made.place = {random.between(-1e6f, 1e6f), random.unit()};
        made.part = {random.unit(), -0.0f, random.unit(), 1e-30f};
        made.tint = {static_cast<std::uint8_t>(random.next()), 2, 3, 4};
        made.title = context.texts.add("title " + hexText(random.next64()));
        made.mood = Mood::Angry;
        made.numbers.push(random.unit());

        const Sample defaults;
        Sample read;
        std::vector<FieldProblem> problems;
        componentFromJson(type, &read, componentToJson(type, &made, &defaults, context), context, problems);

        EXPECT_TRUE(problems.empty());
        EXPECT_TRUE(componentsEqual(type, &made, &read));
    }
}

}  // namespace
}  // namespace plumb
