#pragma once

#include <utility>

#include "ecs/world.hpp"
#include "gameplay/game_functions.hpp"
#include "input/input_frame.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/transform.hpp"

namespace plumb {

/// True if the ball of the scene "pinball" is in the lane of the plunger.
inline bool isInLane(Vec2 ball) { return ball.x > 826.0f && ball.y > 250.0f; }

/// Plays the scene "pinball" in a simple way: launches the ball, each time a little harder or less hard, and
/// moves a flipper when the ball comes near it.
inline InputFrame pinballHands(World& world) {
    constexpr float kSlow = 150.0f;           // px/s
    constexpr std::uint64_t kPullEvery = 91;  // ticks
    constexpr std::uint64_t kPull = 40;       // ticks, without what varies
    const EntityId ball = findEntity(world, "ball").id();
    const Vec2 place = std::as_const(world).get<Transform>(ball).position;
    const Vec2 velocity = std::as_const(world).get<RigidBody>(ball).velocity;
    const std::uint64_t pull = kPull + world.tick / kPullEvery * 7 % 20;
    const bool isNear = place.y > 570.0f && place.y < 650.0f && velocity.y > -50.0f;
    InputFrame frame;
    frame.set(Key::Space, isInLane(place) && length(velocity) < kSlow && world.tick % kPullEvery < pull);
    frame.set(Key::Left, isNear && place.x > 530.0f && place.x < 612.0f);
    frame.set(Key::Right, isNear && place.x > 628.0f && place.x < 710.0f);
    return frame;
}

}  // namespace plumb
