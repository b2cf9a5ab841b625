#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// A collider that never moves by itself: ground, walls, platforms.
struct StaticBody {
    static void describe(TypeBuilder<StaticBody>& type) {
        type.name("StaticBody").doc("Never moves by itself; others collide with it.");
    }
};

}  // namespace plumb
