#include "reflect/component_json.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "reflect/field_json.hpp"
#include "reflect/json.hpp"
#include "reflect/type_registry.hpp"
#include "tests/support/plain_context.hpp"

namespace plumb {
namespace {

struct Kept {
    int shown = 1;
    int hidden = 2;
    TilesId tiles;
    float rate = 1.0f;
    Vec2 place;

    static void describe(TypeBuilder<Kept>& type) {
        type.name("Kept");
        type.field<&Kept::shown>("shown");
        type.field<&Kept::hidden>("hidden").was("secret").transient();
        type.field<&Kept::tiles>("tiles");
        type.field<&Kept::rate>("rate");
        type.field<&Kept::place>("place");
    }
};

struct ComponentJson : testing::Test {
    TypeRegistry types;
    const TypeInfo& kept = types.add<Kept>();
    test::PlainContext context;
};

TEST_F(ComponentJson, neitherTransientFieldsNorEmptyNamesAreRead) {
    Kept object;
    std::vector<FieldProblem> problems;
    componentFromJson(kept, &object, {{"secret", 7}, {"hidden", 7}, {"", 7}, {"shown", 3}}, context,
                      problems);
    EXPECT_EQ(object.shown, 3);
    EXPECT_EQ(object.hidden, 2);
    ASSERT_EQ(problems.size(), 3u);
    EXPECT_EQ(problems[0].error.text(),
              "Kept.secret: Kept has no such field; it is kept unchanged; the fields are: shown, tiles, "
              "rate, place");
    EXPECT_EQ(problems[1].key, "hidden");
    EXPECT_EQ(problems[2].key, "");
    problems.clear();
    componentFromJson(kept, &object, Json("text"), context, problems);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].error.text(),
              "Kept: expected an object, found \"text\"; write {} for the defaults");
    TypeInfo tag;
    tag.name = "Tag";
    problems.clear();
    componentFromJson(tag, nullptr, {{"speed", 1}}, context, problems);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].error.remedy, "it is kept unchanged; this component has no fields");
}

TEST_F(ComponentJson, aWrongFieldIsReportedAndTheOthersAreRead) {
    Kept object;
    std::vector<FieldProblem> problems;
    componentFromJson(kept, &object, {{"shown", "x"}, {"place", {1, "y"}}, {"rate", 2.0}}, context, problems);
    EXPECT_EQ(object.rate, 2.0f);
    EXPECT_EQ(object.shown, 1);
    ASSERT_EQ(problems.size(), 2u);
    EXPECT_EQ(problems[0].key, "shown");
    EXPECT_EQ(problems[0].error.where, "Kept.shown");
    EXPECT_EQ(problems[1].error.where, "Kept.place[1]");
}

/// Tiles are equal if their numbers have the same remainder by ten.
struct TilesContext final : FieldContext {
    [[nodiscard]] std::string_view text(TextId) const override { return {}; }
    TextId keepText(std::string_view) override { return {}; }
    [[nodiscard]] std::uint64_t stableId(EntityId) const override { return 0; }
    [[nodiscard]] EntityId entity(std::uint64_t) const override { return {}; }
    [[nodiscard]] Json tilesToJson(TilesId tiles) const override { return tiles.value; }
    Result<TilesId> tilesFromJson(const FieldInfo&, const Json& json) override {
        if (!json.is_number()) return Error{"tiles", "wrong", "correct it"};
        return TilesId{json.get<std::uint32_t>()};
    }
    [[nodiscard]] bool sameTiles(TilesId a, TilesId b) const override { return a.value % 10 == b.value % 10; }
    void warn(Error) override {}
};

TEST_F(ComponentJson, tilesAreWrittenIfTheirCellsDifferFromTheDefault) {
    TilesContext tiles;
    Kept object, defaults;
    object.tiles = {10};
    EXPECT_EQ(componentToJson(kept, &object, &defaults, tiles).dump(), "{}");
    object.tiles = {11};
    EXPECT_EQ(componentToJson(kept, &object, &defaults, tiles).dump(), R"({"tiles":11})");
    EXPECT_TRUE(fieldFromJson(*kept.find("tiles"), &object, 12, tiles));
    EXPECT_EQ(object.tiles, TilesId{12});
    EXPECT_FALSE(fieldFromJson(*kept.find("tiles"), &object, "x", tiles));
    EXPECT_EQ(object.tiles, TilesId{12});
}

}  // namespace
}  // namespace plumb
