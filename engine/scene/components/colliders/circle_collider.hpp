#pragma once

#include "math/vec2.hpp"
#include "scene/collider_surface.hpp"

namespace plumb {

/// A circle around position + offset.
struct CircleCollider : ColliderSurface {
    float radius = 16.0f;  ///< px
    Vec2 offset;           ///< px, from the Transform to the middle

    CircleCollider() = default;
    explicit CircleCollider(float size) : radius{size} {}

    static void describe(TypeBuilder<CircleCollider>& type) {
        type.name("CircleCollider").doc("A circle; its middle is at the Transform plus the offset.");
        type.field<&CircleCollider::radius>("radius").unit(Unit::Pixels).range(0.0f, 1e6f);
        type.field<&CircleCollider::offset>("offset")
            .unit(Unit::Pixels)
            .doc("From the Transform to the middle.");
        describeSurface(type);
    }
};

}  // namespace plumb
