#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

namespace plumb {

/// All types that a component field may have. A closed set: a new kind is a new `case` in
/// the JSON codec, the inspector and the hash, and the compiler lists the missing ones.
enum class FieldKind : std::uint8_t { Bool, Int, Float, Vec2, Rect, Color, Text, Enum, Entity, Asset, Tiles, List };

/// Unit of a number. Memory, JSON and Lua use exactly this unit; only the inspector converts.
enum class Unit : std::uint8_t {
    None, Pixels, PixelsPerSecond, PixelsPerSecondSquared, Seconds, Radians, RadiansPerSecond, Ratio, Kilograms,
    Tiles, Ticks
};

/// Kinds of files that an Asset field may refer to; the inspector offers only these.
enum class AssetKind : std::uint8_t { None, Texture, Tileset, Animation, Sound, Font, Scene, Prefab };

struct EnumName {
    std::string_view name;  ///< as in files and in the inspector
    int value = 0;
};

struct FieldInfo {
    std::string_view name;  ///< JSON key, Lua key and inspector label: the name of the member
    std::string_view was;   ///< the name in older files; empty for none
    std::string_view doc;
    FieldKind kind = FieldKind::Float;
    FieldKind element = FieldKind::Float;  ///< element type of a List
    Unit unit = Unit::None;
    AssetKind asset = AssetKind::None;
    float min = std::numeric_limits<float>::lowest();
    float max = std::numeric_limits<float>::max();
    std::size_t size = 0;          ///< bytes in memory; an Int may have 1, 2, 4 or 8, an Enum 1 or 4
    bool isSigned = true;          ///< of an Int
    std::size_t capacity = 0;      ///< of a List
    std::size_t elementSize = 0;   ///< of a List
    bool transient = false;        ///< runtime state: shown, hashed, not saved
    bool layerBits = false;        ///< of an unsigned Int: each bit is a collision layer
    float step = 0.0f;             ///< change per drag step in the inspector; 0: the default for the unit
    std::string_view shownIf;      ///< the Bool or Enum of the same component on which this one depends
    int shownIfValue = 1;          ///< required value of that field
    std::vector<EnumName> names;   ///< of an Enum
    void* (*address)(void* object) = nullptr;
    std::uint32_t* (*listCount)(void* list) = nullptr;  ///< of a List: its count; items start at the list's address

    [[nodiscard]] void* in(void* object) const { return address(object); }
    [[nodiscard]] const void* in(const void* object) const { return address(const_cast<void*>(object)); }
};

/// The number of a type in this program: dense, in the order of first use; never saved or shown.
using TypeKey = std::uint32_t;

struct TypeInfo {
    std::string_view name;
    std::string_view doc;
    std::vector<FieldInfo> fields;
    TypeKey key = 0;
    std::size_t size = 0;       ///< bytes; 0 for a tag
    std::size_t alignment = 1;
    void (*construct)(void* memory) = nullptr;  ///< constructs the default value

    [[nodiscard]] const FieldInfo* find(std::string_view field) const {
        for (const FieldInfo& info : fields) {
            if (info.name == field) return &info;
        }
        return nullptr;
    }
};

}  // namespace plumb
