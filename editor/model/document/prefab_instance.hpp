#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editor/model/document/entity_state.hpp"
#include "scene/files/prefab_placing.hpp"

namespace plumb::editor {

/// One entity of a prefab instance together with the entity of the prefab from which it was made. Valid until
/// the document or the prefab changes.
class InstancePart {
public:
    /// Returns nullopt if the entity does not belong to an instance, or its prefab cannot be read.
    static std::optional<InstancePart> of(Document& document, PrefabLibrary* prefabs, ObjectId id);

    [[nodiscard]] ObjectId id() const { return id_; }
    [[nodiscard]] ObjectId root() const { return root_; }
    [[nodiscard]] bool isRoot() const { return id_ == root_; }
    [[nodiscard]] const Prefab& prefab() const { return *prefab_; }
    [[nodiscard]] const PrefabEntity& base() const { return *base_; }
    /// Returns the existing entities of the instance, the root first.
    [[nodiscard]] std::vector<ObjectId> all() const;

    [[nodiscard]] bool prefabHas(const TypeInfo& type) const;
    /// Returns the component as the prefab defines it. @pre prefabHas(type)
    [[nodiscard]] ComponentState baseOf(const TypeInfo& type) const;
    /// Returns the fields that differ from the prefab, as JSON; without the position and rotation of the
    /// root.
    /// @pre prefabHas(type), and the entity has the component
    [[nodiscard]] Json differences(const TypeInfo& type) const;

    /// Returns this entity paired with another version of its prefab; nullopt if that lacks the part.
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

/// True for the position and rotation in Transform, which the root of each instance has for itself.
bool isInstancePose(const TypeInfo& type, std::string_view field);
/// True if an instance can override the component. Names, and links to parents, scene and prefab, cannot be
/// overridden.
bool canOverride(const TypeInfo& type);

/// The differences of one entity from its prefab, which the inspector marks.
struct PrefabOverrides {
    struct Component {
        const TypeInfo* type = nullptr;
        bool added = false;    ///< the prefab has no such component
        bool removed = false;  ///< the entity has no such component
        std::vector<std::string> fields;
    };
    bool isPart = false;  ///< the entity belongs to a prefab instance
    std::vector<Component> components;

    [[nodiscard]] const Component* find(const TypeInfo& type) const;
    [[nodiscard]] bool has(const TypeInfo& type, std::string_view field) const;
    [[nodiscard]] std::size_t count() const;  ///< number of fields, plus components added or removed
};
PrefabOverrides overridesOf(Document& document, PrefabLibrary* prefabs, ObjectId id);

/// Returns entities, without the prefab's components, for those parts of an instance that the document lacks.
std::vector<EntityState> missingParts(Document& document, const Prefab& prefab, ObjectId root);

}  // namespace plumb::editor
