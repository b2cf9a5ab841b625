#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/result.hpp"
#include "physics/body.hpp"
#include "physics/contact.hpp"
#include "physics/field.hpp"
#include "physics/joint.hpp"
#include "physics/manifest.hpp"
#include "physics/settings.hpp"
#include "physics/shape.hpp"
#include "physics/side_table.hpp"
#include "physics/soft_particles.hpp"
#include "physics/workspace_holder.hpp"

namespace plumb {
class Hasher;
}

namespace plumb::physics {

/// Where a body is. Two rows of four floats, of which the solver reads the second.
struct alignas(16) BodyPose {
    Place centre;  ///< m: its centre of mass
    Rot rotation;
    Vec2 localCentre;  ///< m: the centre of mass in the frame of its shapes

    friend constexpr bool operator==(const BodyPose&, const BodyPose&) = default;
};

struct alignas(16) BodyMotion {
    Vec2 velocity;                 ///< m/s, of the centre of mass
    float angularVelocity = 0.0f;  ///< rad/s
    float restTime = 0.0f;         ///< s for which it has hardly moved
};

/// How a body answers a push. Four floats, which the solver reads as a row (lanes.hpp).
struct alignas(16) BodyMass {
    float inverseMass = 0.0f;     ///< 1/kg; 0 for what cannot be pushed
    float inverseInertia = 0.0f;  ///< 1/(kg m2), about the centre of mass; 0 for what cannot be turned
    float mass = 0.0f;            ///< kg, of the shapes or as set
    float inertia = 0.0f;         ///< kg m2
};

/// What drives a body besides contacts, joints and plain gravity. Few have any of it.
struct BodyDrive {
    Vec2 force;           ///< N, of the next step
    Vec2 acceleration;    ///< m/s2, of every step
    float torque = 0.0f;  ///< N m, of the next step
    float gravityScale = 1.0f;
    float linearDrag = 0.0f;   ///< 1/s
    float angularDrag = 0.0f;  ///< 1/s

    friend constexpr bool operator==(const BodyDrive&, const BodyDrive&) = default;
};

struct BodyInfo {
    std::uint32_t generation = 0;
    BodyKind kind = BodyKind::None;
    std::uint8_t flags = 0;  ///< bits of BodyFlag
    Quality quality = kQualityOfWorld;
    bool hasSetMass = false;           ///< BodyMass::mass is what the owner wants it to be, not the shapes'
    std::uint32_t firstShape = kNone;  ///< the rest by ShapeInfo::next
    std::uint32_t firstJoint = kNone;  ///< the rest by Joint::nextA or nextB
    std::uint32_t place = kNone;       ///< in World::awake, or kNone
    std::uint32_t island = kNone;      ///< parent in the forest of islands; the root is its own
    float sleepSpeed = 0.05f;          ///< m/s
    std::uint32_t drive = kNone;       ///< in Bodies::drives, see there
    float reach = 0.0f;                ///< m: no point of it is further from its centre of mass
    float core = 0.0f;                 ///< m: a disc of this radius at its centre of mass is inside it
    std::uint64_t user = 0;
};

enum BodyFlag : std::uint8_t {
    kBullet = 1,
    kCanSleep = 2,
    kFixedRotation = 4,
    kLockX = 8,
    kLockY = 16,
    kMoved = 32,         ///< its pose changed in the last step
    kHasTarget = 64,     ///< kinematic: a velocity that leads to where moveTo() sent it, for one step
    kDropsThrough = 128  ///< one-way shapes let it through
};

/// What an island is about to find out.
enum class EffortPhase : std::uint8_t {
    Calm,      ///< it keeps to the tolerance
    Trying,    ///< it took a quality less: does it still?
    Strained,  ///< it does not: perhaps a blow, which passes by itself
    Rising,    ///< it took more quality: does that help?
    Resigned   ///< it did not help: that much quality would be for nothing
};

/// How hard an island is worked on where there is a tolerance (solver/effort.hpp). All its bodies have the
/// same, so that it stays known when an island falls apart.
struct Effort {
    Quality quality = kQualityOfWorld;  ///< of the last step; kQualityOfWorld: never judged
    Quality before = kQualityOfWorld;   ///< until it rose last
    EffortPhase phase = EffortPhase::Calm;
    std::uint8_t patience = 0;  ///< how often quality was lowered in vain: each doubles the wait
    std::uint32_t wait = 0;     ///< steps until it is judged
    float error = 0.0f;         ///< m: what it is compared with when it is
    float first = 0.0f;         ///< m: the error for which it rose
};

/// A body's part of the account that its island has where there are joints (stages/keep_energy.cpp).
struct EnergyShare {
    float credit = 0.0f;  ///< J: lost lately, and may come back; below 0: gained
    float peak = 0.0f;    ///< J: the most that it moved with lately
};

/// The bodies, as one array per group of properties that are used together, indexed by BodyId::index.
struct Bodies {
    std::vector<BodyPose> pose;
    std::vector<BodyMotion> motion;
    std::vector<BodyMass> mass;
    std::vector<BodyInfo> info;
    std::vector<Effort> efforts;        ///< empty without Settings::tolerance
    std::vector<EnergyShare> energies;  ///< empty without joints
    SideTable<BodyDrive> drives;        ///< by BodyInfo::drive
    std::vector<std::uint32_t> free;    ///< places, last freed last
    std::vector<std::uint32_t> dying;   ///< free once the next step has ended their contacts

