#pragma once

#include <cstddef>
#include <cstring>
#include <vector>

#include "editor/model/document/document.hpp"
#include "reflect/type_info.hpp"

namespace plumb::editor {

/// The value of a field as bytes, exact to the last bit. References to entities stand in it as lasting ids
/// (both are 8 bytes), so that a value outlives the deletion and the return of what it refers to.
struct FieldValue {
    std::vector<std::byte> bytes;

    /// @param value  a reference to an entity must be an ObjectId
    template <class T>
    static FieldValue of(const T& value) {
        FieldValue made;
        made.bytes.resize(sizeof(T));
        std::memcpy(made.bytes.data(), &value, sizeof(T));
        return made;
    }
    friend bool operator==(const FieldValue&, const FieldValue&) = default;
};

FieldValue readField(const ObjectNames& names, const FieldInfo& field, const void* component);
void writeField(const ObjectNames& names, const FieldInfo& field, void* component, const FieldValue& value);

/// A whole component, in the same way.
struct ComponentState {
    const TypeInfo* type = nullptr;
    std::vector<std::byte> bytes;
};

/// @param object  may lie outside a world
ComponentState componentState(const ObjectNames& names, const TypeInfo& type, const void* object);
ComponentState readComponent(const Document& document, const TypeInfo& type, EntityId entity);
/// Adds the component when it is not there.
void writeComponent(Document& document, EntityId entity, const ComponentState& state);

/// A type's default component.
ComponentState defaultComponent(const TypeInfo& type);

/// Whether the field of this component may refer to an entity of `targets` (sorted).
bool refersTo(const FieldInfo& field, const void* component, const std::vector<EntityId>& targets);
/// Sets references to `targets` (sorted) to null.
void clearReferences(const FieldInfo& field, void* component, const std::vector<EntityId>& targets);

}  // namespace plumb::editor
