#pragma once

#include "ecs/world.hpp"
#include "math/rect.hpp"
#include "scene/components/drawing/label.hpp"

namespace plumb {

/// About where the text of a label is (px, from its Transform): what is exact enough to point at, without its
/// font.
AABB roughTextBox(const World& world, const Label& label);

}  // namespace plumb
