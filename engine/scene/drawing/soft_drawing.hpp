#pragma once

#include "ecs/world.hpp"
#include "render/draw_list.hpp"

namespace plumb {

struct SceneView;

/// Adds ropes, cloth and jellies to `list`, interpolated between their last two ticks.
void drawSoftBodies(const World& world, const SceneView& how, DrawList& list);

}  // namespace plumb