    [[nodiscard]] std::size_t size() const { return info.size(); }
    [[nodiscard]] const BodyDrive& driveOf(std::uint32_t body) const { return drives[info[body].drive]; }
    BodyDrive& ownDriveOf(std::uint32_t body) { return drives.own(info[body].drive); }
};

/// What sets a shape apart from most others.
struct ShapeExtras {
    float rollingResistance = 0.0f;
    float surfaceSpeed = 0.0f;  ///< m/s
    Vec2 oneWayDirection;       ///< of kOneWay
    /// Of an inner border: whoever meets these never comes to it, see ShapeDefinition.
    std::uint32_t frontLayers = 0;
    std::uint32_t frontMask = 0;

    friend constexpr bool operator==(const ShapeExtras&, const ShapeExtras&) = default;
};

struct ShapeInfo {
    std::uint32_t generation = 0;
    std::uint32_t body = kNone;
    std::uint32_t next = kNone;  ///< of the same body
    std::uint8_t flags = 0;      ///< bits of ShapeFlag
    std::uint8_t reserved[3] = {};
    float density = 1.0f;
    float friction = 0.6f;
    float bounciness = 0.0f;
    float margin = 0.0f;  ///< m: how much larger its bounds are made
    std::uint64_t user = 0;
    std::uint32_t surface = 0;     ///< what it is a part of, see ShapeDefinition; 0: on its own
    std::uint32_t extras = kNone;  ///< in Shapes::extras, see there
};

enum ShapeFlag : std::uint8_t {
    kTrigger = 1,
    kOneWay = 2,
    kReportsContacts = 4,
    kLeftBounds = 8  ///< is in World::moved
};

/// The shapes, indexed by ShapeId::index.
struct Shapes {
    std::vector<Geometry> geometry;  ///< in the frame of its body's definition, not of its centre of mass
    std::vector<AABB> bounds;        ///< m, grown by the margin; the shape is inside
    std::vector<Filter> filter;
    std::vector<ProxyMotion> motion;
    std::vector<ShapeInfo> info;
    SideTable<ShapeExtras> extras;  ///< by ShapeInfo::extras
    std::vector<std::uint32_t> free;
    std::vector<std::uint32_t> dying;
    std::vector<Corner> corners;                            ///< of all polygons
    std::array<std::vector<std::uint32_t>, 6> freeCorners;  ///< places in it of 2^n corners

