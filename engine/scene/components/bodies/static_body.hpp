#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Marks an entity whose colliders never move by themselves: ground, walls, platforms.
struct StaticBody {
    static void describe(TypeBuilder<StaticBody>& type) {
        type.name("StaticBody").doc("A body that never moves by itself; other bodies collide with it.");
    }
};

}  // namespace plumb
