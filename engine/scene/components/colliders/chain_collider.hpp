#pragma once

#include "core/fixed_list.hpp"
#include "math/vec2.hpp"
#include "scene/collider_surface.hpp"

namespace plumb {

/// A chain of line segments without thickness, for smooth ground: bodies do not catch on its corners. It is
/// solid on the left of the direction from point to point: points from left to right make a floor.
struct ChainCollider : ColliderSurface {
    FixedList<Vec2, 64> points;  ///< px from the Transform, in order
    bool loop = false;           ///< the last point is connected to the first

    static void describe(TypeBuilder<ChainCollider>& type) {
        type.name("ChainCollider")
            .doc("A chain of line segments for smooth ground; points from left to right make a floor.");
        type.field<&ChainCollider::points>("points")
            .unit(Unit::Pixels)
            .doc("Points of the chain, px from the Transform.");
        type.field<&ChainCollider::loop>("loop").doc("Connects the last point to the first.");
        describeSurface(type);
    }
};

}  // namespace plumb