    [[nodiscard]] std::size_t size() const { return info.size(); }
    [[nodiscard]] const ShapeExtras& extrasOf(std::uint32_t shape) const {
        return extras[info[shape].extras];
    }
};

/// A joint as the solver reads it; the rest is in its definition.
struct Joint {
    std::uint32_t bodyA = kNone;
    std::uint32_t bodyB = kNone;
    Vec2 anchorA;  ///< m, from A's centre of mass in A's frame
    Vec2 anchorB;
    JointKind kind = JointKind::Revolute;
    std::uint8_t flags = 0;  ///< bits of JointFlag
    std::uint8_t colour = kNoColour;
    Quality quality = kQualityOfWorld;
    std::uint32_t generation = 0;
    Vec2 force;                   ///< N on B, in the last substep
    float torque = 0.0f;          ///< N m on B
    float rows[6] = {};           ///< N or N m: of each row of its value, and what else its block needs
    std::uint32_t nextA = kNone;  ///< the next joint of body A
    std::uint32_t nextB = kNone;
    std::uint32_t place = kNone;  ///< in Joints::awake, or kNone
};

enum JointFlag : std::uint8_t {
    kLimited = 1,
    kDriven = 2,
    kSprung = 4,
    kBreakable = 8,
    kSoft = 16,  ///< has a stiffness of its own
    kKeepsApart = 32,
    kStretched = 64  ///< the lanes solved it, so it may be open: see grow_trees.cpp
};

struct Joints {
    std::vector<Joint> hot;
    std::vector<JointDefinition> definition;
    std::vector<std::uint32_t> awake;  ///< with a body that is awake
    std::vector<std::uint32_t> free;

    [[nodiscard]] std::size_t size() const { return hot.size(); }
};

/// An island at rest: chains of bodies (by BodyInfo::island) and contacts.
struct SleepingIsland {
    std::uint32_t firstBody = kNone;     ///< the rest by Sleepers::nextBody
    std::uint32_t firstContact = kNone;  ///< the rest by Sleepers::nextContact
};

/// What rests. A step never looks at it.
struct Sleepers {
    std::vector<SleepingIsland> islands;
    std::vector<std::uint32_t> freeIslands;
    std::vector<Contact> contacts;
    std::vector<std::uint32_t> nextContact;  ///< the same places as `contacts`
    std::vector<std::uint32_t> freeContacts;
    std::vector<std::uint32_t> nextBody;  ///< by body
    std::vector<std::uint32_t> islandOf;  ///< by body; kNone for what is awake
};

/// The fields, indexed by FieldId::index.
struct Fields {
    std::vector<Field> all;
    std::vector<std::uint32_t> free;
};

/// Ropes, cloth and jellies, indexed by SoftBodyId::index.
struct SoftBodies {
    std::vector<SoftBody> all;
    std::vector<std::uint32_t> free;
};

/// An overlap that no motion explains, see initial_overlaps.hpp.
struct InitialOverlap {
    PairKey pair = 0;
    float hidden = 0.0f;  ///< m: of it, which the solver does not see yet
};

/// Everything that is simulated, as plain data: copy = snapshot. Indices and generations, no addresses.
struct World {
    Settings settings;
    Bodies bodies;
    Shapes shapes;
    Joints joints;
    Fields fields;
    SoftBodies softBodies;
    std::vector<std::uint32_t> awake;  ///< bodies that may move
    std::vector<std::uint32_t> moved;  ///< shapes that have to be looked up by the broad phase: kLeftBounds
    std::vector<Contact> contacts;     ///< of which at least one body is awake
    Sleepers sleepers;
    std::vector<InitialOverlap> initialOverlaps;  ///< by pair
    std::vector<ContactEvent> events;             ///< of the last step
    std::vector<JointId> brokenJoints;            ///< in the last step
    std::vector<BodyId> quarantined;   ///< whose numbers went bad in the last step: stopped where they were
    std::uint32_t qualityCallers = 0;  ///< bodies and joints with a quality of their own
    bool newJoints = false;            ///< some joint has no colour yet
    bool filtersStale = false;         ///< a filter or a joint is new: contacts are asked whether they may be
    bool islandsStale = false;         ///< a contact or joint ended: islands may be larger than need be
    float islandsAge = 0.0f;           ///< s for which they have been stale
    Manifest manifest;
    Vec2 gravityOfLastStep;  ///< m/s2: a change wakes everything
    std::uint64_t steps = 0;
    float stepLength = 1.0f / 60.0f;  ///< s: of the step that contacts have their impulses of
    WorkspaceHolder work;             ///< follows from the rest: neither copied nor hashed
};

}  // namespace plumb::physics
