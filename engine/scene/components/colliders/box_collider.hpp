#pragma once

#include <type_traits>

#include "math/vec2.hpp"
#include "scene/collider_surface.hpp"

namespace plumb {

/// A box from position + offset to position + offset + size * scale, rotated with the entity.
struct BoxCollider : ColliderSurface {
    float width = 32.0f;    ///< px
    float height = 32.0f;   ///< px
    Vec2 offset;            ///< px, from the Transform to the top-left corner
    float rounding = 0.0f;  ///< px, radius of the rounded corners

    BoxCollider() = default;
    /// Accepts integers too: BoxCollider(32, 32).
    template <class Width, class Height>
    requires std::is_arithmetic_v<Width> && std::is_arithmetic_v<Height> BoxCollider(Width w, Height h)
        : width{static_cast<float>(w)}, height{static_cast<float>(h)} {}

    static void describe(TypeBuilder<BoxCollider>& type) {
        type.name("BoxCollider")
            .doc("A box collider; its top-left corner is at the Transform plus the offset.");
        type.field<&BoxCollider::width>("width").unit(Unit::Pixels).range(0.0f, 1e6f);
        type.field<&BoxCollider::height>("height").unit(Unit::Pixels).range(0.0f, 1e6f);
        type.field<&BoxCollider::offset>("offset")
            .unit(Unit::Pixels)
            .doc("Vector from the Transform to the top-left corner, px.");
        describeSurface(type);
        type.field<&BoxCollider::rounding>("rounding")
            .unit(Unit::Pixels)
            .range(0.0f, 1e6f)
            .doc("Radius of the rounded corners, px.");
    }
};

}  // namespace plumb
