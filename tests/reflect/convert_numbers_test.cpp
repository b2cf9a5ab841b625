#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "reflect/convert_component.hpp"

// Conversions between numbers of all kinds, compared with exact arithmetic.

namespace plumb {
namespace {

/// A kind of number in memory, for all pairs of kinds.
struct NumberKind {
    FieldKind kind;
    std::size_t size;
    bool isSigned;

    [[nodiscard]] bool isSignedInMemory() const {
        return kind == FieldKind::Int ? isSigned : kind == FieldKind::Enum && size != 1;
    }
};
constexpr NumberKind kNumberKinds[] = {
    {FieldKind::Bool, 1, false}, {FieldKind::Float, 4, true}, {FieldKind::Enum, 1, true},
    {FieldKind::Enum, 4, true},  {FieldKind::Int, 1, true},   {FieldKind::Int, 2, true},
    {FieldKind::Int, 4, true},   {FieldKind::Int, 8, true},   {FieldKind::Int, 1, false},
    {FieldKind::Int, 2, false},  {FieldKind::Int, 4, false},  {FieldKind::Int, 8, false}};

using Exact = long double;  // 64 bits of mantissa: exact for floats and for integers of 8 bytes

TypeInfo typeOf(const NumberKind& kind) {
    FieldInfo field;
    field.name = "value";
    field.kind = kind.kind;
    field.size = kind.size;
    field.isSigned = kind.isSigned;
    if (kind.kind == FieldKind::Enum) field.names = {{"a", 0}, {"b", 1}, {"c", 7}, {"d", 100}};
    TypeInfo type;
    type.fields.push_back(field);
    type.size = 8;
    return type;  // without defaults, as types of scripts: every value is converted
}

Exact load(const NumberKind& kind, std::uint64_t bits) {
    if (kind.kind == FieldKind::Float) return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    const Exact top = std::ldexp(Exact{1}, static_cast<int>(8 * kind.size));
    const auto value = static_cast<Exact>(bits);
    return kind.isSignedInMemory() && value >= top / 2 ? value - top : value;
}

Exact limited(Exact value, Exact low, Exact high) { return std::min(std::max(value, low), high); }

/// The number that a field has after the conversion of `value`, by the rules of convertComponent().
Exact expectedNumber(Exact value, const NumberKind& kind, const FieldInfo& field, Exact preset) {
    switch (kind.kind) {
        case FieldKind::Bool: return value != 0 ? 1 : 0;
        case FieldKind::Float: {
            auto narrow = static_cast<float>(value);
            if (field.min != std::numeric_limits<float>::lowest()) narrow = std::max(narrow, field.min);
            if (field.max != std::numeric_limits<float>::max()) narrow = std::min(narrow, field.max);
            return narrow;
        }
        case FieldKind::Enum: return value == 0 || value == 1 || value == 7 || value == 100 ? value : preset;
        default: break;
    }
    const Exact top = std::ldexp(Exact{1}, static_cast<int>(8 * kind.size));
    const Exact low = kind.isSigned ? -top / 2 : 0, high = kind.isSigned ? top / 2 - 1 : top - 1;
    const Exact whole = limited(std::round(value), low, high);
    return limited(limited(whole, std::ceil(Exact{field.min}), std::floor(Exact{field.max})), low, high);
}

TEST(ConvertComponentProperty, numbersOfAllKindsAreRoundedAndLimited) {
    constexpr float kReals[] = {0.0f, -0.5f, 0.25f,         0.5f,           1.0f,          1.5f,   -1.5f,
                                2.5f, 6.5f,  7.0f,          -3.5f,          100.0f,        127.5f, 255.4f,
                                3e9f, -3e9f, 9.2233720e18f, -9.2233720e18f, 1.8446744e19f, 1e30f,  -1e30f};
    std::vector<std::uint64_t> patterns{0, 1, 2, 3, 6, 7, 8, 100, ~0ull, ~0ull - 1};
    for (const int bit : {7, 8, 15, 16, 31, 32, 53, 63}) {
        for (const int by : {-1, 0, 1}) patterns.push_back((1ull << bit) + static_cast<std::uint64_t>(by));
    }
    const std::pair<float, float> ranges[] = {
        {std::numeric_limits<float>::lowest(), std::numeric_limits<float>::max()},
        {-2.5f, 6.5f},
        {3.0f, 3.0f},
        {300.0f, 1e30f},
        {-1e30f, -300.0f},
        {-3e19f, 3e19f}};
    for (const NumberKind& before : kNumberKinds) {
        for (const NumberKind& now : kNumberKinds) {
            if (before.kind == FieldKind::Enum && now.kind == FieldKind::Enum) continue;  // by name
            for (const auto& [min, max] : ranges) {
                const TypeInfo from = typeOf(before);
                TypeInfo to = typeOf(now);
                to.fields[0].min = min, to.fields[0].max = max;
                const bool isSame = before.kind == now.kind && before.size == now.size &&
                                    before.isSigned == now.isSigned &&
                                    min == std::numeric_limits<float>::lowest();
                std::vector<std::uint64_t> values;
                if (before.kind == FieldKind::Float) {
                    for (const float real : kReals) values.push_back(std::bit_cast<std::uint32_t>(real));
                } else {
                    for (const std::uint64_t bits : patterns)
                        values.push_back(before.kind == FieldKind::Bool ? bits & 1
                                         : before.size == 8             ? bits
                                                            : bits & ((1ull << (8 * before.size)) - 1));
                }
                for (const std::uint64_t bits : values) {
                    const std::uint64_t preset = now.kind == FieldKind::Bool ? 1 : 7;
                    std::uint64_t result = preset;
                    convertComponent(from, &bits, to, &result);
                    const Exact value = load(before, bits);
                    const Exact expected =
                        isSame ? value : expectedNumber(value, now, to.fields[0], load(now, preset));
                    ASSERT_EQ(load(now, result), expected)
                        << static_cast<int>(before.kind) << ", " << before.size << " bytes, "
                        << before.isSigned << " to " << static_cast<int>(now.kind) << ", " << now.size
                        << " bytes, " << now.isSigned << " in " << min << " to " << max << ": " << value;
                }
            }
        }
    }
}

TEST(ConvertComponent, convertsEnumsOfAllSizesByName) {
    for (const std::size_t before : {1u, 4u}) {
        for (const std::size_t now : {1u, 4u}) {
            TypeInfo from = typeOf({FieldKind::Enum, before, true}),
                     to = typeOf({FieldKind::Enum, now, true});
            from.fields[0].names = {{"a", 3}, {"b", 200}, {"gone", 5}};
            to.fields[0].names = {{"b", 4}, {"a", 250}, {"new", 5}};
            for (const auto& [value, expected] : {std::pair{3, 250}, {200, 4}, {5, 5}, {77, 5}}) {
                std::int32_t result = 5;  // the preset: of no known name, or of none at all
                convertComponent(from, &value, to, &result);
                EXPECT_EQ(result, expected) << value << ": " << before << " to " << now << " bytes";
            }
        }
    }
}

}  // namespace
}  // namespace plumb
