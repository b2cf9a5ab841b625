#pragma once

#include "math/vec2.hpp"
#include "scene/collider_surface.hpp"

namespace plumb {

/// The largest capsule that fits in a box of this size: half circles
/// at both ends of the longer side. It does not catch on edges.
struct CapsuleCollider : ColliderSurface {
    float width = 16.0f;   ///< px, of the box
    float height = 32.0f;  ///< px, of the box
    Vec2 offset;           ///< px, from the Transform to the top-left corner of the box

    CapsuleCollider() = default;
    CapsuleCollider(float w, float h) : width{w}, height{h} {}

    static void describe(TypeBuilder<CapsuleCollider>& type) {
        type.name("CapsuleCollider")
            .doc(
                "A capsule collider: a box whose shorter sides are half circles. It does not catch on "
                "edges.");
        type.field<&CapsuleCollider::width>("width").unit(Unit::Pixels).range(0.0f, 1e6f);
        type.field<&CapsuleCollider::height>("height").unit(Unit::Pixels).range(0.0f, 1e6f);
        type.field<&CapsuleCollider::offset>("offset")
            .unit(Unit::Pixels)
            .doc("Vector from the Transform to the top-left corner of the box around it, px.");
        describeSurface(type);
    }
};

}  // namespace plumb
