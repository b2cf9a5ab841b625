#pragma once

#include <cstdint>

#include "reflect/type_builder.hpp"

namespace plumb {

/// Makes the tiles of the entity's TileLayer solid, each by the collision that its tileset gives it.
struct TileCollider {
    std::uint32_t layers = 1;          ///< bits: what these tiles are
    std::uint32_t mask = 0xffffffffu;  ///< bits: what they collide with
    float friction = 0.1f;             ///< 0 is ice
    float bounciness = 0.0f;           ///< ratio of the speed that comes back

    static void describe(TypeBuilder<TileCollider>& type) {
        type.name("TileCollider")
            .doc("Makes the tiles of the entity's TileLayer solid, as their tileset says.");
        type.field<&TileCollider::layers>("layers").layerBits().doc("What these tiles are.");
        type.field<&TileCollider::mask>("mask").layerBits().doc("What they collide with.");
        type.field<&TileCollider::friction>("friction").unit(Unit::Ratio).range(0.0f, 10.0f).doc("0 is ice.");
        type.field<&TileCollider::bounciness>("bounciness")
            .unit(Unit::Ratio)
            .range(0.0f, 1.0f)
            .doc("Part of the speed that comes back.");
    }
};

}  // namespace plumb
