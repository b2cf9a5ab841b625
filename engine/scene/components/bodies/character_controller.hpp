#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Walks, rides, pushes and is pushed like a character of a game. Game code writes its velocity; it needs a
/// BoxCollider, a CircleCollider or a CapsuleCollider, and no RigidBody.
struct CharacterController {
    Vec2 velocity;                   ///< px/s, over the ground while it stands on one; upwards it jumps
    float gravityScale = 1.0f;       ///< ratio, of the scene's; 0 leaves falling to the game
    float steepest = 0.8901179f;     ///< rad: it slides down steeper ground
    float stepHeight = 0.0f;         ///< px: it walks up steps no higher than this
    float snap = 6.0f;               ///< px: ground this far under its feet is followed down
    float cornerCorrection = 0.0f;   ///< px: ceilings that its head misses by this little are passed
    float pushForce = 12800.0f;      ///< kg px/s^2, with which it pushes what is in its way
    float pushMass = 200.0f;         ///< kg: heavier bodies are walls to it
    float weight = 0.0f;             ///< kg, on what it stands on
    bool evenSpeed = true;           ///< as fast along x on every slope
    bool grounded = false;           ///< stands on something
    EntityId ground;                 ///< what it stands on
    Vec2 groundNormal{0.0f, -1.0f};  ///< of that
    bool hitWall = false;            ///< in the last tick
    bool hitCeiling = false;         ///< in the last tick

    static void describe(TypeBuilder<CharacterController>& type) {
        type.name("CharacterController")
            .doc(
                "Walks, rides and pushes like a character. Needs a box, circle or capsule; game code writes "
                "its velocity.");
        type.field<&CharacterController::velocity>("velocity").unit(Unit::PixelsPerSecond);
        type.field<&CharacterController::gravityScale>("gravityScale")
            .unit(Unit::Ratio)
            .range(-10.0f, 10.0f)
            .doc("0 leaves falling to the game.");
        type.field<&CharacterController::steepest>("steepest")
            .unit(Unit::Radians)
            .range(0.0f, 1.5f)
            .doc("It slides down steeper ground.");
        type.field<&CharacterController::stepHeight>("stepHeight")
            .unit(Unit::Pixels)
            .range(0.0f, 1000.0f)
            .doc("It walks up steps no higher than this.");
        type.field<&CharacterController::snap>("snap")
            .unit(Unit::Pixels)
            .range(0.0f, 1000.0f)
            .doc("Ground this far under its feet is followed down.");
        type.field<&CharacterController::cornerCorrection>("cornerCorrection")
            .unit(Unit::Pixels)
            .range(0.0f, 100.0f)
            .doc("Ceilings that its head misses by this little are passed.");
        type.field<&CharacterController::pushForce>("pushForce")
            .range(0.0f, 1e9f)
            .doc("kg px/s2, with which it pushes what is in its way.");
        type.field<&CharacterController::pushMass>("pushMass")
            .unit(Unit::Kilograms)
            .range(0.0f, 1e6f)
            .doc("Heavier bodies are walls to it.");
        type.field<&CharacterController::weight>("weight")
            .unit(Unit::Kilograms)
            .range(0.0f, 1e6f)
            .doc("On what it stands on.");
        type.field<&CharacterController::evenSpeed>("evenSpeed").doc("As fast along x on every slope.");
        type.field<&CharacterController::grounded>("grounded").transient();
        type.field<&CharacterController::ground>("ground").transient();
        type.field<&CharacterController::groundNormal>("groundNormal").transient();
        type.field<&CharacterController::hitWall>("hitWall").transient();
        type.field<&CharacterController::hitCeiling>("hitCeiling").transient();
    }
};

}  // namespace plumb
