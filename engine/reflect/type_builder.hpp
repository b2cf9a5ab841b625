#pragma once

#include <concepts>
#include <initializer_list>
#include <memory>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/fixed_list.hpp"
#include "math/color.hpp"
#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "reflect/entity_id.hpp"
#include "reflect/field_types.hpp"
#include "reflect/type_info.hpp"
#include "reflect/type_key.hpp"
#include "reflect/type_name.hpp"

namespace plumb {

template <class T>
inline constexpr AssetKind kAssetKind = AssetKind::None;
template <AssetKind Kind>
inline constexpr AssetKind kAssetKind<AssetRef<Kind>> = Kind;

template <class T>
struct ListTraits : std::false_type {};
template <class T, std::size_t N>
struct ListTraits<FixedList<T, N>> : std::true_type {
    using Element = T;
    static constexpr std::size_t kCapacity = N;
};

template <class T>
constexpr FieldKind kindOf() {
    if constexpr (std::same_as<T, bool>) {
        return FieldKind::Bool;
    } else if constexpr (std::is_enum_v<T>) {
        return FieldKind::Enum;
    } else if constexpr (std::integral<T>) {
        return FieldKind::Int;
    } else if constexpr (std::same_as<T, float>) {
        return FieldKind::Float;
    } else if constexpr (std::same_as<T, Vec2>) {
        return FieldKind::Vec2;
    } else if constexpr (std::same_as<T, Rect>) {
        return FieldKind::Rect;
    } else if constexpr (std::same_as<T, Color>) {
        return FieldKind::Color;
    } else if constexpr (std::same_as<T, TextId>) {
        return FieldKind::Text;
    } else if constexpr (std::same_as<T, EntityId>) {
        return FieldKind::Entity;
    } else if constexpr (kAssetKind<T> != AssetKind::None) {
        return FieldKind::Asset;
    } else if constexpr (std::same_as<T, TilesId>) {
        return FieldKind::Tiles;
    } else {
        static_assert(ListTraits<T>::value, "no FieldKind for this type: see reflect/type_info.hpp");
        return FieldKind::List;
    }
}

/// Bytes of a default value, with zeros between its members; none for a tag.
template <class T>
std::vector<std::byte> defaultBytes() {
    if constexpr (kIsTag<T>) {
        return {};
    } else {
        alignas(T) std::byte memory[sizeof(T)]{};
        std::construct_at(reinterpret_cast<T*>(memory));
        return {memory, memory + sizeof(T)};
    }
}

/// Sets properties of the field just added: `type.field<&Spin::rate>("rate").unit(...)`.
class FieldBuilder {
public:
    explicit FieldBuilder(FieldInfo& field) : field_{field} {}

    /// Unit of the numbers; the inspector shows it.
    FieldBuilder& unit(Unit unit) { return field_.unit = unit, *this; }
    /// Smallest and largest value that the inspector and files may set, in the field's unit.
    FieldBuilder& range(float min, float max) { return field_.min = min, field_.max = max, *this; }
    /// Description in the inspector.
    FieldBuilder& doc(std::string_view text) { return field_.doc = text, *this; }
    /// The field's name in older files, so that they can still be loaded.
    FieldBuilder& was(std::string_view oldName) { return field_.was = oldName, *this; }
    /// Marks runtime state: shown and hashed, not saved.
    FieldBuilder& transient() { return field_.transient = true, *this; }
    /// Change per pixel of a drag in the inspector, in the field's unit.
    FieldBuilder& step(float step) { return field_.step = step, *this; }
    /// Marks a set of collision layers, one per bit.
    FieldBuilder& layerBits() { return field_.layerBits = true, *this; }
    /// The field has an effect only if another field of the component, a
    /// bool or an enum, has this value; otherwise the inspector hides it.
    FieldBuilder& shownIf(std::string_view other, int value = 1) {
        return field_.shownIf = other, field_.shownIfValue = value, *this;
    }
    /// Names of the values of an enum, in files and in the inspector: .names({{"walk", 0}, {"fly", 1}}).
    FieldBuilder& names(std::initializer_list<EnumName> names) { return field_.names = names, *this; }

private:
    FieldInfo& field_;
};

/// Fills a TypeInfo from a type's own `describe` function.
template <class T>
class TypeBuilder {
    static_assert(std::is_trivially_copyable_v<T>,
                  "components are plain data; use ids for variable-size data");

public:
    explicit TypeBuilder(TypeInfo& type) : type_{type} {
        type_.key = typeKey<T>();
        type_.cppName = shortTypeName<T>();
        type_.size = kIsTag<T> ? 0 : sizeof(T);
        type_.alignment = alignof(T);
        type_.defaults = defaultBytes<T>();
    }

    /// Name of the type in files, in the inspector and in scripts.
    TypeBuilder& name(std::string_view name) { return type_.name = name, *this; }
    /// Description in the inspector.
    TypeBuilder& doc(std::string_view text) { return type_.doc = text, *this; }

    /// Adds a field, which is saved and shown: type.field<&Spin::rate>("rate"). @param name  that of the
    /// member
    template <auto Member>
    FieldBuilder field(std::string_view name) {
        using Value = std::remove_reference_t<decltype(std::declval<T&>().*Member)>;
        FieldInfo& field = type_.fields.emplace_back();
        field.name = name;
        field.kind = kindOf<Value>();
        field.size = sizeof(Value);
        field.asset = kAssetKind<Value>;
        field.offset = distance(&object_, &(object_.*Member));
        if constexpr (std::integral<Value>) {
            field.isSigned = std::is_signed_v<Value>;
        }
        if constexpr (ListTraits<Value>::value) {
            using Element = typename ListTraits<Value>::Element;
            field.element = kindOf<Element>();
            field.elementSize = sizeof(Element);
            field.capacity = ListTraits<Value>::kCapacity;
            field.asset = kAssetKind<Element>;
            const auto& list = object_.*Member;
            field.countOffset = distance(&list, &list.count);
        }
        return FieldBuilder{field};
    }

private:
    static std::size_t distance(const void* from, const void* to) {
        return static_cast<std::size_t>(static_cast<const std::byte*>(to) -
                                        static_cast<const std::byte*>(from));
    }

    TypeInfo& type_;
    T object_{};  // to measure where its members are
};

/// A type with a `describe` function.
template <class T>
concept Described = requires(TypeBuilder<T>& builder) {
    T::describe(builder);
};

}  // namespace plumb
