#pragma once

#include <cstdint>

#include "reflect/type_builder.hpp"

namespace plumb {

/// Ties an entity to the scene file it came from. Entities that game code makes have none and are not saved.
struct SceneEntity {
    std::uint64_t id = 0;    ///< random and never reused: what files, references and undo call the entity
    std::int32_t order = 0;  ///< place in the file; equal places are sorted by id
    SceneId scene;

    static void describe(TypeBuilder<SceneEntity>& type) {
        type.name("SceneEntity").doc("Ties the entity to its scene file; written as the entity's \"id\".");
        type.field<&SceneEntity::id>("id").transient();
        type.field<&SceneEntity::order>("order").transient();
        type.field<&SceneEntity::scene>("scene").transient();
    }
};

}  // namespace plumb
