#pragma once

#include "math/rect.hpp"
#include "math/vec2.hpp"

// Camera movement: pure functions on plain data with the same
// bits everywhere, so that cameras can be part of the simulation.
namespace plumb {

/// Moves the camera just far enough that the target lies in a box of `deadZone` px around it again.
Vec2 keptInDeadZone(Vec2 camera, Vec2 followed, Vec2 deadZone);

/// Covers 95 % of the distance in `seconds`, independent of
/// the tick length; all of it at once if `seconds` is 0.
Vec2 approached(Vec2 from, Vec2 to, float seconds, float dt);

/// Keeps a view of `size` world px inside `limits`; centered
/// if the limits are smaller. Empty limits have no effect.
Vec2 keptInLimits(Vec2 center, Vec2 size, const Rect& limits);

/// Offset of the view by a shake of `seconds`, `time` seconds after
/// its start: at most `strength` px along each axis, decaying to 0.
Vec2 shakeOffset(float strength, float seconds, float time);

}  // namespace plumb
