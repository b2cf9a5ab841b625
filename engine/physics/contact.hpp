#pragma once

#include <cstdint>

#include "math/rot.hpp"
#include "physics/ids.hpp"

namespace plumb::physics {

/// One place where two bodies touch. Anchors are from each body's centre of mass, in its own frame.
struct ContactPoint {
    Vec2 anchorA;             ///< m
    Vec2 anchorB;             ///< m
    float separation = 0.0f;  ///< m along the normal, at the start of the step
    float impulse = 0.0f;     ///< N s that one substep of the last step needed to keep them apart
};

/// Two shapes whose bounds overlap. Points and impulses live as long as it does: what was learned in one
/// step starts the next (warm starting).
struct Contact {
    std::uint32_t shapeA = 0;  ///< of two shapes, A is that of a body that cannot be pushed, or the lower index
    std::uint32_t shapeB = 0;
    std::uint32_t bodyA = 0;
    std::uint32_t bodyB = 0;
    std::uint16_t flags = 0;   ///< bits of ContactFlag
    std::uint8_t colour = 0;   ///< which group of independent constraints; kNoColour while it does not push
    std::uint8_t count = 0;    ///< of points
    float friction = 0.0f;
    float bounciness = 0.0f;
    float rollingResistance = 0.0f;  ///< m
    Vec2 normal;                     ///< in A's frame, from A to B
    Rot turn;                        ///< B's rotation seen from A when the points were found
    ContactPoint points[2];
    float frictionImpulse = 0.0f;  ///< N s, of one substep, along perpendicular(normal)
    float rollingImpulse = 0.0f;   ///< N m s
    float roundA = 0.0f;           ///< m, see Manifold
    float roundB = 0.0f;
    std::uint16_t ids[2] = {};     ///< of the points
    float surfaceSpeed = 0.0f;     ///< m/s of B's surface over A's along perpendicular(normal)
};
static_assert(sizeof(Contact) == 128, "two cache lines: the narrow phase and the solver stream them");

enum ContactFlag : std::uint16_t {
    kTouching = 1,      ///< the shapes touch: has begun and not ended
    kTriggered = 2,     ///< one of the shapes is a trigger: reports, does not push
    kBegan = 4,         ///< in this step
    kReports = 8,       ///< makes events
    kOneWayA = 16,      ///< shape A is one-way
    kOneWayB = 32,
    kDisabled = 64,     ///< does not push in this step
    kFixedA = 128,      ///< body A cannot be pushed
    kRound = 256,       ///< a circle takes part: points are found anew in each step
    kHasSurface = 512   ///< a shape has a surface speed
};

inline constexpr std::uint8_t kNoColour = 255;

/// What happened between two shapes in a step.
enum class ContactPhase : std::uint8_t { Began, Stayed, Ended };

struct ContactEvent {
    BodyId a;
    BodyId b;
    ShapeId shapeA;
    ShapeId shapeB;
    ContactPhase phase = ContactPhase::Began;
    bool isTrigger = false;
    Vec2 normal;           ///< world, from a to b
    Vec2 point;            ///< m, world, near enough to the origin to be float
    float impulse = 0.0f;  ///< N s over the whole step, along the normal
};

}  // namespace plumb::physics
