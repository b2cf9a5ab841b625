#pragma once

#include "ecs/world.hpp"
#include "math/angle.hpp"
#include "math/vec2.hpp"
#include "scene/components/transform.hpp"

namespace plumb {

/// Where something is and how it is turned, without its past.
struct Pose {
    Vec2 position;           ///< px
    float rotation = 0.0f;   ///< rad, clockwise on screen
    Vec2 scale{1.0f, 1.0f};  ///< ratio

    friend bool operator==(const Pose&, const Pose&) = default;
};

/// Between the pose one tick ago (alpha 0) and now (alpha 1). Angles take the short way round.
Pose blended(const Transform& transform, float alpha);
inline Pose interpolated(const Transform& transform, float alpha) {
    if (alpha >= 1.0f) return {transform.position, transform.rotation, transform.scale};
    return blended(transform, alpha);
}

/// `child`, given in `parent`, as a pose of what `parent` is given in; and back.
inline Pose composed(const Pose& parent, const Pose& child) {
    return {parent.position + rotated(scaled(child.position, parent.scale), parent.rotation),
            parent.rotation + child.rotation, scaled(parent.scale, child.scale)};
}
Pose relativeTo(const Pose& parent, const Pose& child);

/// The entity's pose in the world: its own Transform inside those of its parents.
/// An entity without Transform takes its parent's.
Pose worldPose(const World& world, EntityId entity, float alpha = 1.0f);

/// Makes now the past of every Transform and of every camera's zoom, so that the tick that follows is drawn
/// from here.
void storePreviousTransforms(World& world);

}  // namespace plumb
