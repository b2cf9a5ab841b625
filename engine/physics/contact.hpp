#pragma once

#include <cstdint>

#include "math/rot.hpp"
#include "physics/contact_rows.hpp"
#include "physics/ids.hpp"

namespace plumb::physics {

/// Of a constraint that does not push at present.
inline constexpr std::uint8_t kNoColour = 255;

/// Where two bodies touch: from each one's centre of mass, in its own frame.
struct ContactAnchors {
    Vec2 a;  ///< m
    Vec2 b;  ///< m
};

/// Two shapes whose bounds overlap. Points and impulses live as long as it does: what was learned in one
/// step starts the next (warm starting).
///
/// Laid out in rows of four floats: the solver reads the same row of eight contacts at once (lanes.hpp), so
/// ContactRow names them; what changes while it rests is in the first four. A contact of one point has the
/// second far away, where it never pushes.
struct alignas(64) Contact {
    std::uint32_t shapeA = 0;  ///< of two, A is the one whose body cannot be pushed, or the lower index
    std::uint32_t shapeB = 0;
    std::uint32_t bodyA = 0;
    std::uint32_t bodyB = 0;

    std::uint16_t flags = 0;  ///< bits of ContactFlag
    std::uint8_t colour = kNoColour;
    std::uint8_t count = 0;  ///< of points
    float bounciness = 0.0f;
    float rollingResistance = 0.0f;  ///< m
    float surfaceSpeed = 0.0f;       ///< m/s of B's surface over A's along perpendicular(normal)

    Vec2 normal;  ///< world, length 1, from A to B
    float friction = 0.0f;
    float frictionImpulse = 0.0f;  ///< N s, of one substep, on B along perpendicular(normal)

    float separation0 = 0.0f;  ///< m along the normal, at the start of the step
    float impulse0 = 0.0f;     ///< N s, of the last substep; below 0: minus that of a blow, which is over
    float separation1 = 0.0f;
    float impulse1 = 0.0f;

    Rot turn;                     ///< B's rotation seen from A when the points were found
    float rollingImpulse = 0.0f;  ///< N m s
    std::uint16_t ids[2] = {};    ///< of the points, see ManifoldPoint

    ContactAnchors anchors[2];

    float roundA = 0.0f;  ///< m, see Manifold
    float roundB = 0.0f;
    Vec2 normalInA;  ///< the normal in A's frame, when the points were found
};
static_assert(sizeof(Contact) == 128, "two cache lines: the narrow phase and the solver stream them");

/// m: where the second point of a contact of one point is.
inline constexpr float kFarAway = 1.0e4f;

enum ContactFlag : std::uint16_t {
    kTouching = 1,   ///< the shapes touch: has begun and not ended
    kTriggered = 2,  ///< one of the shapes is a trigger: reports, does not push
    kBegan = 4,      ///< in this step
    kReports = 8,    ///< makes events
    kOneWayA = 16,   ///< shape A is one-way
    kOneWayB = 32,
    kDisabled = 64,     ///< does not push in this step
    kFixedA = 128,      ///< body A cannot be pushed
    kRound = 256,       ///< a circle takes part: points are found anew in each step
    kUnturned = 512,    ///< neither body can be turned by a push: one point says all
    kGone = 1024,       ///< in this step its bounds parted
    kPassing = 2048,    ///< of a one-way shape that lets the other through until they part
    kAlongAxes = 4096,  ///< two boxes along the axes of the world, of bodies that stay so
    kInitialOverlap = 8192  ///< some of its overlap is hidden from the solver: initial_overlaps.hpp
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
    Vec2 normal;           ///< world, from a to b
    Vec2 point;            ///< m, world, near enough to the origin to be float
    float impulse = 0.0f;  ///< N s over the whole step, along the normal
};

}  // namespace plumb::physics
