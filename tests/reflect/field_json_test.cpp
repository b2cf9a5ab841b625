#include "reflect/field_json.hpp"

#include <limits>
#include <map>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "core/text.hpp"
#include "math/color.hpp"
#include "reflect/compare.hpp"
#include "reflect/component_json.hpp"
#include "reflect/field_context.hpp"
#include "reflect/json.hpp"
#include "reflect/type_registry.hpp"

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

class SampleContext final : public FieldContext {
public:
    TextStore texts;
    std::map<std::uint64_t, EntityId> entities{{0xab, {7, 1}}};
    std::vector<Error> warnings;

    [[nodiscard]] std::string_view text(TextId id) const override { return texts.find(id); }
    TextId keepText(std::string_view text) override { return texts.add(text); }
    [[nodiscard]] std::uint64_t stableId(EntityId entity) const override {
        for (const auto& [id, known] : entities) {
            if (known == entity) return id;
        }
        return 0;
    }
    [[nodiscard]] EntityId entity(std::uint64_t id) const override {
        const auto found = entities.find(id);
        return found == entities.end() ? EntityId{} : found->second;
    }
    [[nodiscard]] Json tilesToJson(TilesId tiles) const override { return tiles.value; }
    Result<TilesId> tilesFromJson(const FieldInfo&, const Json& json) override {
        return TilesId{json.get<std::uint32_t>()};
    }
    void warn(Error error) override { warnings.push_back(std::move(error)); }
};

struct FieldJson : testing::Test {
    TypeRegistry types;
    const TypeInfo& type = types.add<Sample>();
    SampleContext context;
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
