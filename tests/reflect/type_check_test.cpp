#include "reflect/type_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "reflect/type_builder.hpp"

// Mistakes in descriptions of components.

namespace plumb {
namespace {

enum class Mood : std::uint8_t { Calm, Angry };
struct Beast {
    float speed = 40.0f;
    float height = 2.0f;
    std::int8_t lives = -3;
    std::uint64_t seed = ~std::uint64_t{0};
    Mood mood = Mood::Calm;
    bool flies = false;
    float farthest = std::numeric_limits<float>::infinity();
};

using Builder = TypeBuilder<Beast>;

/// The mistakes of a description of Beast.
std::vector<std::string> mistakes(void (*describe)(Builder& type)) {
    TypeInfo info;
    Builder builder{info};
    builder.name("Beast");
    describe(builder);
    std::vector<std::string> texts;
    for (const Error& mistake : mistakesOf(info)) texts.push_back(mistake.text());
    return texts;
}

using Texts = std::vector<std::string>;

TEST(TypeCheck, acceptsADescriptionWithoutMistakes) {
    EXPECT_EQ(mistakes([](Builder& type) {
                  type.field<&Beast::farthest>("farthest");  // infinite, without a range
                  type.field<&Beast::speed>("speed").range(0.0f, 100.0f).was("pace").shownIf("flies");
                  type.field<&Beast::height>("height").range(2.0f, 2.0f);
                  type.field<&Beast::lives>("lives").range(-3.0f, 9.0f);
                  type.field<&Beast::seed>("seed").range(0.0f, 2e19f);
                  type.field<&Beast::mood>("mood").names({{"calm", 0}, {"angry", 1}});
                  type.field<&Beast::flies>("flies");
              }),
              Texts{});
}

TEST(TypeCheck, namesAreThereAndUnique) {
    EXPECT_EQ(mistakes([](Builder& type) { type.name("").field<&Beast::flies>("flies"); }),
              Texts{R"(component "Beast": the description has no name; begin it with type.name("..."))"});
    EXPECT_EQ(mistakes([](Builder& type) { type.field<&Beast::speed>(""); }),
              Texts{R"(component "Beast", field "at byte 0": it has no name; write field<&...>("name"))"});
    EXPECT_EQ(mistakes([](Builder& type) {
                  type.field<&Beast::speed>("speed");
                  type.field<&Beast::height>("speed");
              }),
              Texts{R"(component "Beast", field "speed": there are two fields of this name; )"
                    "give one of them another name"});
}

TEST(TypeCheck, aMemberIsDescribedOnce) {
    EXPECT_EQ(mistakes([](Builder& type) {
                  type.field<&Beast::speed>("speed");
                  type.field<&Beast::speed>("height");
              }),
              Texts{R"(component "Beast", field "height": its member is that of the field "speed" already; )"
                    "name another member in field<&...>, or remove one of the two fields"});
}

TEST(TypeCheck, formerNamesAreNotThoseOfOtherFields) {
    EXPECT_EQ(mistakes([](Builder& type) {
                  type.field<&Beast::speed>("speed").was("height");
                  type.field<&Beast::height>("height");
              }),
              Texts{R"(component "Beast", field "speed": its former name "height" is the present name of a )"
                    "field; remove .was(...), or rename the other field"});
    EXPECT_EQ(mistakes([](Builder& type) {
                  type.field<&Beast::speed>("speed").was("size");
                  type.field<&Beast::height>("height").was("size");
              }),
              Texts{R"(component "Beast", field "height": its former name "size" is also that of "speed"; )"
                    "remove one of the two .was(...)"});
}

TEST(TypeCheck, defaultsAreInsideOfRanges) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(mistakes([](Builder& type) { type.field<&Beast::speed>("speed").range(10.0f, 5.0f); }),
              Texts{R"(component "Beast", field "speed": its range is from 10 to 5; )"
                    "write the smaller number first"});
    EXPECT_EQ(mistakes([](Builder& type) { type.field<&Beast::speed>("speed").range(kNan, 5.0f); }).size(),
              1u);
    EXPECT_EQ(
        mistakes([](Builder& type) { type.field<&Beast::speed>("speed").range(0.0f, 5.0f); }),
        Texts{R"(component "Beast", field "speed": its default 40 is outside of its range from 0 to 5; )"
              "change the initial value of the member, or the range"});
    EXPECT_EQ(mistakes([](Builder& type) { type.field<&Beast::lives>("lives").range(0.0f, 5.0f); }).size(),
              1u);
    EXPECT_EQ(mistakes([](Builder& type) { type.field<&Beast::seed>("seed").range(-2.0f, 5.0f); }).size(),
              1u);
}

/// The number of mistakes of a type with an Int field of some bytes, whose default is `value`.
std::size_t mistakesOfInt(std::size_t size, bool isSigned, std::uint64_t value, float min, float max) {
    TypeInfo type;
    type.name = "Made";
    FieldInfo field;
    field.name = "n";
    field.kind = FieldKind::Int;
    field.size = size;
    field.isSigned = isSigned;
    field.offset = 3;
    field.min = min, field.max = max;
    type.fields.push_back(field);
    type.defaults.resize(3 + size, std::byte{0xff});
    std::memcpy(type.defaults.data() + 3, &value, size);
    return mistakesOf(type).size();
}

TEST(TypeCheck, defaultsOfAllKindsOfIntegersAreComparedByTheirValues) {
    for (const std::size_t size : {1u, 2u, 4u, 8u}) {
        const std::uint64_t top = std::uint64_t{1} << (8 * size - 1);
        for (const bool isSigned : {true, false}) {
            for (const std::uint64_t bits :
                 {std::uint64_t{0}, std::uint64_t{1}, top - 1, top, top + 1, 2 * top - 1}) {
                const bool isNegative = isSigned && bits >= top;
                const long double exact = bits;  // with 64 bits of mantissa
                const auto value =
                    static_cast<double>(isNegative ? exact - 2.0L * static_cast<long double>(top) : exact);
                const auto near = static_cast<float>(value);
                const float step = std::max(1.0f, std::abs(near) * 1e-6f);
                SCOPED_TRACE(std::to_string(size) + (isSigned ? " signed " : " unsigned ") +
                             std::to_string(value));
                EXPECT_EQ(mistakesOfInt(size, isSigned, bits, near - step, near + step), 0u);
                EXPECT_EQ(mistakesOfInt(size, isSigned, bits, near + step, near + 2 * step), 1u);
                EXPECT_EQ(mistakesOfInt(size, isSigned, bits, near - 2 * step, near - step), 1u);
            }
        }
    }
    EXPECT_EQ(mistakesOfInt(2, true, 5, 5.0f, 5.0f), 0u) << "both limits belong to the range";
}

TEST(TypeCheck, aRangeWithOneLimitIsChecked) {
    constexpr float kLow = std::numeric_limits<float>::lowest(), kHigh = std::numeric_limits<float>::max();
    EXPECT_EQ(mistakesOfInt(4, true, 5, kLow, 4.0f), 1u);
    EXPECT_EQ(mistakesOfInt(4, true, 5, 6.0f, kHigh), 1u);
    EXPECT_EQ(mistakesOfInt(4, true, 5, kLow, 5.0f), 0u);
    EXPECT_EQ(mistakesOfInt(4, true, 5, 5.0f, kHigh), 0u);
    EXPECT_EQ(mistakesOfInt(4, true, 5, kLow, kHigh), 0u);
}

TEST(TypeCheck, typesWithoutDefaultsHaveNoneToCheck) {
    TypeInfo type;
    type.name = "Made";
    FieldInfo field;
    field.name = "n";
    field.size = 4;
    field.min = field.max = 5.0f;
    type.fields.push_back(field);
    EXPECT_TRUE(mistakesOf(type).empty());
    type.defaults.resize(4);
    EXPECT_EQ(mistakesOf(type).size(), 1u);
    type.fields[0].kind = FieldKind::Bool;
    EXPECT_TRUE(mistakesOf(type).empty()) << "a bool has no range";
}

TEST(TypeCheck, fieldsWithoutFormerNamesHaveNoneInCommon) {
    EXPECT_EQ(mistakes([](Builder& type) {
                  type.field<&Beast::speed>("speed");
                  type.field<&Beast::height>("height").was("size");
                  type.field<&Beast::flies>("flies");
              }),
              Texts{});
}

TEST(TypeCheck, otherFieldsAndEnumsAreComplete) {
    EXPECT_EQ(mistakes([](Builder& type) { type.field<&Beast::speed>("speed").shownIf("swims"); }),
              Texts{R"(component "Beast", field "speed": shownIf names "swims", which is no field; )"
                    "name a bool or an enum of this component"});
    EXPECT_EQ(mistakes([](Builder& type) { type.field<&Beast::mood>("mood"); }).size(), 1u);
}

}  // namespace
}  // namespace plumb
