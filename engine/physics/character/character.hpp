#pragma once

#include "physics/queries/query.hpp"

namespace plumb::physics {

/// Shape and abilities of a character. Plain data.
struct CharacterDefinition {
    Geometry outline =
        box({0.4f, 0.9f});        ///< m, around its position: a box, a circle or a capsule; never rotates
    Vec2 up{0.0f, -1.0f};         ///< length 1: the direction away from the ground
    float steepest = 0.8901179f;  ///< rad (51 degrees): maximum slope of ground; it slides down steeper ones
    float stepHeight = 0.0f;      ///< m: maximum height of steps that it walks up
    float snap = 0.1f;            ///< m: maximum drop of the ground that it follows while it walks
    float cornerCorrection = 0.0f;  ///< m: maximum sideways shift by which its head passes a ceiling corner
    /// True: the same speed along x on every slope. False: the same speed along the ground.
    bool evenSpeed = true;
    float gravityScale = 1.0f;  ///< ratio to the world's gravity; 0 leaves falling to the caller
    float pushForce = 200.0f;   ///< N: maximum force on bodies that it pushes
    float pushMass = 200.0f;    ///< kg: maximum mass of bodies that it pushes; heavier ones are walls
    float weight = 0.0f;        ///< kg: weight on bodies that it stands on
    QueryFilter filter{};       ///< what it collides with; set `except` if it has a body of its own
    /// m: distance that it keeps from everything, so that it does not catch on seams. Larger than rounding
    /// errors, smaller than what is visible.
    float gap = 0.001f;
};

/// A contact of a character.
struct CharacterTouch {
    ShapeId shape;
    BodyId body;
    Vec2 normal;          ///< length 1, towards the character
    WorldPosition point;  ///< m

    explicit operator bool() const { return static_cast<bool>(shape); }
};

/// What a character touched in a tick. Touches that did not happen have no shape.
struct CharacterMotion {
    CharacterTouch ground;      ///< what it stands on, at the end
    CharacterTouch slope;       ///< too steep to stand on
    CharacterTouch wall;        ///< steeper than 84 degrees, or leaning over
    CharacterTouch ceiling;     ///< above its head
    CharacterTouch squeezedBy;  ///< overlaps it, without room to get out
    bool landed = false;        ///< came down on the ground in this tick
    bool leftGround = false;    ///< jumped, walked off, or the ground disappeared
};

}  // namespace plumb::physics
