#pragma once

#include <cstdint>

#include "reflect/type_builder.hpp"

namespace plumb {

/// Makes the tiles of the entity's TileLayer solid, with the collision shapes that the tileset defines.
struct TileCollider {
    std::uint32_t layers = 1;          ///< bits: collision layers of the tiles
    std::uint32_t mask = 0xffffffffu;  ///< bits: layers that the tiles collide with
    float friction = 0.1f;             ///< friction coefficient; 0 is frictionless
    float bounciness = 0.0f;           ///< restitution: ratio of the impact speed kept after a bounce

    static void describe(TypeBuilder<TileCollider>& type) {
        type.name("TileCollider")
            .doc(
                "Makes the tiles of the entity's TileLayer solid, with the collision shapes of their "
                "tileset.");
        type.field<&TileCollider::layers>("layers").layerBits().doc("Collision layers of the tiles.");
        type.field<&TileCollider::mask>("mask").layerBits().doc(
            "Collision layers that the tiles collide with.");
        type.field<&TileCollider::friction>("friction")
            .unit(Unit::Ratio)
            .range(0.0f, 10.0f)
            .doc("Friction coefficient of tiles without their own; 0 is frictionless.");
        type.field<&TileCollider::bounciness>("bounciness")
            .unit(Unit::Ratio)
            .range(0.0f, 1.0f)
            .doc("Restitution of tiles without their own: ratio of the impact speed kept after a bounce.");
    }
};

}  // namespace plumb
