#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A platformer character controlled by input: runs, jumps, walks on slopes, rides on platforms and pushes
/// boxes. Needs a RigidBody and a BoxCollider.
struct PlayerController {
    float runSpeed = 180.0f;          ///< px/s, maximum speed of running
    float runAcceleration = 2000.0f;  ///< px/s2, for starting, reversing and stopping
    float overspeedBraking = 800.0f;  ///< px/s2, deceleration to runSpeed from a higher speed
    float airControl = 0.65f;         ///< ratio of the acceleration in the air to that on the ground
    float gravity = 1800.0f;          ///< px/s2, used instead of the world's gravity
    float fallSpeed = 320.0f;         ///< px/s, maximum falling speed
    float fastFallSpeed = 480.0f;     ///< px/s, maximum falling speed while down is held
    float jumpSpeed = 210.0f;         ///< px/s, initial upward speed of a jump
    float jumpBoost = 80.0f;          ///< px/s, horizontal speed added in the held direction at a jump
    int jumpHoldTicks = 12;         ///< ticks, maximum time for which holding the button keeps the jump speed
    int coyoteTicks = 6;            ///< ticks after walking off a ledge in which it can still jump
    int bufferTicks = 6;            ///< ticks for which a press in the air is kept until it can jump
    float apexSpeed = 80.0f;        ///< px/s: below this vertical speed gravity is halved while jump is held
    float cornerCorrection = 4.0f;  ///< px, maximum sideways shift past a corner that its head hits
    float steepest = 0.8727f;       ///< rad, maximum slope of ground; steeper ground is a wall
    float pushSpeed = 60.0f;        ///< px/s, speed of pushing boxes
    int facing = 1;                 ///< facing direction: 1 right, -1 left
    int coyote = 0;                 ///< remaining ticks of coyoteTicks
    int buffer = 0;                 ///< remaining ticks of bufferTicks
    int hold = 0;                   ///< remaining ticks of jumpHoldTicks
    int dropping = 0;               ///< remaining ticks of falling through one-way ground
    EntityId ground;                ///< the entity it stands on
    Vec2 groundNormal = {0.0f, -1.0f};  ///< unit normal of the ground
    Vec2 carry;                         ///< px/s, velocity of the ground; added to its own in a jump or fall

    static void describe(TypeBuilder<PlayerController>& type) {
        type.name("PlayerController")
            .doc(
                "A platformer character controlled by input: runs, jumps, walks on slopes, rides on "
                "platforms. "
                "Needs a RigidBody and a BoxCollider.");
        type.field<&PlayerController::runSpeed>("runSpeed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 10000.0f)
            .doc("Maximum speed of running, px/s.");
        type.field<&PlayerController::runAcceleration>("runAcceleration")
            .unit(Unit::PixelsPerSecondSquared)
            .range(0.0f, 100000.0f)
            .doc("Acceleration for starting, reversing and stopping, px/s2.");
        type.field<&PlayerController::overspeedBraking>("overspeedBraking")
            .unit(Unit::PixelsPerSecondSquared)
            .range(0.0f, 100000.0f)
            .doc("Deceleration to the run speed from a higher speed, px/s2.");
        type.field<&PlayerController::airControl>("airControl")
            .unit(Unit::Ratio)
            .range(0.0f, 2.0f)
            .doc("Ratio of the acceleration in the air to that on the ground.");
        type.field<&PlayerController::gravity>("gravity")
            .unit(Unit::PixelsPerSecondSquared)
            .range(0.0f, 100000.0f)
            .doc("Gravity of the character, px/s2, used instead of the world's gravity.");
        type.field<&PlayerController::fallSpeed>("fallSpeed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 10000.0f)
            .doc("Maximum falling speed, px/s.");
        type.field<&PlayerController::fastFallSpeed>("fastFallSpeed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 10000.0f)
            .doc("Maximum falling speed while down is held, px/s.");
        type.field<&PlayerController::jumpSpeed>("jumpSpeed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 10000.0f)
            .doc("Initial upward speed of a jump, px/s.");
        type.field<&PlayerController::jumpBoost>("jumpBoost")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 10000.0f)
            .doc("Horizontal speed added in the held direction at a jump, px/s.");
        type.field<&PlayerController::jumpHoldTicks>("jumpHoldTicks")
            .unit(Unit::Ticks)
            .range(0.0f, 600.0f)
            .doc("Maximum time for which holding the jump button keeps the jump speed, ticks.");
        type.field<&PlayerController::coyoteTicks>("coyoteTicks")
            .unit(Unit::Ticks)
            .range(0.0f, 600.0f)
            .doc("Time after walking off a ledge in which it can still jump, ticks.");
        type.field<&PlayerController::bufferTicks>("bufferTicks")
            .unit(Unit::Ticks)
            .range(0.0f, 600.0f)
            .doc("Time for which a jump press in the air is kept until it can jump, ticks.");
        type.field<&PlayerController::apexSpeed>("apexSpeed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 10000.0f)
            .doc("Vertical speed below which gravity is halved while jump is held, px/s.");
        type.field<&PlayerController::cornerCorrection>("cornerCorrection")
            .unit(Unit::Pixels)
            .range(0.0f, 32.0f)
            .doc("Maximum sideways shift past a ceiling corner that its head hits, px.");
        type.field<&PlayerController::steepest>("steepest")
            .unit(Unit::Radians)
            .range(0.0f, 1.5f)
            .doc("Maximum slope of ground, degrees; steeper ground is a wall.");
        type.field<&PlayerController::pushSpeed>("pushSpeed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 10000.0f)
            .doc("Speed of pushing boxes, px/s.");
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
