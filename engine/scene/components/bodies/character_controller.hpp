#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Moves the entity as a game character: it walks, rides on platforms, pushes bodies and is pushed. Game code
/// writes `velocity`. Needs a BoxCollider, CircleCollider or CapsuleCollider, and no RigidBody.
struct CharacterController {
    Vec2 velocity;  ///< px/s, relative to the ground while grounded; an upward velocity makes it jump
    float gravityScale = 1.0f;    ///< ratio to the scene's gravity; 0: game code applies gravity
    float steepest = 0.8901179f;  ///< rad: maximum slope it can stand on; it slides down steeper ground
    float stepHeight = 0.0f;      ///< px: maximum height of steps it walks up
    float snap = 6.0f;  ///< px: maximum drop of the ground at which it stays on the ground while walking
    float cornerCorrection = 0.0f;  ///< px: maximum sideways shift past a ceiling corner that its head hits
    float pushForce = 12800.0f;     ///< kg px/s^2: maximum force on bodies it pushes
    float pushMass = 200.0f;        ///< kg: maximum mass of bodies it pushes; heavier ones are walls
    float weight = 0.0f;            ///< kg: mass with which it presses on the body it stands on
    bool evenSpeed = true;  ///< same horizontal speed on every slope; false: same speed along the slope
    bool grounded = false;  ///< stands on ground
    EntityId ground;        ///< the entity it stands on
    Vec2 groundNormal{0.0f, -1.0f};  ///< unit normal of the ground
    bool hitWall = false;            ///< touched a wall in the last tick
    bool hitCeiling = false;         ///< touched a ceiling in the last tick

    static void describe(TypeBuilder<CharacterController>& type) {
        type.name("CharacterController")
            .doc(
                "Moves the entity as a character that walks, rides and pushes. Needs a box, circle or "
                "capsule "
                "collider; game code writes its velocity.");
        type.field<&CharacterController::velocity>("velocity").unit(Unit::PixelsPerSecond);
        type.field<&CharacterController::gravityScale>("gravityScale")
            .unit(Unit::Ratio)
            .range(-10.0f, 10.0f)
            .doc("Ratio to the scene's gravity; 0: game code applies gravity.");
        type.field<&CharacterController::steepest>("steepest")
            .unit(Unit::Radians)
            .range(0.0f, 1.5f)
            .doc("Maximum slope it can stand on, degrees; it slides down steeper ground.");
        type.field<&CharacterController::stepHeight>("stepHeight")
            .unit(Unit::Pixels)
            .range(0.0f, 1000.0f)
            .doc("Maximum height of steps it walks up, px.");
        type.field<&CharacterController::snap>("snap")
            .unit(Unit::Pixels)
            .range(0.0f, 1000.0f)
            .doc("Maximum drop of the ground at which it stays on the ground while walking, px.");
        type.field<&CharacterController::cornerCorrection>("cornerCorrection")
            .unit(Unit::Pixels)
            .range(0.0f, 100.0f)
            .doc("Maximum sideways shift past a ceiling corner that its head hits, px.");
        type.field<&CharacterController::pushForce>("pushForce")
            .range(0.0f, 1e9f)
            .doc("Maximum force on bodies it pushes, kg px/s2.");
        type.field<&CharacterController::pushMass>("pushMass")
            .unit(Unit::Kilograms)
            .range(0.0f, 1e6f)
            .doc("Maximum mass of bodies it pushes, kg; heavier ones are walls.");
        type.field<&CharacterController::weight>("weight")
            .unit(Unit::Kilograms)
            .range(0.0f, 1e6f)
            .doc("Mass with which it presses on the body it stands on, kg.");
        type.field<&CharacterController::evenSpeed>("evenSpeed")
            .doc("The same horizontal speed on every slope; off: the same speed along the slope.");
        type.field<&CharacterController::grounded>("grounded").transient();
        type.field<&CharacterController::ground>("ground").transient();
        type.field<&CharacterController::groundNormal>("groundNormal").transient();
        type.field<&CharacterController::hitWall>("hitWall").transient();
        type.field<&CharacterController::hitCeiling>("hitCeiling").transient();
    }
};

}  // namespace plumb
