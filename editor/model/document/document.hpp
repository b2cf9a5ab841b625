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

/// A scene that is open for editing. All may read it; only commands change its world, so that undo
/// knows all. Stays at one address.
class Document final : public ObjectNames {
public:
    explicit Document(const TypeRegistry& types);
    ~Document() override;
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    World world;
    Selection selection;
    EntityView view;
    std::string scenePath;            ///< in the project, e.g. "scenes/cave.scene.json"; empty: none is open
    Vec2 picture{640.0f, 360.0f};     ///< px of the game's own picture
    SceneId scene;                    ///< what new entities belong to
    std::uint64_t sceneRevision = 0;  ///< counts changes; a panel that caches compares it
    std::uint64_t treeRevision = 0;  ///< counts changes of the entities, their parents, their order, by which
                                     ///< name and with which components

    /// The entity with this lasting id; null when there is none.
    [[nodiscard]] EntityId find(ObjectId id) const override;
    /// The lasting id of an entity; none for what is not part of the scene.
    [[nodiscard]] ObjectId idOf(EntityId entity) const override;
    [[nodiscard]] const TypeRegistry& types() const { return *world.types(); }
    /// All entities of the scene in the order of the file. Sorted once after entities came or went; valid
    /// until then, so take a copy before changing the document in a loop over it.
    [[nodiscard]] const std::vector<ObjectId>& objects() const;
    [[nodiscard]] std::size_t objectCount() const { return entities_.size(); }
    /// The box around each of `objects()`, as they are now.
    [[nodiscard]] const SceneBoxes& boxes() const;
    /// What people call it: its name, or its main component, or "Entity".
    [[nodiscard]] std::string nameOf(ObjectId id) const;

    // For commands.

    [[nodiscard]] ObjectId newId();
    [[nodiscard]] std::int32_t nextOrder() const;
    void remember(ObjectId id, EntityId entity) { entities_.set(id.value, entity), reordered(); }
    void forget(ObjectId id);
    /// After places in the file were changed.
    void reordered() { sorted_ = false, ++treeRevision; }
    /// After the world was filled from outside: gives an id to what has none, and finds all again.
    void reindex();
    /// The seed of new ids; the program takes one from the clock, tests keep theirs.
    void seedIds(std::uint64_t seed) { random_ = Random::seeded(seed); }

private:
    IdTable<EntityId> entities_;
    mutable std::vector<ObjectId> objects_;  // as they were when `sorted_` was set
    mutable bool sorted_ = false;
    mutable std::unique_ptr<SceneBoxes> boxes_;
    Random random_;
};

}  // namespace plumb::editor
