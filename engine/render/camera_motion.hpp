#pragma once

#include "math/rect.hpp"
#include "math/vec2.hpp"

// Camera movement: pure functions with bit-identical results on
// all platforms, so that cameras can be part of the simulation.
namespace plumb {

/// Moves `camera` by the minimum distance after which `followed` is in a box of `deadZone` px around it.
Vec2 keptInDeadZone(Vec2 camera, Vec2 followed, Vec2 deadZone);

/// Moves from `from` toward `to` exponentially: 95 % of the distance in `seconds`,
/// independent of the tick length `dt`. Returns `to` if `seconds` is 0.
Vec2 approached(Vec2 from, Vec2 to, float seconds, float dt);

/// Moves the center of a view of `size` world px so that the view is inside `limits`,
/// or centered on limits that are smaller than the view. Empty limits have no effect.
Vec2 keptInLimits(Vec2 center, Vec2 size, const Rect& limits);

/// Returns the view's offset by a camera shake of length `seconds`, `time` seconds
/// after its start: at most `strength` px along each axis, decaying to 0.
Vec2 shakeOffset(float strength, float seconds, float time);

}  // namespace plumb
