#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/text.hpp"
#include "reflect/field_json.hpp"
#include "reflect/json.hpp"
#include "tests/support/plain_context.hpp"

// Whole numbers of all sizes in files.

namespace plumb {
namespace {

/// An Int field of a value at any address.
FieldInfo intField(std::size_t size, bool isSigned) {
    FieldInfo field;
    field.name = "n";
    field.kind = FieldKind::Int;
    field.size = size;
    field.isSigned = isSigned;
    return field;
}

struct FieldNumbers : testing::Test {
    test::PlainContext context;
    std::uint64_t stored = 0;

    Result<Done> read(const FieldInfo& field, const Json& json) {
        return valueFromJson(field, &stored, json, context);
    }
};

TEST_F(FieldNumbers, wholeNumbersAreLimitedToTheBytesAndTheRangeOfTheirField) {
    constexpr std::int64_t kEdges[] = {std::numeric_limits<std::int64_t>::min(),
                                       -(1ll << 31) - 1,
                                       -(1ll << 31),
                                       -32769,
                                       -32768,
                                       -129,
                                       -128,
                                       -8,
                                       -7,
                                       -1,
                                       0,
                                       1,
                                       6,
                                       7,
                                       127,
                                       128,
                                       255,
                                       256,
                                       32767,
                                       32768,
                                       65535,
                                       65536,
                                       (1ll << 31) - 1,
                                       1ll << 31,
                                       (1ll << 32) - 1,
                                       1ll << 32,
                                       1ll << 53,
                                       std::numeric_limits<std::int64_t>::max()};
    for (const std::size_t size : {1u, 2u, 4u, 8u}) {
        for (const bool isSigned : {true, false}) {
            if (size == 8 && !isSigned) continue;  // see below
            for (const bool isLimited : {false, true}) {
                FieldInfo field = intField(size, isSigned);
                if (isLimited) field.min = -7.5f, field.max = 6.5f;
                const std::int64_t half =
                    size == 8 ? std::numeric_limits<std::int64_t>::max() : (1ll << (8 * size - 1)) - 1;
                std::int64_t low = isSigned ? -half - 1 : 0, high = isSigned ? half : 2 * half + 1;
                if (isLimited) low = std::max<std::int64_t>(low, -7), high = std::min<std::int64_t>(high, 6);
                for (const std::int64_t number : kEdges) {
                    SCOPED_TRACE(format("{} bytes, {}, {}: {}", size, isSigned, isLimited, number));
                    const std::int64_t expected = std::clamp(number, low, high);
                    std::vector<Json> forms{Json(number)};
                    if (number >= 0) forms.emplace_back(static_cast<std::uint64_t>(number));
                    if (std::abs(number / 2) <= (1ll << 52)) forms.emplace_back(static_cast<double>(number));
                    for (const Json& form : forms) {
                        std::int64_t value = 0;
                        context.warnings.clear();
                        ASSERT_TRUE(valueFromJson(field, &value, form, context));
                        ASSERT_EQ(valueToJson(field, &value, context), Json(expected));
                        ASSERT_EQ(context.warnings.size(), expected == number ? 0u : 1u);
                    }
                }
            }
        }
    }
}

TEST_F(FieldNumbers, numbersThatAreNotWholeOrNotExactAreRejected) {
    for (const double wrong : {0.5, -1.5, 9007199254740994.0, -9007199254740994.0, 1e300})
        EXPECT_FALSE(read(intField(4, true), wrong)) << wrong;
    FieldInfo wide = intField(8, true);
    std::int64_t value = 0;
    EXPECT_TRUE(valueFromJson(wide, &value, -9007199254740992.0, context));
    EXPECT_EQ(value, -(1ll << 53));
}

TEST_F(FieldNumbers, unsignedNumbersOfEightBytesAreReadWhole) {
    const FieldInfo large = intField(8, false);
    for (const std::uint64_t number :
         {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}, std::uint64_t{1} << 63}) {
        ASSERT_TRUE(read(large, number));
        EXPECT_EQ(stored, number);
    }
    ASSERT_TRUE(read(large, std::int64_t{0}));
    EXPECT_EQ(stored, 0u);
    ASSERT_TRUE(read(large, 5.0));
    EXPECT_EQ(stored, 5u);
    const auto negative = read(large, -1);
    ASSERT_FALSE(negative);
    EXPECT_EQ(negative.error().text(),
              "n: expected a number that is not negative, found -1; write 0 or more");
    FieldInfo signedField = intField(8, true);
    std::int64_t value = 0;
    ASSERT_TRUE(valueFromJson(signedField, &value, ~std::uint64_t{0}, context));
    EXPECT_EQ(value, std::numeric_limits<std::int64_t>::max()) << "limited";
}

}  // namespace
}  // namespace plumb
