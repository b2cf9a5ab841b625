#pragma once

#include "core/fixed_list.hpp"
#include "math/vec2.hpp"
#include "scene/collider_surface.hpp"

namespace plumb {

/// An outline of corners, which may bend inwards; it is cut into convex pieces then.
struct PolygonCollider : ColliderSurface {
    FixedList<Vec2, 64> points;  ///< px from the Transform, in order, either way round
    Vec2 offset;                 ///< px, added to all points
    float rounding = 0.0f;       ///< px by which it is larger on all sides, with round corners

    static void describe(TypeBuilder<PolygonCollider>& type) {
        type.name("PolygonCollider").doc("An outline of corners; it may bend inwards.");
        type.field<&PolygonCollider::points>("points")
            .unit(Unit::Pixels)
            .doc("From the Transform, in order, either way round.");
        type.field<&PolygonCollider::offset>("offset").unit(Unit::Pixels).doc("Added to all points.");
        describeSurface(type);
        type.field<&PolygonCollider::rounding>("rounding")
            .unit(Unit::Pixels)
            .range(0.0f, 1e6f)
            .doc("How much larger it is on all sides, with round corners.");
    }
};

}  // namespace plumb
