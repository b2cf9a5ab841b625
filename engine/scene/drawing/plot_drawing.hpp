#pragma once

#include <string>

#include "ecs/world.hpp"
#include "render/draw_list.hpp"
#include "scene/components/drawing/plot.hpp"

namespace plumb {

class LabelDrawing;

/// Returns a number as text with three significant digits: "0.0125", "12.5", "1250", "3e-7".
std::string roughNumber(float value);

/// Draws a plot: its curves, legend and scale. @param corner  px, top-left corner of the plot
void drawPlot(const World& world, EntityId entity, const Plot& plot, Vec2 corner, LabelDrawing& labels,
              DrawList& list);

}  // namespace plumb
