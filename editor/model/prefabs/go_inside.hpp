#pragma once

#include "math/vec2.hpp"

namespace plumb::editor {

class Workspace;

/// A double click in the scene: to the part of an instance under the mouse, or to the corners of an outline.
/// @param point  px, world
/// @param reach  px, world: how far beside a thing still hits it
void goInside(Workspace& workspace, Vec2 point, float reach);

}  // namespace plumb::editor
