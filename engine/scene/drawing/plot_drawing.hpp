#pragma once

#include <string>

#include "ecs/world.hpp"
#include "render/draw_list.hpp"
#include "scene/components/drawing/plot.hpp"

namespace plumb {

class LabelDrawing;

/// Three digits: "0.0125", "12.5", "1250", "3e-7".
std::string roughNumber(float value);

/// Draws the curves of a plot, what they stand for and its scale. @param corner  px: its top left
void drawPlot(const World& world, EntityId entity, const Plot& plot, Vec2 corner, LabelDrawing& labels,
              DrawList& list);

}  // namespace plumb
