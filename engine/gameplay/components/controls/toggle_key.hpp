#pragma once

#include "core/text_store.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// An input action that toggles the visibility of the entity.
struct ToggleKey {
    TextId action;  ///< name of the input action (project.json)

    static void describe(TypeBuilder<ToggleKey>& type) {
        type.name("ToggleKey").doc("An input action that toggles the visibility of the entity.");
        type.field<&ToggleKey::action>("action").doc("Input action, by its name in project.json.");
    }
};

}  // namespace plumb
