#pragma once

#include "math/vec2.hpp"
#include "scene/collider_surface.hpp"

namespace plumb {

/// A circle whose center is at position + offset.
struct CircleCollider : ColliderSurface {
    float radius = 16.0f;  ///< px
    Vec2 offset;           ///< px, from the Transform to the center

    CircleCollider() = default;
    explicit CircleCollider(float size) : radius{size} {}

    static void describe(TypeBuilder<CircleCollider>& type) {
        type.name("CircleCollider").doc("A circle collider; its center is at the Transform plus the offset.");
        type.field<&CircleCollider::radius>("radius").unit(Unit::Pixels).range(0.0f, 1e6f);
        type.field<&CircleCollider::offset>("offset")
            .unit(Unit::Pixels)
            .doc("Vector from the Transform to the center, px.");
        describeSurface(type);
    }
};

}  // namespace plumb
