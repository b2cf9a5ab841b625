#pragma once

#include "physics/queries/query.hpp"

namespace plumb::physics {

/// What a character is like, and what it can do. Plain data.
struct CharacterDefinition {
    Geometry outline =
        box({0.4f, 0.9f});          ///< m, around its position: a box, a circle or a capsule; never turns
    Vec2 up{0.0f, -1.0f};           ///< length 1: against what it calls down
    float steepest = 0.8901179f;    ///< rad (51 degrees): it slides down ground that is steeper
    float stepHeight = 0.0f;        ///< m: it walks up steps no higher than this
    float snap = 0.1f;              ///< m: while it walks, ground this far under its feet is followed down
    float cornerCorrection = 0.0f;  ///< m: corners of ceilings that its head misses by this little are passed
    /// As fast along x on every slope; if not, as fast along the ground.
    bool evenSpeed = true;
    float gravityScale = 1.0f;  ///< ratio, of the world's; 0 leaves falling to its owner
    float pushForce = 200.0f;   ///< N: with what it pushes bodies that are in its way
    float pushMass = 200.0f;    ///< kg: heavier bodies are walls to it
    float weight = 0.0f;        ///< kg: how it weighs on bodies that it stands on
    QueryFilter filter{};       ///< whom it meets; `except` a body of its own, if it has one
    /// m: what it keeps away from everything, so that it never trips over seams. Larger than what is lost
    /// by rounding, smaller than what is seen.
    float gap = 0.001f;
};

/// What a character touches.
struct CharacterTouch {
    ShapeId shape;
    BodyId body;
    Vec2 normal;  ///< length 1, towards the character
    Place point;  ///< m

    explicit operator bool() const { return static_cast<bool>(shape); }
};

/// What it met on its way. What it did not meet names nobody.
struct CharacterMotion {
    CharacterTouch ground;      ///< what it stands on, at the end
    CharacterTouch slope;       ///< too steep to stand on
    CharacterTouch wall;        ///< steeper than 84 degrees, or leaning over
    CharacterTouch ceiling;     ///< over its head
    CharacterTouch squeezedBy;  ///< what is inside of it, without room to get out
    bool landed = false;        ///< came down on the ground
    bool leftGround = false;    ///< jumped, walked off, or the ground went away
};

}  // namespace plumb::physics
