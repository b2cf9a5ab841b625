#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Marks a body that a controller moves itself, step by step through the solid world. Physics leaves its
/// Transform and velocity alone, and lets it push what is loose.
struct CharacterBody {
    static void describe(TypeBuilder<CharacterBody>& type) {
        type.name("CharacterBody").doc("Moved by a controller, not by forces; pushes what is loose.");
    }
};

}  // namespace plumb
