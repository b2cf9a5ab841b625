#pragma once

#include <cstdint>

#include "math/rot.hpp"
#include "physics/ids.hpp"

namespace plumb::physics {

/// Colour of a constraint that the solver does not handle at present.
inline constexpr std::uint8_t kNoColour = 255;

/// The point at which two bodies touch: relative to each centre of mass, in each body's frame.
struct ContactAnchors {
    Vec2 a;  ///< m
    Vec2 b;  ///< m
};

/// Two shapes whose bounds overlap. Points and impulses live as long as the contact does: the impulses of one
/// step start the next (warm starting).
///
/// Laid out in rows of four floats, because the solver loads the same row of eight contacts at once
/// (lanes.hpp; ContactRow names the rows). The members that change while the contact rests are in the first
/// four rows. A contact with one point has its second point at kFarAway, where it never acts.
struct alignas(64) Contact {
    std::uint32_t shapeA = 0;  ///< A is of the body that is not dynamic, else the lower index
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
    float frictionImpulse = 0.0f;  ///< N s, of one substep, on B along perpendicular(normal)

    float separation0 = 0.0f;  ///< m along the normal, at the start of the step
    float impulse0 = 0.0f;  ///< N s, of the last substep; below 0: an impact that is over, negated so that it
                            ///< does not start the next step
    float separation1 = 0.0f;
    float impulse1 = 0.0f;

    Rot turn;                     ///< B's rotation relative to A when the points were computed
    float rollingImpulse = 0.0f;  ///< N m s
    std::uint16_t ids[2] = {};    ///< of the points, see ManifoldPoint::id

    ContactAnchors anchors[2];

    float roundA = 0.0f;  ///< m, see Manifold::roundA
    float roundB = 0.0f;
    Vec2 normalInA;  ///< the normal in A's frame when the points were computed
};
static_assert(sizeof(Contact) == 128, "two cache lines: the narrow phase and the solver stream them");

/// m: separation of the unused second point of a contact with one point.
inline constexpr float kFarAway = 1.0e4f;

enum ContactFlag : std::uint16_t {
    kTouching = 1,   ///< the shapes touch: Began was reported, Ended was not
    kTriggered = 2,  ///< one of the shapes is a trigger: reports, exerts no forces
    kBegan = 4,      ///< in this step
    kReports = 8,    ///< produces events
    kOneWayA = 16,   ///< shape A is one-way
    kOneWayB = 32,
    kDisabled = 64,         ///< exerts no forces in this step
    kFixedA = 128,          ///< body A is not dynamic
    kRound = 256,           ///< one shape is a circle: the points are computed anew in each step
    kUnturned = 512,        ///< no impulse can rotate either body: one point is enough
    kGone = 1024,           ///< its bounds separated in this step, or the filters no longer allow it
    kPassing = 2048,        ///< a one-way shape lets the other shape through until they separate
    kAlongAxes = 4096,      ///< two boxes aligned with the world axes, of bodies that cannot rotate
    kInitialOverlap = 8192  ///< a part of its overlap is hidden from the solver: initial_overlaps.cpp
};

/// What happened between two shapes in a step.
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
    /// N s along the normal, of both points, summed over the step; 0 when Ended. A
    /// contact begins up to Settings::speculativeDistance before the shapes touch, so a
    /// body that approaches by less than that per step may have its impact in the next
    /// step. For a surface: the sum over its contacts that have an event in this step.
    float impulse = 0.0f;
    float approachSpeed = 0.0f;  ///< m/s: of Began, relative speed along the normal before the impact
};

struct World;

/// Callbacks by which the owner of a world decides about contacts. The stepping thread calls
/// them in a fixed order. They must return the same result for the same world, or steps are not
/// reproducible, and must not change the world: functions that would do so return an error.
struct ContactHooks {
    void* context = nullptr;  ///< passed to the callbacks
    /// May these two shapes collide? Called when bounds begin to overlap; if false, again after motion.
    bool (*filter)(void* context, const World& world, ShapeId a, ShapeId b) = nullptr;
    /// Does this contact, with its contactPoints(), exert forces? Called in every step while shapes touch.
    bool (*preSolve)(void* context, const World& world, const Contact& contact) = nullptr;
    /// Friction and bounciness of a contact, instead of those of ShapeDefinition. Called in every step while
    /// the shapes touch. Results out of range are clamped, NaN counts as 0.
    float (*friction)(void* context, const World& world, const Contact& contact) = nullptr;
    float (*bounciness)(void* context, const World& world, const Contact& contact) = nullptr;
};

}  // namespace plumb::physics
