#pragma once

#include "math/vec2.hpp"
#include "scene/collider_surface.hpp"

namespace plumb {

/// The largest capsule in a box: half circles at both ends of the longer side. Glides over edges.
struct CapsuleCollider : ColliderSurface {
    float width = 16.0f;   ///< px
    float height = 32.0f;  ///< px
    Vec2 offset;           ///< px, from the Transform to the top-left corner of the box

    CapsuleCollider() = default;
    CapsuleCollider(float w, float h) : width{w}, height{h} {}

    static void describe(TypeBuilder<CapsuleCollider>& type) {
        type.name("CapsuleCollider").doc("A box whose shorter sides are half circles; glides over edges.");
        type.field<&CapsuleCollider::width>("width").unit(Unit::Pixels).range(0.0f, 1e6f);
        type.field<&CapsuleCollider::height>("height").unit(Unit::Pixels).range(0.0f, 1e6f);
        type.field<&CapsuleCollider::offset>("offset")
            .unit(Unit::Pixels)
            .doc("From the Transform to the top-left corner.");
        describeSurface(type);
    }
};

}  // namespace plumb
