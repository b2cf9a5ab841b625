#pragma once

#include "math/rect.hpp"
#include "math/vec2.hpp"

// Camera movement: pure functions with bit-identical results on
// all platforms, so that cameras can be part of the simulation.
namespace plumb {

/// Moves the camera by the minimum distance that brings the target into a box of `deadZone` px around it.
Vec2 keptInDeadZone(Vec2 camera, Vec2 followed, Vec2 deadZone);

/// Moves from `from` toward `to` exponentially: 95 % of the distance in `seconds`,
/// independent of the tick length `dt`. Returns `to` if `seconds` is 0.
Vec2 approached(Vec2 from, Vec2 to, float seconds, float dt);

/// Keeps a view of `size` world px inside `limits`; centered
/// if the limits are smaller. Empty limits have no effect.
Vec2 keptInLimits(Vec2 center, Vec2 size, const Rect& limits);

/// Returns the view's offset by a camera shake of length `seconds`, `time` seconds
/// after its start: at most `strength` px along each axis, decaying to 0.
Vec2 shakeOffset(float strength, float seconds, float time);

}  // namespace plumb
