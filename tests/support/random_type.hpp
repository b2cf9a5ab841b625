#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include "core/random.hpp"
#include "math/vec2.hpp"
#include "reflect/type_info.hpp"

namespace plumb {

/// Descriptions of component types that no C++ code defines, like those of scripts or libraries that are
/// loaded while the program runs.
namespace made_types {

inline constexpr std::array<std::string_view, 6> kNames{"speed", "health", "target",
                                                        "open",  "offset", "count"};

inline FieldInfo field(std::string_view name, FieldKind kind) {
    FieldInfo made;
    made.name = name;
    made.kind = kind;
    switch (kind) {
        case FieldKind::Bool: made.size = 1; break;
        case FieldKind::Vec2:
        case FieldKind::Entity: made.size = 8; break;
        default: made.size = 4; break;
    }
    return made;
}

/// Sets the offsets of the fields, the size of the type, and its default value: all bytes are `value`.
inline void layOut(TypeInfo& type, std::byte value = {}) {
    std::size_t offset = 0;
    for (FieldInfo& field : type.fields) {
        const std::size_t alignment = field.size == 1 ? 1 : 4;
        offset = (offset + alignment - 1) / alignment * alignment;
        field.offset = offset;
        offset += field.size;
    }
    type.alignment = 4;
    type.size = (offset + 3) / 4 * 4;
    type.defaults.assign(type.size, value);
}

/// Creates a type with one to six fields in random order, each of a random kind.
inline TypeInfo random(Random& random, TypeKey key, std::string_view name) {
    constexpr std::array kKinds{FieldKind::Bool, FieldKind::Int, FieldKind::Float, FieldKind::Vec2,
                                FieldKind::Entity};
    TypeInfo type;
    type.name = name;
    type.key = key;
    std::vector<std::string_view> names{kNames.begin(), kNames.end()};
    const auto count = 1 + random.below(static_cast<std::uint32_t>(names.size()));
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto at = random.below(static_cast<std::uint32_t>(names.size()));
        type.fields.push_back(
            field(names[at], kKinds[random.below(static_cast<std::uint32_t>(kKinds.size()))]));
        names.erase(names.begin() + at);
    }
    layOut(type);
    return type;
}

}  // namespace made_types

}  // namespace plumb
