#pragma once

#include <compare>
#include <cstdint>

#include "reflect/entity_id.hpp"

namespace plumb::editor {

/// Persistent id of an entity, as stored in the scene's file. Commands and the selection use it because an
/// entity that undo recreates has a new EntityId but the same ObjectId.
struct ObjectId {
    std::uint64_t value = 0;

    explicit constexpr operator bool() const { return value != 0; }
    friend constexpr auto operator<=>(ObjectId, ObjectId) = default;
};

/// Maps ObjectIds to the present entities of a world and back.
class ObjectNames {
public:
    virtual ~ObjectNames() = default;
    /// Returns the entity with this ObjectId, null if there is none.
    [[nodiscard]] virtual EntityId find(ObjectId id) const = 0;
    /// Returns the ObjectId of an entity, null if it is not part of a scene.
    [[nodiscard]] virtual ObjectId idOf(EntityId entity) const = 0;
};

}  // namespace plumb::editor
