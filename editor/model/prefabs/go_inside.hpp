#pragma once

#include "math/vec2.hpp"

namespace plumb::editor {

class Workspace;

/// Handles a double click in the scene: selects the part of a prefab instance under the pointer, or activates
/// the shape tool for the corners of a polygon or chain.
/// @param point  px, world: position of the pointer
/// @param reach  px, world: maximum distance at which an entity is still hit
void handleDoubleClick(Workspace& workspace, Vec2 point, float reach);

}  // namespace plumb::editor
