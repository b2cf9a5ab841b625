#pragma once

#include <cstdint>

#include "reflect/type_builder.hpp"

namespace plumb {

/// On the first entity of a prefab instance. Saved as the entity's "prefab"; what equals the prefab is not
/// saved.
struct PrefabInstance {
    PrefabId prefab;

    static void describe(TypeBuilder<PrefabInstance>& type) {
        type.name("PrefabInstance").doc("This entity and its parts come from a prefab.");
        type.field<&PrefabInstance::prefab>("prefab").transient();
    }
};

/// On every other entity that a prefab instance made.
struct PrefabPart {
    std::uint64_t instance = 0;  ///< stable id of the instance's first entity
    std::uint64_t part = 0;      ///< id of this entity inside the prefab

    static void describe(TypeBuilder<PrefabPart>& type) {
        type.name("PrefabPart").doc("This entity was made by the prefab of another one.");
        type.field<&PrefabPart::instance>("instance").transient();
        type.field<&PrefabPart::part>("part").transient();
    }
};

}  // namespace plumb
