#pragma once

#include <cstdint>

#include "reflect/type_builder.hpp"

namespace plumb {

/// Connects an entity to its scene file. Entities created by game code do not have it and are not saved.
struct SceneEntity {
    std::uint64_t id = 0;    ///< stable id, random and never reused: used by files, references and undo
    std::int32_t order = 0;  ///< index in the file; entities with equal values are sorted by id
    SceneId scene;           ///< the scene that the entity is saved with

    static void describe(TypeBuilder<SceneEntity>& type) {
        type.name("SceneEntity").doc("Connects the entity to its scene file; saved as the entity's \"id\".");
        type.field<&SceneEntity::id>("id").transient();
        type.field<&SceneEntity::order>("order").transient();
        type.field<&SceneEntity::scene>("scene").transient();
    }
};

}  // namespace plumb
