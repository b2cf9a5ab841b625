#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editor/model/document/entity_state.hpp"
#include "scene/files/prefab_placing.hpp"

namespace plumb::editor {

/// One entity of a prefab instance beside what the prefab says about it. Short-lived: valid until the
/// document or the prefab changes.
class InstancePart {
public:
    /// Nothing when the entity is no part of an instance, or its prefab cannot be read.
    static std::optional<InstancePart> of(Document& document, PrefabLibrary* prefabs, ObjectId id);

    [[nodiscard]] ObjectId id() const { return id_; }
    [[nodiscard]] ObjectId root() const { return root_; }
    [[nodiscard]] bool isRoot() const { return id_ == root_; }
    [[nodiscard]] const Prefab& prefab() const { return *prefab_; }
    [[nodiscard]] const PrefabEntity& base() const { return *base_; }
    /// All entities of the instance that are there, the root first.
    [[nodiscard]] std::vector<ObjectId> all() const;

    [[nodiscard]] bool prefabHas(const TypeInfo& type) const;
    /// What the prefab gives this component. @pre prefabHas(type)
    [[nodiscard]] ComponentState baseOf(const TypeInfo& type) const;
    /// The fields that differ from the prefab, as files hold them. An instance's own place is none of them.
    /// @pre prefabHas(type), and the entity has the component
    [[nodiscard]] Json differences(const TypeInfo& type) const;

    /// The same entity, seen beside another version of its prefab; nothing when that has no such part.
    [[nodiscard]] std::optional<InstancePart> besides(const Prefab& prefab) const;

private:
    InstancePart(Document& document, ObjectId id, ObjectId root, std::uint64_t part, const Prefab& prefab);

    [[nodiscard]] const Json* fieldsOf(const TypeInfo& type) const;

    Document* document_;
    ObjectId id_;
    ObjectId root_;
    std::uint64_t part_;
    const Prefab* prefab_;
    const PrefabEntity* base_;
    PlacedPrefab placed_;
};

/// Whether an instance keeps a field for itself: where its first entity stands and how it is turned.
bool isOwnPlace(const TypeInfo& type, std::string_view field);
/// Whether a component can differ from a prefab; those that tie entities together cannot.
bool canOverride(const TypeInfo& type);

/// How one entity differs from its prefab: what the inspector marks.
struct PrefabOverrides {
    struct Component {
        const TypeInfo* type = nullptr;
        bool added = false;    ///< the prefab has no such component
        bool removed = false;  ///< the entity has no such component
        std::vector<std::string> fields;
    };
    bool isPart = false;  ///< the entity comes from a prefab
    std::vector<Component> components;

    [[nodiscard]] const Component* find(const TypeInfo& type) const;
    [[nodiscard]] bool has(const TypeInfo& type, std::string_view field) const;
    [[nodiscard]] std::size_t count() const;  ///< fields, and components added or removed
};
PrefabOverrides overridesOf(Document& document, PrefabLibrary* prefabs, ObjectId id);

/// Entities for the parts of an instance that are not in the document, without components of their own.
std::vector<EntityState> missingParts(Document& document, const Prefab& prefab, ObjectId root);

}  // namespace plumb::editor
