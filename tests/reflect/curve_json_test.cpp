#include "reflect/curve_json.hpp"

#include <gtest/gtest.h>

#include "reflect/compare.hpp"
#include "reflect/curve_field.hpp"
#include "reflect/field_context.hpp"
#include "reflect/field_json.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "reflect/type_registry.hpp"

namespace plumb {
namespace {

struct Fade {
    Curve curve;
    FixedList<Vec2, Curve::kKeys> corners;

    static void describe(TypeBuilder<Fade>& type) {
        type.name("Fade");
        type.field<&Fade::curve>("curve").range(0.0f, 2.0f);
        type.field<&Fade::corners>("corners");
    }
};

struct Warnings final : FieldContext {
    std::vector<Error> warnings;

    [[nodiscard]] std::uint64_t stableId(EntityId) const override { return 0; }
    [[nodiscard]] std::string_view text(TextId) const override { return {}; }
    [[nodiscard]] Json tilesToJson(TilesId) const override { return {}; }
    [[nodiscard]] EntityId entity(std::uint64_t) const override { return {}; }
    TextId keepText(std::string_view) override { return {}; }
    Result<TilesId> tilesFromJson(const FieldInfo&, const Json&) override { return TilesId{}; }
    void warn(Error error) override { warnings.push_back(std::move(error)); }
};

struct CurveJson : testing::Test {
    TypeRegistry types;
    Warnings context;
    Fade fade;

    CurveJson() { types.add<Fade>(); }
    const FieldInfo& field() { return *types.of<Fade>().find("curve"); }
    Result<Done> read(std::string_view text) {
        return fieldFromJson(field(), &fade, *parseJson(text, "test"), context);
    }
    std::string written() {
        std::string text;
        appendJson(text, fieldToJson(field(), &fade, context), 0);
        return text;
    }
    std::string problem(std::string_view text) {
        const Fade before = fade;
        const Result<Done> done = read(text);
        EXPECT_FALSE(done.ok()) << text;
        EXPECT_EQ(fade.curve, before.curve) << "it keeps what it was";
        return done.ok() ? std::string{} : done.error().text();
    }
};

TEST_F(CurveJson, aCurveIsWrittenOnOneLineAndReadsBackBitIdentical) {
    constexpr std::string_view kText = R"(["linear", [0, 0.1], [0.33333334, 1e-07], [1, 2]])";
    ASSERT_TRUE(read(kText).ok());
    EXPECT_EQ(fade.curve.shape, CurveShape::Linear);
    EXPECT_EQ(fade.curve.size(), 3u);
    EXPECT_EQ(fade.curve.keys[1], (CurveKey{0.33333334f, 1e-07f}));
    EXPECT_EQ(written(), kText);
    EXPECT_TRUE(context.warnings.empty());
}

TEST_F(CurveJson, isDistinguishedFromListsOfPairs) {
    EXPECT_TRUE(isCurve(field()));
    EXPECT_FALSE(isCurve(*types.of<Fade>().find("corners"))) << "as many pairs, and no curve";
    Fade other;
    other.curve.shape = CurveShape::Linear;
    EXPECT_FALSE(fieldsEqual(field(), &fade, &other)) << "the shape is part of it";
}

TEST_F(CurveJson, invalidKeysAreReportedWithTheirIndex) {
    EXPECT_NE(problem("3").find("expected a curve, found 3"), std::string::npos);
    EXPECT_NE(problem(R"(["round", [0, 1]])").find(R"("smooth" or "linear", found "round")"),
              std::string::npos);
    EXPECT_NE(problem(R"(["smooth"])").find("at least one key"), std::string::npos);
    EXPECT_NE(problem(R"(["smooth", [0, 1], [0.5]])").find("key 1 is not a pair"), std::string::npos);
    EXPECT_NE(problem(R"(["smooth", [0, 1], [1.5, 1]])").find("key 1 is at 1.5, outside 0 to 1"),
              std::string::npos);
    EXPECT_NE(problem(R"(["smooth", [0.5, 1], [0.2, 1]])").find("key 1 is at 0.2, which is not after"),
              std::string::npos);
    EXPECT_NE(problem(R"(["smooth", [0.5, 1], [0.5, 1]])").find("not after"), std::string::npos);
    EXPECT_NE(problem(R"(["smooth",[0,0],[0.1,0],[0.2,0],[0.3,0],[0.4,0],[0.5,0],[0.6,0],[0.7,0],[0.8,0]])")
                  .find("9 keys, the limit is 8"),
              std::string::npos);
}

TEST_F(CurveJson, aValueOutsideItsRangeIsClampedAndReported) {
    ASSERT_TRUE(read(R"(["smooth", [0, -1], [1, 7]])").ok());
    EXPECT_EQ(fade.curve, Curve::line(0.0f, 2.0f));
    ASSERT_EQ(context.warnings.size(), 2u);
    EXPECT_NE(context.warnings[1].text().find("key 1 has the value 7, outside 0 to 2"), std::string::npos);
}

TEST_F(CurveJson, positionsKeysAndValuesAreAcceptedAtTheirLimits) {
    ASSERT_TRUE(read(R"(["smooth", [0, 0], [1, 2]])").ok());
    ASSERT_TRUE(read(R"(["smooth",[0,0],[0.1,0],[0.2,0],[0.3,0],[0.4,0],[0.5,0],[0.6,0],[1,2]])").ok());
    EXPECT_EQ(fade.curve.size(), Curve::kKeys);
    ASSERT_TRUE(read(R"(["linear", [0.5, 1]])").ok());
    EXPECT_EQ(fade.curve.size(), 1u);
    EXPECT_EQ(fade.curve.keys[1], CurveKey{}) << "unused keys are empty";
    EXPECT_TRUE(context.warnings.empty());
    ASSERT_TRUE(read(R"(["smooth", [0, 3.4028234663852886e38]])").ok()) << "the largest float";
    ASSERT_TRUE(read(R"(["smooth", [0, -3.4028234663852886e38]])").ok());
    EXPECT_EQ(context.warnings.size(), 2u);
    for (const char* key : {"[0, 3.41e38]", "[0, -3.41e38]", "[1e39, 0]", "[0, 1, 2]", "[]", "[\"a\", 1]",
                            "[0, \"b\"]", "5", "{}"})
        EXPECT_NE(problem(std::string{R"(["smooth", )"} + key + "]").find("key 0 is not a pair"),
                  std::string::npos)
            << key;
    EXPECT_NE(problem(R"(["smooth", [-0.001, 1]])").find("key 0 is at -0.001, outside 0 to 1"),
              std::string::npos);
    EXPECT_NE(problem(R"(["smooth", [1.001, 1]])").find("key 0 is at 1.001, outside 0 to 1"),
              std::string::npos);
    EXPECT_NE(problem("[]").find("expected a curve, found a list of 0"), std::string::npos);
    EXPECT_NE(problem("[3]").find(R"("smooth" or "linear", found 3)"), std::string::npos);
    EXPECT_NE(problem("[[0, 1]]").find("found a list of 2"), std::string::npos);
}

}  // namespace
}  // namespace plumb
