#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "ecs/component_type.hpp"
#include "math/curve.hpp"

// The hash of a component finds the first tick in which two games differ: it must see every byte of every
// field, and nothing else.

namespace plumb {
namespace {

struct Field {
    FieldKind kind;
    std::size_t size;
};

constexpr std::array<Field, 16> kFields{{{FieldKind::Bool, 1},
                                         {FieldKind::Int, 1},
                                         {FieldKind::Int, 2},
                                         {FieldKind::Int, 4},
                                         {FieldKind::Int, 8},
                                         {FieldKind::Enum, 1},
                                         {FieldKind::Enum, 4},
                                         {FieldKind::Float, 4},
                                         {FieldKind::Vec2, 8},
                                         {FieldKind::Rect, 16},
                                         {FieldKind::Color, 4},
                                         {FieldKind::Text, 8},
                                         {FieldKind::Entity, 8},
                                         {FieldKind::Asset, 8},
                                         {FieldKind::Tiles, 4},
                                         {FieldKind::Bool, 1}}};

constexpr std::size_t kStep = 24;  ///< bytes from field to field, of which not all belong to a field

TypeInfo typeOfAllKinds() {
    TypeInfo type;
    for (const Field& field : kFields) {
        FieldInfo info;
        info.kind = field.kind;
        info.size = field.size;
        info.offset = type.fields.size() * kStep;
        type.fields.push_back(info);
    }
    type.size = kFields.size() * kStep;
    return type;
}

std::uint64_t hashOf(const TypeInfo& type, const void* component) {
    Hasher hasher;
    hashComponent(hasher, type, component);
    return hasher.value();
}

TEST(ComponentHash, everyByteOfAFieldCountsAndNoOther) {
    const TypeInfo type = typeOfAllKinds();
    Random random = Random::seeded(1);
    std::vector<std::byte> component(type.size);
    for (std::byte& byte : component) byte = static_cast<std::byte>(1 + random.below(60));  // no zero, no NaN
    const std::uint64_t hash = hashOf(type, component.data());
    for (std::size_t at = 0; at < type.size; ++at) {
        std::vector<std::byte> changed = component;
        changed[at] ^= std::byte{1};
        const bool isPart = at % kStep < kFields[at / kStep].size;
        EXPECT_EQ(hashOf(type, changed.data()) != hash, isPart) << "byte " << at;
    }
}

TEST(ComponentHash, fieldsOfEqualBytesDifferByTheirPlace) {
    const TypeInfo type = typeOfAllKinds();
    std::vector<std::uint64_t> hashes;
    for (std::size_t i = 0; i < kFields.size(); ++i) {
        std::vector<std::byte> component(type.size);
        component[i * kStep] = std::byte{1};
        hashes.push_back(hashOf(type, component.data()));
        for (std::size_t k = 0; k < i; ++k) EXPECT_NE(hashes[i], hashes[k]) << k << " and " << i;
    }
}

TEST(ComponentHash, floatsCountByTheirValue) {
    TypeInfo type;
    FieldInfo field;
    field.kind = FieldKind::Vec2;
    field.size = 8;
    type.fields.push_back(field);
    type.size = 8;
    const auto hash = [&](float x, float y) {
        const float values[] = {x, y};
        return hashOf(type, values);
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(hash(0.0f, -0.0f), hash(-0.0f, 0.0f));
    EXPECT_EQ(hash(nan, 1.0f), hash(-nan, 1.0f));
    EXPECT_NE(hash(nan, 1.0f), hash(0.0f, 1.0f));
    EXPECT_NE(hash(1.0f, 2.0f), hash(2.0f, 1.0f));
    EXPECT_NE(hash(1.0f, 0.0f), hash(1.0f, std::numeric_limits<float>::denorm_min()));
}

/// A list of up to 4 elements, and their number.
struct ListLayout {
    TypeInfo type;
    std::size_t elementSize;

    ListLayout(FieldKind element, std::size_t size) : elementSize{size} {
        FieldInfo field;
        field.kind = FieldKind::List;
        field.element = element;
        field.elementSize = size;
        field.capacity = 4;
        field.countOffset = 4 * size;
        field.size = 4 * size + 4;
        type.fields.push_back(field);
        type.size = field.size;
    }
    [[nodiscard]] std::uint64_t hash(std::vector<std::byte> bytes, std::uint32_t count) const {
        bytes.resize(4 * elementSize + 4);
        std::memcpy(bytes.data() + 4 * elementSize, &count, sizeof count);
        return hashOf(type, bytes.data());
    }
};

TEST(ComponentHash, theElementsOfAListCountUpToItsLength) {
    for (const ListLayout& list :
         {ListLayout{FieldKind::Float, 4}, ListLayout{FieldKind::Vec2, 8}, ListLayout{FieldKind::Int, 4},
          ListLayout{FieldKind::Entity, 8}, ListLayout{FieldKind::Text, 8}}) {
        SCOPED_TRACE(testing::Message() << static_cast<int>(list.type.fields[0].element));
        Random random = Random::seeded(2);
        std::vector<std::byte> bytes(4 * list.elementSize);
        for (std::byte& byte : bytes) byte = static_cast<std::byte>(1 + random.below(60));
        for (std::uint32_t count = 0; count <= 4; ++count) {
            const std::uint64_t hash = list.hash(bytes, count);
            for (std::size_t at = 0; at < bytes.size(); ++at) {
                std::vector<std::byte> changed = bytes;
                changed[at] ^= std::byte{1};
                EXPECT_EQ(list.hash(changed, count) != hash, at < count * list.elementSize)
                    << "byte " << at << " of " << count << " elements";
            }
            for (std::uint32_t other = 0; other < count; ++other) EXPECT_NE(list.hash(bytes, other), hash);
        }
        // A damaged length does not reach beyond the list.
        EXPECT_NE(list.hash(bytes, 0xffffffffu), list.hash(bytes, 4));
    }
}

TEST(ComponentHash, everyPartOfACurveCounts) {
    TypeInfo type;
    FieldInfo field;
    field.kind = FieldKind::List;
    field.element = FieldKind::Vec2;
    field.elementSize = sizeof(CurveKey);
    field.capacity = Curve::kKeys;
    field.countOffset = offsetof(Curve, count);
    field.size = sizeof(Curve);
    type.fields.push_back(field);
    type.size = sizeof(Curve);
    const Curve curve = Curve::hump(0.25f, 1.0f);
    std::vector<Curve> others(6, curve);
    others[0].shape = curve.shape == CurveShape::Smooth ? CurveShape::Linear : CurveShape::Smooth;
    others[1].count = 2;
    others[2].keys[0].at = 0.1f;
    others[3].keys[0].value = 0.2f;
    others[4].keys[2].at = 0.9f;
    others[5].keys[2].value = 0.5f;
    for (std::size_t i = 0; i < others.size(); ++i)
        EXPECT_NE(hashOf(type, &others[i]), hashOf(type, &curve)) << i;
    Curve same = curve;
    same.keys[3].value = 7.0f;
    EXPECT_EQ(hashOf(type, &same), hashOf(type, &curve)) << "no key of the curve";
}

TEST(ComponentHash, aTypeWithoutADescriptionCountsByItsBytes) {
    TypeInfo type;
    type.size = 13;
    std::vector<std::byte> bytes(13, std::byte{5});
    const std::uint64_t hash = hashOf(type, bytes.data());
    for (std::size_t at = 0; at < 13; ++at) {
        std::vector<std::byte> changed = bytes;
        changed[at] = std::byte{6};
        EXPECT_NE(hashOf(type, changed.data()), hash) << at;
    }
    type.size = 0;
    EXPECT_EQ(hashOf(type, bytes.data()), Hasher{}.value()) << "a tag has nothing to hash";
}

}  // namespace
}  // namespace plumb
