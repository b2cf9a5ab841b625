#pragma once

#include "core/text_store.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// An action that shows the entity and hides it again.
struct ToggleKey {
    TextId action;  ///< one of project.json

    static void describe(TypeBuilder<ToggleKey>& type) {
        type.name("ToggleKey").doc("An action that shows the entity and hides it again.");
        type.field<&ToggleKey::action>("action").doc("One of project.json.");
    }
};

}  // namespace plumb
