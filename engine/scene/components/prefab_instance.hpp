#pragma once

#include <cstdint>

#include "reflect/type_builder.hpp"

namespace plumb {

/// Marks the root entity of a prefab instance. Saved as the entity's
/// "prefab"; only values that differ from the prefab are saved.
struct PrefabInstance {
    PrefabId prefab;

    static void describe(TypeBuilder<PrefabInstance>& type) {
        type.name("PrefabInstance").doc("Marks the root entity of a prefab instance.");
        type.field<&PrefabInstance::prefab>("prefab").transient();
    }
};

/// Marks an entity of a prefab instance that is not its root.
struct PrefabPart {
    std::uint64_t instance = 0;  ///< stable id of the instance's root entity
    std::uint64_t part = 0;      ///< id of this entity inside the prefab

    static void describe(TypeBuilder<PrefabPart>& type) {
        type.name("PrefabPart").doc("Marks an entity of a prefab instance that is not its root.");
        type.field<&PrefabPart::instance>("instance").transient();
        type.field<&PrefabPart::part>("part").transient();
    }
};

}  // namespace plumb
