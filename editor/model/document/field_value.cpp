#include "editor/model/document/field_value.hpp"

#include <algorithm>
#include <span>

namespace plumb::editor {
namespace {

static_assert(sizeof(EntityId) == sizeof(ObjectId),
              "FieldValue stores an ObjectId in the bytes of an EntityId");

/// Returns the bytes of the entity references in the value.
std::span<std::byte> referencesIn(const FieldInfo& field, void* value) {
    auto* bytes = static_cast<std::byte*>(value);
    if (field.kind == FieldKind::Entity) return {bytes, sizeof(EntityId)};
    if (field.kind == FieldKind::List && field.element == FieldKind::Entity) {
        return {bytes, sizeof(EntityId) * field.countOf(value)};
    }
    return {};
}

void toLasting(const ObjectNames& names, const FieldInfo& field, void* value) {
    const std::span<std::byte> references = referencesIn(field, value);
    for (std::size_t at = 0; at < references.size(); at += sizeof(EntityId)) {
        EntityId entity;
        std::memcpy(&entity, &references[at], sizeof entity);
        const ObjectId id = names.idOf(entity);
        std::memcpy(&references[at], &id, sizeof id);
    }
}

void fromLasting(const ObjectNames& names, const FieldInfo& field, void* value) {
    const std::span<std::byte> references = referencesIn(field, value);
    for (std::size_t at = 0; at < references.size(); at += sizeof(EntityId)) {
        ObjectId id;
        std::memcpy(&id, &references[at], sizeof id);
        const EntityId entity = names.find(id);
        std::memcpy(&references[at], &entity, sizeof entity);
    }
}

}  // namespace

FieldValue readField(const ObjectNames& names, const FieldInfo& field, const void* component) {
    FieldValue value;
    value.bytes.resize(field.size);
    std::memcpy(value.bytes.data(), field.in(component), field.size);
    toLasting(names, field, value.bytes.data());
    return value;
}

void writeField(const ObjectNames& names, const FieldInfo& field, void* component, const FieldValue& value) {
    PLUMB_ASSERT(value.bytes.size() == field.size, "the value has a different size than the field");
    std::memcpy(field.in(component), value.bytes.data(), field.size);
    fromLasting(names, field, field.in(component));
}

ComponentState componentState(const ObjectNames& names, const TypeInfo& type, const void* object) {
    ComponentState state{&type, std::vector<std::byte>(type.size)};
    if (type.size == 0) return state;
    std::memcpy(state.bytes.data(), object, type.size);
    for (const FieldInfo& field : type.fields) {
        toLasting(names, field, field.in(static_cast<void*>(state.bytes.data())));
    }
    return state;
}

ComponentState readComponent(const Document& document, const TypeInfo& type, EntityId entity) {
    return componentState(document, type, type.size == 0 ? nullptr : document.world.find(type, entity));
}

void writeComponent(Document& document, EntityId entity, const ComponentState& state) {
    void* component = document.world.add(*state.type, entity);
    if (state.type->size == 0) return;
    std::memcpy(component, state.bytes.data(), state.type->size);
    for (const FieldInfo& field : state.type->fields) {
        fromLasting(document, field, field.in(component));
    }
}

ComponentState defaultComponent(const TypeInfo& type) {
    ComponentState state{&type, std::vector<std::byte>(type.size)};
    if (type.size > 0) type.construct(state.bytes.data());
    return state;
}

bool refersTo(const FieldInfo& field, const void* component, const std::vector<EntityId>& targets) {
    const std::span<std::byte> references = referencesIn(field, const_cast<void*>(field.in(component)));
    for (std::size_t at = 0; at < references.size(); at += sizeof(EntityId)) {
        EntityId entity;
        std::memcpy(&entity, &references[at], sizeof entity);
        if (std::binary_search(targets.begin(), targets.end(), entity)) return true;
    }
    return false;
}

void clearReferences(const FieldInfo& field, void* component, const std::vector<EntityId>& targets) {
    const std::span<std::byte> references = referencesIn(field, field.in(component));
    for (std::size_t at = 0; at < references.size(); at += sizeof(EntityId)) {
        EntityId entity;
        std::memcpy(&entity, &references[at], sizeof entity);
        if (!std::binary_search(targets.begin(), targets.end(), entity)) continue;
        entity = {};
        std::memcpy(&references[at], &entity, sizeof entity);
    }
}

}  // namespace plumb::editor
