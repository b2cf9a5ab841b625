#pragma once

#include "core/text_store.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Display name of the entity; not necessarily unique. Saved as the entity's "name" in the scene file.
struct Name {
    TextId text;

    static void describe(TypeBuilder<Name>& type) {
        type.name("Name").doc("Display name of the entity; not necessarily unique.");
        type.field<&Name::text>("text").doc("Name shown in the scene tree and in messages.");
    }
};

}  // namespace plumb
