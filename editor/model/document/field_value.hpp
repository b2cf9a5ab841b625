#pragma once

#include <cstddef>
#include <cstring>
#include <vector>

#include "editor/model/document/document.hpp"
#include "reflect/type_info.hpp"

namespace plumb::editor {

/// The value of a field as bytes. References to entities are stored as ObjectIds (EntityIds have the same
/// size, 8 bytes), so they stay valid when undo recreates a deleted entity.
struct FieldValue {
    std::vector<std::byte> bytes;

    /// @param value  references to entities must be ObjectIds
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

/// All bytes of a component, with references to entities stored as ObjectIds.
struct ComponentState {
    const TypeInfo* type = nullptr;
    std::vector<std::byte> bytes;
};

/// Copies a component. @param object  the component; it need not be in a world
ComponentState componentState(const ObjectNames& names, const TypeInfo& type, const void* object);
ComponentState readComponent(const Document& document, const TypeInfo& type, EntityId entity);
/// Overwrites the entity's component, adding it if it is missing.
void writeComponent(Document& document, EntityId entity, const ComponentState& state);

/// Returns a component of this type with default values.
ComponentState defaultComponent(const TypeInfo& type);

/// True if the field of this component refers to an entity of `targets` (sorted).
bool refersTo(const FieldInfo& field, const void* component, const std::vector<EntityId>& targets);
/// Sets the field's references to entities of `targets` (sorted) to null.
void clearReferences(const FieldInfo& field, void* component, const std::vector<EntityId>& targets);

}  // namespace plumb::editor
