#pragma once

#include "math/vec2.hpp"

namespace plumb::editor {

class Workspace;

/// Handles a double click in the scene: selects the part of a prefab instance under the pointer; on a polygon
/// or chain collider, activates the shape tool, which moves its corners.
/// @param point  px, world: position of the pointer
/// @param reach  px, world: maximum distance at which an entity is still hit
void handleDoubleClick(Workspace& workspace, Vec2 point, float reach);

}  // namespace plumb::editor
