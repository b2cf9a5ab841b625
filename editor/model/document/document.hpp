#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "ecs/world.hpp"
#include "editor/model/document/entity_view.hpp"
#include "editor/model/document/id_table.hpp"
#include "editor/model/document/object_id.hpp"
#include "editor/model/document/selection.hpp"
#include "reflect/field_types.hpp"
#include "reflect/type_registry.hpp"

namespace plumb::editor {

class SceneBoxes;

/// A scene that is open for editing. Only commands may change its world, so that every change can be undone.
/// Neither copyable nor movable.
class Document final : public ObjectNames {
public:
    explicit Document(const TypeRegistry& types);
    ~Document() override;
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    World world;
    Selection selection;
    EntityView view;
    std::string scenePath;            ///< "scenes/cave.scene.json"; empty: no scene is open
    Vec2 picture{640.0f, 360.0f};     ///< size of the game's viewport, px
    SceneId scene;                    ///< the scene to which new entities are added
    std::uint64_t sceneRevision = 0;  ///< counts changes, so that panels know when to update caches
    std::uint64_t treeRevision = 0;   ///< counts changes of the set of entities, their parents, order, names
                                      ///< and sets of components

    /// Returns the entity with this ObjectId, null if there is none.
    [[nodiscard]] EntityId find(ObjectId id) const override;
    /// Returns the ObjectId of an entity, null if it is not part of the scene.
    [[nodiscard]] ObjectId idOf(EntityId entity) const override;
    [[nodiscard]] const TypeRegistry& types() const { return *world.types(); }
    /// Returns all entities of the scene in file order. The list is rebuilt after entities are added, removed
    /// or reordered, so copy it before changing the document in a loop over it.
    [[nodiscard]] const std::vector<ObjectId>& objects() const;
    [[nodiscard]] std::size_t objectCount() const { return entities_.size(); }
    /// Returns the current boxes of all entities in `objects()`.
    [[nodiscard]] const SceneBoxes& boxes() const;
    /// Returns an entity's name to display: its Name, else its main component, else "Entity".
    [[nodiscard]] std::string nameOf(ObjectId id) const;

    // For commands.

    [[nodiscard]] ObjectId newId();
    [[nodiscard]] std::int32_t nextOrder() const;
    void remember(ObjectId id, EntityId entity) { entities_.set(id.value, entity), reordered(); }
    void forget(ObjectId id);
    /// Must be called after the order of entities in the file was changed.
    void reordered() { sorted_ = false, ++treeRevision; }
    /// Must be called after the world was filled by a loader: rebuilds the ids, and assigns new ones to
    /// entities without an id or with one already used.
    void reindex();
    /// Seeds the generator of new ids. The program seeds it from the clock, tests with a constant.
    void seedIds(std::uint64_t seed) { random_ = Random::seeded(seed); }

private:
    IdTable<EntityId> entities_;
    mutable std::vector<ObjectId> objects_;  // cache of objects(), valid while `sorted_`
    mutable bool sorted_ = false;
    mutable std::unique_ptr<SceneBoxes> boxes_;
    Random random_;
};

}  // namespace plumb::editor
