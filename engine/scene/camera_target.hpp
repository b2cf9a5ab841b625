#pragma once

#include "ecs/world.hpp"
#include "scene/components/drawing/camera.hpp"

namespace plumb {

/// Where a camera would like to be (px, world): on what it follows and ahead of it; where it is when it
/// follows nothing. Its limits do not count yet.
Vec2 cameraTarget(const World& world, const Camera& camera, Vec2 center);

}  // namespace plumb
