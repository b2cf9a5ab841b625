#include "reflect/convert_component.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/fixed_list.hpp"
#include "math/curve.hpp"
#include "math/vec2.hpp"
#include "reflect/curve_field.hpp"
#include "reflect/type_registry.hpp"
#include "tests/support/random_type.hpp"

namespace plumb {
namespace {

enum class Mood : std::uint8_t { Calm, Angry, Asleep };

struct Before {
    float speed = 1.0f;
    int lives = 1;
    bool open = false;
    Mood mood = Mood::Calm;
    Vec2 home;
    FixedList<float, 4> times{};
    int big = 10;
    float gone = 1.0f;

    static void describe(TypeBuilder<Before>& type) {
        type.name("Door");
        type.field<&Before::speed>("speed");
        type.field<&Before::lives>("lives");
        type.field<&Before::open>("open");
        type.field<&Before::mood>("mood").names({{"calm", 0}, {"angry", 1}, {"asleep", 2}});
        type.field<&Before::home>("home");
        type.field<&Before::times>("times");
        type.field<&Before::big>("big");
        type.field<&Before::gone>("gone");
    }
};

struct Now {
    Vec2 base{9.0f, 9.0f};
    int speed = 0;
    float lives = 0.0f;
    int open = 7;
    Mood mood = Mood::Calm;
    FixedList<float, 2> times{};
    std::int8_t big = 1;
    float limited = 0.0f;
    float added = 4.0f;
    int home = 5;  // was a Vec2

    static void describe(TypeBuilder<Now>& type) {
        type.name("Door");
        type.field<&Now::base>("base").was("home");
        type.field<&Now::speed>("speed");
        type.field<&Now::lives>("lives");
        type.field<&Now::open>("open");
        type.field<&Now::mood>("mood").names({{"asleep", 0}, {"calm", 1}, {"angry", 2}});
        type.field<&Now::times>("times");
        type.field<&Now::big>("big");
        type.field<&Now::limited>("limited").was("lives").range(0.0f, 2.0f);
        type.field<&Now::added>("added");
        type.field<&Now::home>("home");
    }
};

/// A component whose fields all have other values than by default.
Before changed() {
    Before before;
    before.speed = 2.6f;
    before.lives = 3;
    before.open = true;
    before.mood = Mood::Angry;
    before.home = {1.0f, 2.0f};
    before.big = 100000;
    return before;
}

template <class T>
TypeInfo describe() {
    TypeRegistry types;
    return types.add<T>();
}

Now converted(const Before& before) {
    Now now;
    convertComponent(describe<Before>(), &before, describe<Now>(), &now);
    return now;
}

TEST(ConvertComponent, movesFieldsByNameAndByFormerName) {
    const Now now = converted(changed());
    EXPECT_EQ(now.base, (Vec2{1.0f, 2.0f}));
    EXPECT_EQ(now.mood, Mood::Asleep) << "angry is the third name now";
}

TEST(ConvertComponent, convertsNumbersAndLimitsThem) {
    const Now now = converted(changed());
    EXPECT_EQ(now.speed, 3);
    EXPECT_EQ(now.lives, 3.0f);
    EXPECT_EQ(now.open, 1);
    EXPECT_EQ(now.big, 127);
    EXPECT_EQ(now.limited, 2.0f);
    Before far;
    far.speed = -1e30f;
    EXPECT_EQ(converted(far).speed, std::numeric_limits<int>::min());
    far.speed = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(converted(far).speed, 0) << "no number: the default stays";
}

TEST(ConvertComponent, keepsDefaultsOfNewFieldsAndOfOtherKinds) {
    const Now now = converted(changed());
    EXPECT_EQ(now.added, 4.0f);
    EXPECT_EQ(now.home, 5);
}

TEST(ConvertComponent, givesFieldsWithTheOldDefaultTheNewOne) {
    const Now now = converted(Before{});
    EXPECT_EQ(now.base, (Vec2{9.0f, 9.0f}));
    EXPECT_EQ(now.speed, 0);
    EXPECT_EQ(now.open, 7);
    TypeInfo other = describe<Before>();
    other.defaults[0] = std::byte{1};
    EXPECT_FALSE(sameLayout(describe<Before>(), other)) << "components must follow the new default";
}

TEST(ConvertComponent, keepsTheItemsOfAListThatFit) {
    Before before;
    before.times.count = 3;
    for (std::uint32_t i = 0; i < 3; ++i) before.times.items[i] = static_cast<float>(i) + 0.5f;
    const Now now = converted(before);
    ASSERT_EQ(now.times.count, 2u);
    EXPECT_EQ(now.times.items[1], 1.5f);
}

/// A type with one field, named "value".
template <class T>
struct One {
    T value{};

