#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A platformer character: runs, jumps, rides and climbs. Needs a RigidBody and a BoxCollider.
struct PlayerController {
    float runSpeed = 180.0f;            ///< px/s, top speed on the ground
    float runAcceleration = 2000.0f;    ///< px/s2, how fast it gets there, turns and stops
    float overspeedBraking = 800.0f;    ///< px/s2, how fast more than the top speed is lost
    float airControl = 0.65f;           ///< ratio, part of the acceleration that is left in the air
    float gravity = 1800.0f;            ///< px/s2, its own, whatever the world has
    float fallSpeed = 320.0f;           ///< px/s, top speed downwards
    float fastFallSpeed = 480.0f;       ///< px/s, the same while down is held
    float jumpSpeed = 210.0f;           ///< px/s, upwards at the start of a jump
    float jumpBoost = 80.0f;            ///< px/s, added in the direction held when it jumps
    int jumpHoldTicks = 12;             ///< ticks, how long holding the button keeps the jump speed
    int coyoteTicks = 6;                ///< ticks, after leaving an edge it can still jump
    int bufferTicks = 6;                ///< ticks, a press before landing still jumps
    float apexSpeed = 80.0f;            ///< px/s, slower than this, with the button held, gravity is halved
    float cornerCorrection = 4.0f;      ///< px, a head that hits a corner by this little slides around it
    float steepest = 0.8727f;           ///< rad, steeper ground is a wall
    float pushSpeed = 60.0f;            ///< px/s, how fast it pushes loose boxes
    int facing = 1;                     ///< 1 right, -1 left
    int coyote = 0;                     ///< ticks, left of coyoteTicks
    int buffer = 0;                     ///< ticks, left of bufferTicks
    int hold = 0;                       ///< ticks, left of jumpHoldTicks
    int dropping = 0;                   ///< ticks, left of falling through one-way ground
    EntityId ground;                    ///< what it stands on
    Vec2 groundNormal = {0.0f, -1.0f};  ///< of that
    Vec2 carry;                         ///< px/s, velocity of that, kept when it leaves

    static void describe(TypeBuilder<PlayerController>& type) {
        type.name("PlayerController")
            .doc(
                "A platformer character: runs, jumps, rides and climbs. Needs a RigidBody and a "
                "BoxCollider.");
        type.field<&PlayerController::runSpeed>("runSpeed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 10000.0f)
            .doc("Top speed on the ground.");
        type.field<&PlayerController::runAcceleration>("runAcceleration")
            .unit(Unit::PixelsPerSecondSquared)
            .range(0.0f, 100000.0f)
            .doc("How fast it gets there, turns and stops.");
        type.field<&PlayerController::overspeedBraking>("overspeedBraking")
            .unit(Unit::PixelsPerSecondSquared)
            .range(0.0f, 100000.0f)
            .doc("How fast more than the top speed is lost.");
        type.field<&PlayerController::airControl>("airControl")
            .unit(Unit::Ratio)
            .range(0.0f, 2.0f)
            .doc("Part of the acceleration that is left in the air.");
        type.field<&PlayerController::gravity>("gravity")
            .unit(Unit::PixelsPerSecondSquared)
            .range(0.0f, 100000.0f)
            .doc("Its own, whatever the world has.");
        type.field<&PlayerController::fallSpeed>("fallSpeed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 10000.0f)
            .doc("Top speed downwards.");
        type.field<&PlayerController::fastFallSpeed>("fastFallSpeed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 10000.0f)
            .doc("The same while down is held.");
        type.field<&PlayerController::jumpSpeed>("jumpSpeed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 10000.0f)
            .doc("Upwards at the start of a jump.");
        type.field<&PlayerController::jumpBoost>("jumpBoost")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 10000.0f)
            .doc("Added in the direction held when it jumps.");
        type.field<&PlayerController::jumpHoldTicks>("jumpHoldTicks")
            .unit(Unit::Ticks)
            .range(0.0f, 600.0f)
            .doc("How long holding the button keeps the jump speed.");
        type.field<&PlayerController::coyoteTicks>("coyoteTicks")
            .unit(Unit::Ticks)
            .range(0.0f, 600.0f)
            .doc("After leaving an edge it can still jump.");
        type.field<&PlayerController::bufferTicks>("bufferTicks")
            .unit(Unit::Ticks)
            .range(0.0f, 600.0f)
            .doc("A press before landing still jumps.");
        type.field<&PlayerController::apexSpeed>("apexSpeed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 10000.0f)
            .doc("Slower than this, with the button held, gravity is halved.");
        type.field<&PlayerController::cornerCorrection>("cornerCorrection")
            .unit(Unit::Pixels)
            .range(0.0f, 32.0f)
            .doc("A head that hits a corner by this little slides around it.");
        type.field<&PlayerController::steepest>("steepest")
            .unit(Unit::Radians)
            .range(0.0f, 1.5f)
            .doc("Steeper ground is a wall.");
        type.field<&PlayerController::pushSpeed>("pushSpeed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 10000.0f)
            .doc("How fast it pushes loose boxes.");
        type.field<&PlayerController::facing>("facing").transient();
        type.field<&PlayerController::coyote>("coyote").unit(Unit::Ticks).transient();
        type.field<&PlayerController::buffer>("buffer").unit(Unit::Ticks).transient();
        type.field<&PlayerController::hold>("hold").unit(Unit::Ticks).transient();
        type.field<&PlayerController::dropping>("dropping").unit(Unit::Ticks).transient();
        type.field<&PlayerController::ground>("ground").transient();
        type.field<&PlayerController::groundNormal>("groundNormal").transient();
        type.field<&PlayerController::carry>("carry").unit(Unit::PixelsPerSecond).transient();
    }
};

}  // namespace plumb
