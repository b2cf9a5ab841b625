#pragma once

#include <compare>
#include <cstdint>

#include "reflect/entity_id.hpp"

namespace plumb::editor {

/// The lasting id of an entity of the scene, as in its file. Commands and the selection hold these: an entity
/// that was deleted and brought back by undo has a new EntityId, but the same ObjectId.
struct ObjectId {
    std::uint64_t value = 0;

    explicit constexpr operator bool() const { return value != 0; }
    friend constexpr auto operator<=>(ObjectId, ObjectId) = default;
};

/// Tells which entity of a world an ObjectId is at the moment, and back.
class ObjectNames {
public:
    virtual ~ObjectNames() = default;
    /// Null when there is none.
    [[nodiscard]] virtual EntityId find(ObjectId id) const = 0;
    /// None for what is not part of a scene.
    [[nodiscard]] virtual ObjectId idOf(EntityId entity) const = 0;
};

}  // namespace plumb::editor
