#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Marks a body that a character controller moves by sweeping it through the solid world. The physics step
/// does not write its Transform or velocity; dynamic bodies are pushed by it.
struct CharacterBody {
    static void describe(TypeBuilder<CharacterBody>& type) {
        type.name("CharacterBody")
            .doc("Marks a body that a controller moves instead of forces; it pushes dynamic bodies.");
    }
};

}  // namespace plumb