    static void describe(TypeBuilder<One>& type) {
        type.name("One");
        type.template field<&One::value>("value");
    }
};

template <class To, class From>
To convertedTo(From value, To preset = {}) {
    const One<From> before{value};
    One<To> now{preset};
    convertComponent(describe<One<From>>(), &before, describe<One<To>>(), &now);
    return now.value;
}

TEST(ConvertComponent, keepsEveryNumberOfTheSameKind) {
    for (const std::uint64_t bits : {~0ull, 1ull << 63, (1ull << 53) + 1, 12345678901234567ull}) {
        EXPECT_EQ(convertedTo<std::uint64_t>(bits), bits);
        EXPECT_EQ(convertedTo<std::int64_t>(static_cast<std::int64_t>(bits)),
                  static_cast<std::int64_t>(bits));
    }
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(convertedTo<float>(kInfinity), kInfinity);
    EXPECT_EQ(convertedTo<float>(-kInfinity), -kInfinity);
    EXPECT_TRUE(std::isnan(convertedTo<float>(std::numeric_limits<float>::quiet_NaN())));
}

TEST(ConvertComponent, leavesAFieldThatHasNotChangedBeyondItsRange) {
    TypeInfo type = describe<One<float>>();
    type.fields[0].max = 2.0f;
    const One<float> before{9.0f};
    One<float> now;
    convertComponent(type, &before, type, &now);
    EXPECT_EQ(now.value, 9.0f) << "the code gave it this value, and another field has changed";
    TypeInfo limited = type;
    limited.fields[0].max = 3.0f;
    convertComponent(type, &before, limited, &now);
    EXPECT_EQ(now.value, 3.0f);
}

TEST(ConvertComponent, limitsWholeNumbersToTheBytesOfTheField) {
    EXPECT_EQ(convertedTo<std::int64_t>(~0ull), std::numeric_limits<std::int64_t>::max());
    EXPECT_EQ(convertedTo<std::uint64_t>(std::int64_t{-5}), 0u);
    EXPECT_EQ(convertedTo<std::uint64_t>(1e30f), std::numeric_limits<std::uint64_t>::max());
    EXPECT_EQ(convertedTo<std::int64_t>(-1e30f), std::numeric_limits<std::int64_t>::min());
    EXPECT_EQ(convertedTo<std::uint8_t>(300), 255);
    EXPECT_EQ(convertedTo<std::int8_t>(-300), -128);
    EXPECT_EQ(convertedTo<std::int16_t>(-2.5f), -3);
    EXPECT_EQ(convertedTo<bool>(0.25f), true);
}

TEST(ConvertComponent, keepsTheShapeOfACurve) {
    Curve line = Curve::line(3.0f, 1.0f);
    line.shape = CurveShape::Linear;
    EXPECT_EQ(convertedTo<Curve>(line), line);
}

TEST(ConvertComponent, clearsTheItemsOfADefaultBeyondThoseOfAList) {
    FixedList<float, 4> one, three;
    one.push(5.0f);
    for (const float item : {1.0f, 2.0f, 3.0f}) three.push(item);
    EXPECT_EQ((convertedTo<FixedList<float, 4>>(one, three)), one);
}

TEST(ConvertComponent, knowsNegativeEnums) {
    TypeInfo before = describe<One<int>>(), now = before;
    before.fields[0].kind = now.fields[0].kind = FieldKind::Enum;
    before.fields[0].names = {{"under", -1}, {"over", 1}};
    now.fields[0].names = {{"under", -7}, {"over", 7}};
    const One<int> under{-1};
    One<int> converted{7};
    convertComponent(before, &under, now, &converted);
    EXPECT_EQ(converted.value, -7);
}

TEST(ConvertComponent, copiesWhatIsNoNumberIfKindAssetAndSizeAreTheSame) {
    FieldInfo field;
    field.name = "value";
    field.kind = FieldKind::Vec2;
    field.size = 8;
    const std::uint64_t value = 0x1122334455667788ull;
    const auto isCopied = [&](const FieldInfo& before, const FieldInfo& now) {
        TypeInfo from, to;
        from.fields.push_back(before);
        to.fields.push_back(now);
        std::uint64_t result = 0;
        convertComponent(from, &value, to, &result);
        return result == value;
    };
    EXPECT_TRUE(isCopied(field, field));
    FieldInfo other = field;
    other.max = 5.0f;
    EXPECT_TRUE(isCopied(field, other)) << "a pair is not limited";
    other.size = 4;
    EXPECT_FALSE(isCopied(field, other));
    other = field;
    other.kind = FieldKind::Text;
    EXPECT_FALSE(isCopied(field, other));
    FieldInfo texture = field;
    texture.kind = FieldKind::Asset;
    texture.asset = AssetKind::Texture;
    other = texture;
    other.asset = AssetKind::Sound;
    EXPECT_FALSE(isCopied(texture, other)) << "another kind of file";
    other = texture;
    other.min = -1.0f;
    EXPECT_TRUE(isCopied(texture, other));
    FieldInfo number = field;
    number.kind = FieldKind::Int;
    EXPECT_FALSE(isCopied(number, field));
    EXPECT_FALSE(isCopied(field, number));
}

TEST(ConvertComponent, keepsListsOfOtherElementsAsTheyAre) {
    FixedList<float, 4> floats;
    floats.push(1.5f);
    FixedList<int, 4> ints;
    ints.push(7);
    EXPECT_EQ((convertedTo<FixedList<int, 4>>(floats, ints)), ints);
    FixedList<std::int16_t, 4> shorts;
    shorts.push(3), shorts.push(4);
    EXPECT_EQ((convertedTo<FixedList<int, 4>>(shorts, ints)), ints) << "the same kind with other sizes";
    FixedList<Vec2, Curve::kKeys> pairs;
    pairs.push({0.5f, 3.0f});
    const Curve curve = Curve::line(3.0f, 1.0f);
    EXPECT_EQ(convertedTo<Curve>(pairs, curve), curve);
    EXPECT_EQ((convertedTo<FixedList<Vec2, Curve::kKeys>>(curve, pairs)), pairs);
    FixedList<int, 2> few;
    few.count = 1000;  // wrong: beyond its capacity
    few.items = {1, 2};
    const auto more = convertedTo<FixedList<int, 4>>(few);
    EXPECT_EQ(more.count, 2u);
    EXPECT_EQ(more.items[1], 2);
    EXPECT_EQ(more.items[2], 0);
}

TEST(ConvertComponent, copiesACurveWhoseRangeChanged) {
    TypeInfo before = describe<One<Curve>>(), now = before;
    now.fields[0].max = 2.0f;
    const One<Curve> from{Curve::line(3.0f, 1.0f)};
    One<Curve> to;
    convertComponent(before, &from, now, &to);
    EXPECT_EQ(to.value, from.value);
}

TEST(ConvertComponent, formerFieldsAreFoundByTheirNameBeforeTheirFormerName) {
    TypeInfo type;
    for (const char* name : {"new", "old", ""}) type.fields.emplace_back().name = name;
    FieldInfo field;
    field.name = "new";
    field.was = "old";
    EXPECT_EQ(formerField(type, field), &type.fields[0]);
    field.name = "other";
    EXPECT_EQ(formerField(type, field), &type.fields[1]);
    field.was = "";
    EXPECT_EQ(formerField(type, field), nullptr) << "no former name is not the name of a field";
    field.was = "none";
    EXPECT_EQ(formerField(type, field), nullptr);
}

TEST(ConvertComponent, boolsIntegersFloatsAndEnumsAreNumbers) {
    for (int i = 0; i <= static_cast<int>(FieldKind::List); ++i) {
        const auto kind = static_cast<FieldKind>(i);
        EXPECT_EQ(isNumber(kind), kind == FieldKind::Bool || kind == FieldKind::Int ||
                                      kind == FieldKind::Float || kind == FieldKind::Enum);
    }
}

TEST(ConvertComponent, layoutsDifferInAnySingleProperty) {
    const TypeInfo type = describe<Before>();
    const std::vector<void (*)(TypeInfo&)> changes{
        [](TypeInfo& t) { ++t.key; },
        [](TypeInfo& t) { ++t.size; },
        [](TypeInfo& t) { ++t.alignment; },
        [](TypeInfo& t) { t.defaults.pop_back(); },
        [](TypeInfo& t) { t.fields.pop_back(); },
        [](TypeInfo& t) { t.fields[0].name = "other"; },
        [](TypeInfo& t) { ++t.fields[0].offset; },
        [](TypeInfo& t) { t.fields[0].kind = FieldKind::Int; },
        [](TypeInfo& t) { t.fields[0].element = FieldKind::Int; },
        [](TypeInfo& t) { t.fields[0].asset = AssetKind::Sound; },
        [](TypeInfo& t) { ++t.fields[0].size; },
        [](TypeInfo& t) { t.fields[0].isSigned = !t.fields[0].isSigned; },
        [](TypeInfo& t) { ++t.fields[0].capacity; },
        [](TypeInfo& t) { ++t.fields[0].elementSize; },
        [](TypeInfo& t) { t.fields[0].min = 0.0f; },
        [](TypeInfo& t) { t.fields[0].max = 0.0f; },
        [](TypeInfo& t) { t.fields[3].names.pop_back(); },
        [](TypeInfo& t) { t.fields[3].names[1].value = 9; },
        [](TypeInfo& t) { t.fields[3].names[1].name = "furious"; }};
    for (std::size_t i = 0; i < changes.size(); ++i) {
        TypeInfo other = type;
        EXPECT_TRUE(sameLayout(type, other));
        changes[i](other);
        EXPECT_FALSE(sameLayout(type, other)) << "change " << i;
        EXPECT_FALSE(sameLayout(other, type)) << "change " << i;
    }
    TypeInfo other = type;
    other.fields[0].doc = "for the inspector only";
    EXPECT_TRUE(sameLayout(type, other));
}

TEST(ConvertComponent, knowsEqualLayouts) {
    const TypeInfo type = describe<Before>();
    EXPECT_TRUE(sameLayout(type, describe<Before>()));
    EXPECT_FALSE(sameLayout(type, describe<Now>()));
    TypeInfo other = type;
    other.fields[3].names[1].name = "furious";
    EXPECT_FALSE(sameLayout(type, other)) << "files and conversions go by the names";
    other = type;
    other.fields[1].max = 9.0f;
    EXPECT_FALSE(sameLayout(type, other)) << "values are limited to the new range";
    other = type;
    std::swap(other.fields[0].offset, other.fields[1].offset);
    EXPECT_FALSE(sameLayout(type, other));
}

TEST(ConvertComponent, thereAndBackKeepsWhatBothVersionsHave) {
    int kept = 0;
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        Random random = Random::seeded(seed);
        const TypeInfo a = made_types::random(random, 0, "Made");
        const TypeInfo b = made_types::random(random, 0, "Made");
        std::vector<std::byte> from(a.size), middle(b.size), back(a.size);
        for (std::byte& byte : from) byte = static_cast<std::byte>(random.below(2));
        convertComponent(a, from.data(), b, middle.data());
        convertComponent(b, middle.data(), a, back.data());
        for (const FieldInfo& field : a.fields) {
            const FieldInfo* other = b.find(field.name);
            if (other == nullptr || other->kind != field.kind) continue;
            EXPECT_EQ(std::memcmp(field.in(from.data()), field.in(back.data()), field.size), 0)
                << "seed " << seed << ", field " << field.name;
            ++kept;
        }
    }
    EXPECT_GT(kept, 150);
}

}  // namespace
}  // namespace plumb
