#pragma once

#include "ecs/world.hpp"
#include "scene/components/drawing/camera.hpp"

namespace plumb {

/// Returns the position that a camera moves towards (px, world): the followed entity plus offset and
/// look-ahead, or `center` if it follows no entity. Does not apply the camera's limits.
Vec2 cameraTarget(const World& world, const Camera& camera, Vec2 center);

}  // namespace plumb
