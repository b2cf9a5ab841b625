#pragma once

#include "physics/queries/query.hpp"

namespace plumb::physics {

/// Shape and abilities of a character.
struct CharacterDefinition {
    Geometry outline = box({0.4f, 0.9f});  ///< m, around its position: box, circle or capsule; never rotates
    Vec2 up{0.0f, -1.0f};                  ///< length 1: the direction away from the ground
    float steepest = 0.8901179f;           ///< rad (51 degrees): maximum slope of ground; steeper: it slides
    float stepHeight = 0.0f;               ///< m: maximum height of steps that it walks up
    float snap = 0.1f;                     ///< m: maximum drop of the ground that it follows while it walks
    float cornerCorrection = 0.0f;  ///< m: maximum sideways shift by which its head passes a ceiling corner
    /// True: the same speed along x on every slope. False: the same speed along the ground.
    bool evenSpeed = true;
    float gravityScale = 1.0f;  ///< ratio to the world's gravity; 0 leaves falling to the caller
    float pushForce = 200.0f;   ///< N: maximum force on bodies that it pushes
    float pushMass = 200.0f;    ///< kg: maximum mass of bodies that it pushes; heavier bodies act as walls
    float weight = 0.0f;        ///< kg: mass with which it weighs on the body that it stands on
    QueryFilter filter{};  ///< shapes that it collides with; set `except` if the character also has a body
    /// m: distance that it keeps from all shapes, so that it does not catch on seams. Must be larger than
    /// rounding errors and too small to be visible.
    float gap = 0.001f;
};

/// A shape that a character touches. The default, without a shape, stands for no contact.
struct CharacterTouch {
    ShapeId shape;
    BodyId body;
    Vec2 normal;          ///< length 1, towards the character
    WorldPosition point;  ///< m

    explicit operator bool() const { return static_cast<bool>(shape); }
};

/// The contacts of a character in a tick: result of CharacterController::update().
struct CharacterMotion {
    CharacterTouch ground;      ///< the ground that it stands on at the end of the tick
    CharacterTouch slope;       ///< a slope that is too steep to stand on
    CharacterTouch wall;        ///< a surface steeper than 84 degrees, or overhanging
    CharacterTouch ceiling;     ///< a surface above its head
    CharacterTouch squeezedBy;  ///< a shape that overlaps it while there is no free space to move to
    bool landed = false;        ///< true if it reached the ground in this tick
    bool leftGround = false;    ///< true if it jumped, walked off an edge, or the ground disappeared
};

}  // namespace plumb::physics
