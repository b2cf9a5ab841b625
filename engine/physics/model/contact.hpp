#pragma once

#include <cstdint>

#include "math/rot.hpp"
#include "physics/ids.hpp"

namespace plumb::physics {

/// Color of a constraint that is not solved at present (sleeping, new or not touching).
inline constexpr std::uint8_t kNoColour = 255;

/// A contact point relative to the centre of mass of body A and of body B, in the frame of that body.
struct ContactAnchors {
    Vec2 a;  ///< m
    Vec2 b;  ///< m
};

/// A contact of two shapes whose bounds overlap. Points and impulses are kept between steps: a step begins
/// with the impulses of the previous one (warm starting).
///
/// Laid out in rows of four floats, because the solver loads the same row of eight contacts at once
/// (lanes.hpp; ContactRow names the rows). Members that change while the bodies are at rest are in the first
/// four rows. In a contact with one point the second point has the separation kFarAway and never acts.
struct alignas(64) Contact {
    std::uint32_t shapeA = 0;  ///< the shape of the body that is not dynamic, else the lower index
    std::uint32_t shapeB = 0;
    std::uint32_t bodyA = 0;
    std::uint32_t bodyB = 0;

    std::uint16_t flags = 0;  ///< bits of ContactFlag
    std::uint8_t colour = kNoColour;
    std::uint8_t count = 0;  ///< number of points
    float bounciness = 0.0f;
    float rollingResistance = 0.0f;  ///< m: coefficient times radius
    float surfaceSpeed = 0.0f;       ///< m/s: surface speed of B relative to A along perpendicular(normal)

    Vec2 normal;  ///< unit length, in the world, from A to B
    float friction = 0.0f;
    float frictionImpulse = 0.0f;  ///< N s, in one substep, on B along perpendicular(normal)

    float separation0 = 0.0f;  ///< m along the normal, at the start of the step
    float impulse0 = 0.0f;     ///< N s, of the last substep; negative: of an impact, not for warm starting
    float separation1 = 0.0f;
    float impulse1 = 0.0f;

    Rot relativeRotation;         ///< B's rotation relative to A when the points were computed
    float rollingImpulse = 0.0f;  ///< N m s
    std::uint16_t ids[2] = {};    ///< indexed by point, see ManifoldPoint::id

    ContactAnchors anchors[2];

    float roundA = 0.0f;  ///< m, see Manifold::roundA
    float roundB = 0.0f;
    Vec2 normalInA;  ///< the normal in A's frame when the points were computed
};
static_assert(sizeof(Contact) == 128, "two cache lines: the narrow phase and the solver stream them");

/// Separation (m) of the unused second point of a contact with one point.
inline constexpr float kFarAway = 1.0e4f;

enum ContactFlag : std::uint16_t {
    kTouching = 1,   ///< the shapes touch: Began was reported, Ended not yet
    kTriggered = 2,  ///< one of the shapes is a trigger: no forces
    kBegan = 4,      ///< the shapes began to touch in this step
    kReports = 8,    ///< produces events
    kOneWayA = 16,   ///< shape A is one-way
    kOneWayB = 32,
    kDisabled = 64,         ///< exerts no forces in this step
    kFixedA = 128,          ///< body A is not dynamic
    kRound = 256,           ///< one shape is a circle: points are recomputed in each step
    kUnturned = 512,        ///< neither body can rotate: one point is sufficient
    kGone = 1024,           ///< to be removed: bounds separated, or filters no longer allow it
    kPassing = 2048,        ///< a one-way shape does not stop the other shape until they separate
    kAlongAxes = 4096,      ///< two boxes aligned with the world axes; neither body can rotate
    kInitialOverlap = 8192  ///< part of its overlap is hidden from the solver: initial_overlaps.cpp
};

/// Kind of a ContactEvent.
enum class ContactPhase : std::uint8_t { Began, Stayed, Ended };

struct ContactEvent {
    BodyId a;
    BodyId b;
    ShapeId shapeA;
    ShapeId shapeB;
    ContactPhase phase = ContactPhase::Began;
    bool isTrigger = false;
    Vec2 normal;  ///< unit length, in the world, from a to b
    Vec2 point;   ///< m, in the world; float, so it is accurate near the origin only
    /// N s along the normal, sum of both points over the step; 0 for Ended. A contact begins up to
    /// Settings::speculativeDistance before the shapes touch, so the impact of a body that approaches by less
    /// than that per step may be in the next step. For a surface (ShapeDefinition::surface): the sum over its
    /// contacts that have an event in this step.
    float impulse = 0.0f;
    float approachSpeed = 0.0f;  ///< m/s, for Began: relative speed along the normal before the impact
};

struct World;

/// Callbacks that filter or modify contacts. The stepping thread calls them in a fixed order. They must
/// return the same result for the same world, or steps are not reproducible, and must not change the world:
/// functions that would do so return an error.
struct ContactHooks {
    void* context = nullptr;  ///< first argument of the callbacks
    /// Returns whether shapes may collide. Called when bounds begin to overlap; if false, again after motion.
    bool (*filter)(void* context, const World& world, ShapeId a, ShapeId b) = nullptr;
    /// Returns whether this contact exerts forces. Called in every step while the shapes touch.
    bool (*preSolve)(void* context, const World& world, const Contact& contact) = nullptr;
    /// Return the friction and the bounciness of a contact, instead of those of ShapeDefinition. Called in
    /// every step while the shapes touch. Results out of range are clamped, NaN counts as 0.
    float (*friction)(void* context, const World& world, const Contact& contact) = nullptr;
    float (*bounciness)(void* context, const World& world, const Contact& contact) = nullptr;
};

}  // namespace plumb::physics
