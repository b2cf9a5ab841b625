#pragma once

#include "core/text_store.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// What people call the entity. Names need not be unique. Saved as the entity's own "name".
struct Name {
    TextId text;

    static void describe(TypeBuilder<Name>& type) {
        type.name("Name").doc("What people call the entity; need not be unique.");
        type.field<&Name::text>("text").doc("Shown in the scene tree and in messages.");
    }
};

}  // namespace plumb
