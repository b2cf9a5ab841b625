#pragma once

#include "core/fixed_list.hpp"
#include "math/vec2.hpp"
#include "scene/collider_surface.hpp"

namespace plumb {

/// A polygon; a concave one is decomposed into convex pieces.
struct PolygonCollider : ColliderSurface {
    FixedList<Vec2, 64> points;  ///< px from the Transform, in order, clockwise or counterclockwise
    Vec2 offset;                 ///< px, added to all points
    float rounding = 0.0f;       ///< px: radius by which the polygon grows on all sides, with round corners

    static void describe(TypeBuilder<PolygonCollider>& type) {
        type.name("PolygonCollider").doc("A polygon collider; it may be concave.");
        type.field<&PolygonCollider::points>("points")
            .unit(Unit::Pixels)
            .doc("Corners in order, px from the Transform, clockwise or counterclockwise.");
        type.field<&PolygonCollider::offset>("offset")
            .unit(Unit::Pixels)
            .doc("Offset added to all points, px.");
        describeSurface(type);
        type.field<&PolygonCollider::rounding>("rounding")
            .unit(Unit::Pixels)
            .range(0.0f, 1e6f)
            .doc("Radius by which the polygon grows on all sides, with round corners, px.");
    }
};

}  // namespace plumb
