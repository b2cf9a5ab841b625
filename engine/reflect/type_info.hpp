#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
#include <vector>

namespace plumb {

/// All types that a component field may have. A closed set: a new kind is a new `case` in
/// the JSON codec, the inspector and the hash, and the compiler lists the missing ones.
enum class FieldKind : std::uint8_t {
    Bool,
    Int,
    Float,
    Vec2,
    Rect,
    Color,
    Text,
    Enum,
    Entity,
    Asset,
    Tiles,
    List
};

/// Unit of a number. Memory, JSON and Lua use exactly this unit; only the inspector converts.
enum class Unit : std::uint8_t {
    None,
    Pixels,
    PixelsPerSecond,
    PixelsPerSecondSquared,
    Seconds,
    Radians,
    RadiansPerSecond,
    Ratio,
    Kilograms,
    Tiles,
    Ticks,
    Degrees  ///< of properties of scripts; the engine's own angles are in rad
};

/// Kinds of files that an Asset field may refer to; the inspector offers only these.
enum class AssetKind : std::uint8_t { None, Texture, Tileset, Animation, Sound, Font, Scene, Prefab };

struct EnumName {
    std::string_view name;  ///< in files and in the inspector
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
    std::size_t size = 0;         ///< bytes in memory; an Int may have 1, 2, 4 or 8, an Enum 1 or 4
    bool isSigned = true;         ///< for an Int
    std::size_t capacity = 0;     ///< for a List: maximum number of items
    std::size_t elementSize = 0;  ///< for a List: bytes per item
    bool transient = false;       ///< runtime state: shown, hashed, not saved
    bool layerBits = false;       ///< for an unsigned Int: each bit is a collision layer
    float step = 0.0f;            ///< change per drag step in the inspector; 0: the default for the unit
    std::string_view shownIf;     ///< the Bool or Enum of the same component on which this one depends
    int shownIfValue = 1;         ///< required value of that field
    std::vector<EnumName> names;  ///< for an Enum: its values
    std::size_t offset = 0;       ///< bytes from the start of the object
    std::size_t countOffset =
        0;  ///< for a List: bytes from its start to its count; items start at the list's start

    [[nodiscard]] void* in(void* object) const { return static_cast<std::byte*>(object) + offset; }
    [[nodiscard]] const void* in(const void* object) const {
        return static_cast<const std::byte*>(object) + offset;
    }
    /// Number of items of a List that starts at this address.
    [[nodiscard]] std::uint32_t& countOf(void* list) const {
        return *reinterpret_cast<std::uint32_t*>(static_cast<std::byte*>(list) + countOffset);
    }
    [[nodiscard]] std::uint32_t countOf(const void* list) const { return countOf(const_cast<void*>(list)); }
};

/// Index of a type in this program, in the order of first use; never saved or shown.
using TypeKey = std::uint32_t;

struct TypeInfo {
    std::string_view name;
    std::string_view cppName;  ///< of the C++ type, for messages; empty for types of scripts
    std::string_view doc;
    std::vector<FieldInfo> fields;
    TypeKey key = 0;
    std::size_t size = 0;  ///< bytes; 0 for a tag
    std::size_t alignment = 1;
    std::vector<std::byte> defaults;  ///< bytes of the default value; empty if there is none, or for a tag

    /// Writes the default value. @pre there is one
    void construct(void* memory) const {
        if (!defaults.empty()) std::memcpy(memory, defaults.data(), defaults.size());
    }

    [[nodiscard]] const FieldInfo* find(std::string_view field) const {
        for (const FieldInfo& info : fields) {
            if (info.name == field) return &info;
        }
        return nullptr;
    }
};

}  // namespace plumb
