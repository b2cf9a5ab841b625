#pragma once

#include "core/fixed_list.hpp"
#include "math/vec2.hpp"
#include "scene/collider_surface.hpp"

namespace plumb {

/// A line of ground without thickness, over whose corners nothing trips. It is solid on its left hand side,
/// seen along the way from point to point: drawn from left to right it is a floor.
struct ChainCollider : ColliderSurface {
    FixedList<Vec2, 64> points;  ///< px from the Transform
    bool loop = false;           ///< the last point leads to the first

    static void describe(TypeBuilder<ChainCollider>& type) {
        type.name("ChainCollider")
            .doc("A line of ground without thickness; drawn from left to right it is a floor.");
        type.field<&ChainCollider::points>("points").unit(Unit::Pixels).doc("From the Transform.");
        type.field<&ChainCollider::loop>("loop").doc("The last point leads to the first.");
        describeSurface(type);
    }
};

}  // namespace plumb
