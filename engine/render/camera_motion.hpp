#pragma once

#include "math/rect.hpp"
#include "math/vec2.hpp"

// How a camera moves: plain functions of plain data, the same bits everywhere, so that cameras may live in
// the simulation.
namespace plumb {

/// Moves the camera just so far that what it follows lies in a box of `deadZone` px around it again.
Vec2 keptInDeadZone(Vec2 camera, Vec2 followed, Vec2 deadZone);

/// Comes closer by 95 % of the way in each `seconds`, whatever the length of a tick; at once when `seconds`
/// is 0.
Vec2 approached(Vec2 from, Vec2 to, float seconds, float dt);

/// Keeps a view of `size` world px inside `limits`; in the middle where the limits are smaller. Empty limits
/// hold nothing back.
Vec2 keptInLimits(Vec2 center, Vec2 size, const Rect& limits);

/// How far a shake of `seconds` moves the view, `time` seconds after it began: never more than `strength` px
/// along each axis, dying away to nothing.
Vec2 shakeOffset(float strength, float seconds, float time);

}  // namespace plumb
