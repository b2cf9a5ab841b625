#pragma once

#include "ecs/world.hpp"
#include "math/rect.hpp"
#include "scene/components/drawing/label.hpp"

namespace plumb {

/// Estimates the bounds of a label's text (px, from its
/// Transform) without its font. Accurate enough for picking.
AABB roughTextBox(const World& world, const Label& label);

}  // namespace plumb
