#pragma once

#include "ecs/world.hpp"
#include "render/draw_list.hpp"

namespace plumb {

class LabelDrawing;
struct SceneView;

/// Adds to `list`: the outlines of ghosts, the sliders and the plots, with their texts.
void drawLab(const World& world, const SceneView& how, LabelDrawing& labels, DrawList& list);

}  // namespace plumb
