#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/result.hpp"
#include "physics/geometry.hpp"
#include "physics/manifest.hpp"
#include "physics/model/contact.hpp"
#include "physics/model/field.hpp"
#include "physics/model/joint.hpp"
#include "physics/model/side_table.hpp"
#include "physics/settings.hpp"

namespace plumb::physics {

struct Workspace;

/// Position and orientation of a body. Two rows of four floats: the solver reads the second row.
struct alignas(16) BodyPose {
    WorldPosition centre;  ///< m: the centre of mass
    Rot rotation;
    Vec2 localCentre;  ///< m: the centre of mass in the frame of the body's shapes

    friend constexpr bool operator==(const BodyPose&, const BodyPose&) = default;
};

struct alignas(16) BodyMotion {
    Vec2 velocity;                 ///< m/s, of the centre of mass
    float angularVelocity = 0.0f;  ///< rad/s
    float restTime = 0.0f;         ///< s: time for which it has been at rest, for falling asleep
};

/// Mass properties of a body. Four floats, which the solver reads as one row (lanes.hpp).
struct alignas(16) BodyMass {
    float inverseMass = 0.0f;     ///< 1/kg; 0 for a body that no impulse can move
    float inverseInertia = 0.0f;  ///< 1/(kg m2), about the centre of mass; 0 if no impulse can rotate it
    float mass = 0.0f;            ///< kg, computed from the shapes or set by setMass()
    float inertia = 0.0f;         ///< kg m2
};

/// Forces on a body except contacts, joints and gravity. Few bodies have any, so they are in a SideTable.
struct BodyDrive {
    Vec2 force;           ///< N, in the next step only
    Vec2 acceleration;    ///< m/s2, in every step
    float torque = 0.0f;  ///< N m, in the next step only
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
    std::uint8_t owned = 0;            ///< bits of BodyOverride
    std::uint32_t firstShape = kNone;  ///< first shape; the others follow by ShapeInfo::next
    std::uint32_t firstJoint = kNone;  ///< first joint; the others follow by Joint::nextA or nextB
    std::uint32_t awakeIndex = kNone;  ///< index in World::awake; kNone if not there
    std::uint32_t island = kNone;  ///< parent in the union-find forest of islands; a root is its own parent
    float sleepSpeed = 0.05f;      ///< m/s, see BodyDefinition::sleepSpeed
    std::uint32_t drive = kNone;   ///< index in Bodies::drives, or kNone: default values
    float reach = 0.0f;            ///< m: maximum distance of a point of its shapes from its centre of mass
    float core = 0.0f;             ///< m: radius of a disc around its centre of mass that lies inside a shape
    std::uint64_t user = 0;        ///< see BodyDefinition::user
};

enum BodyOverride : std::uint8_t {
    kSetMass = 1,      ///< BodyMass::mass was set by a setter, not computed from the shapes
    kSetMassData = 2,  ///< inertia and center of mass were set by setMassData()
    kBodyOff = 4       ///< disabled: neither awake nor in a sleeping island; shapes have kShapeOff
};

enum BodyFlag : std::uint8_t {
    kBullet = 1,  ///< see BodyDefinition::bullet
    kCanSleep = 2,
    kFixedRotation = 4,
    kLockX = 8,
    kLockY = 16,
    kMoved = 32,         ///< its pose changed in the last step
    kHasTarget = 64,     ///< kinematic: its velocity was set by moveTo(), for one step
    kDropsThrough = 128  ///< one-way shapes do not stop it
};

enum class SubstepPhase : std::uint8_t {
    Calm,      ///< error within the tolerance
    Trying,    ///< quality was lowered by one; watches whether the error stays within the tolerance
    Strained,  ///< error above the tolerance; waits, as an impact's error decays by itself
    Rising,    ///< quality was raised; watches whether the error decreases
    Resigned   ///< a higher quality did not help, so the lower one was restored
};

/// State of the quality control of an island, if there is a tolerance (islands/substep_controller.hpp). Every
/// body of an island has a copy, so that the state is kept when the island splits.
struct SubstepController {
    Quality quality = kQualityOfWorld;  ///< in the last step; kQualityOfWorld: not yet evaluated
    Quality before = kQualityOfWorld;   ///< quality before the last change
    SubstepPhase phase = SubstepPhase::Calm;
    std::uint8_t patience = 0;  ///< number of failed changes of the quality: each doubles the wait
    std::uint32_t wait = 0;     ///< steps until the next decision
    float error = 0.0f;         ///< m: in Calm and Trying the maximum error; else error at the last decision
    float first = 0.0f;         ///< m: error that caused the quality to be raised
};

/// A body's share in the energy account of its island, if the world has joints (stages/keep_energy.cpp).
struct EnergyShare {
    float credit = 0.0f;  ///< J: energy lost recently, which may be regained; negative: energy gained
    float peak = 0.0f;    ///< J: recent maximum of the kinetic energy
};

/// The bodies: one array per group of properties that are used together, indexed by BodyId::index.
struct Bodies {
    std::vector<BodyPose> pose;
    std::vector<BodyMotion> motion;
    std::vector<BodyMass> mass;
    std::vector<BodyInfo> info;
    std::vector<SubstepController> substepControllers;  ///< empty without Settings::tolerance
    std::vector<EnergyShare> energies;                  ///< empty without joints
    SideTable<BodyDrive> drives;                        ///< indexed by BodyInfo::drive
    std::vector<std::uint32_t> free;                    ///< free indices, last freed last
    std::vector<std::uint32_t> dying;  ///< destroyed bodies; the next step ends their contacts and frees them

    [[nodiscard]] std::size_t size() const { return info.size(); }
    [[nodiscard]] const BodyDrive& driveOf(std::uint32_t body) const { return drives[info[body].drive]; }
    /// Returns the drive of a body for writing; creates one if the body has the default values.
    BodyDrive& ownDriveOf(std::uint32_t body) { return drives.own(info[body].drive); }
};

/// Properties of a shape that mostly have their default values.
struct ShapeExtras {
    float rollingResistance = 0.0f;
    float surfaceSpeed = 0.0f;  ///< m/s
    Vec2 oneWayDirection;       ///< used with kOneWay
    /// For an inner border; see ShapeDefinition::frontLayers.
    std::uint32_t frontLayers = 0;
    std::uint32_t frontMask = 0;

    friend constexpr bool operator==(const ShapeExtras&, const ShapeExtras&) = default;
};

struct ShapeInfo {
    std::uint32_t generation = 0;
    std::uint32_t body = kNone;
    std::uint32_t next = kNone;  ///< next shape of the same body
    std::uint8_t flags = 0;      ///< bits of ShapeFlag
    std::uint8_t reserved[3] = {};
    float density = 1.0f;
    float friction = 0.6f;
    float bounciness = 0.0f;
    float margin = 0.0f;  ///< m: enlargement of its bounds
    std::uint64_t user = 0;
    std::uint32_t surface = 0;     ///< see ShapeDefinition::surface; 0: not part of a surface
    std::uint32_t extras = kNone;  ///< index in Shapes::extras, or kNone: default values
};

enum ShapeFlag : std::uint8_t {
    kTrigger = 1,
    kOneWay = 2,
    kReportsContacts = 4,
    kLeftBounds = 8,  ///< it is in World::moved
    kAltered = 16,    ///< it is in World::altered
    kShapeOff = 32    ///< its body is disabled: hidden from the broad phase
};

/// The shapes, indexed by ShapeId::index.
struct Shapes {
    std::vector<Geometry> geometry;  ///< in the frame of the body's definition, not of its centre of mass
    std::vector<AABB> bounds;        ///< m: the shape's bounding box, enlarged by the margin
    std::vector<Filter> filter;
    std::vector<ProxyMotion> motion;
    std::vector<ShapeInfo> info;
    SideTable<ShapeExtras> extras;                          ///< indexed by ShapeInfo::extras
    std::vector<std::uint32_t> free;                        ///< as in Bodies
    std::vector<std::uint32_t> dying;                       ///< as in Bodies
    std::vector<Corner> corners;                            ///< corners of all polygons
    std::array<std::vector<std::uint32_t>, 6> freeCorners;  ///< [n]: starts of free blocks of 2^n corners

    [[nodiscard]] std::size_t size() const { return info.size(); }
    [[nodiscard]] const ShapeExtras& extrasOf(std::uint32_t shape) const {
        return extras[info[shape].extras];
    }
};

/// The data of a joint that the solver reads; the rest is in its JointDefinition.
struct Joint {
    std::uint32_t bodyA = kNone;
    std::uint32_t bodyB = kNone;
    Vec2 anchorA;  ///< m, from A's centre of mass, in A's frame
    Vec2 anchorB;
    JointKind kind = JointKind::Revolute;
    std::uint8_t flags = 0;  ///< bits of JointFlag
    std::uint8_t colour = kNoColour;
    Quality quality = kQualityOfWorld;
    std::uint32_t generation = 0;
    Vec2 force;           ///< N on B, in the last substep
    float torque = 0.0f;  ///< N m on B, in the last substep
    float rows[6] = {};  ///< N or N m: force of each constraint row, for warm starting; Gear stores its error
                         ///< (rad or m) in rows[1]
    std::uint32_t nextA = kNone;  ///< the next joint of body A
    std::uint32_t nextB = kNone;
    std::uint32_t awakeIndex = kNone;  ///< index in Joints::awake; kNone if not there
};

enum JointFlag : std::uint8_t {
    kLimited = 1,      ///< JointDefinition::limit is on
    kDriven = 2,       ///< JointDefinition::motor is on
    kSprung = 4,       ///< JointDefinition::spring is on
    kBreakable = 8,    ///< it can break, or reports a large force or torque
    kSoft = 16,        ///< JointDefinition::hertz is set
    kKeepsApart = 32,  ///< its two bodies do not collide
    kStretched = 64    ///< solved iteratively before, so it may have an error: joint_tree_builder.cpp
};

struct Joints {
    std::vector<Joint> hot;
    std::vector<JointDefinition> definition;
    std::vector<std::uint32_t> awake;  ///< joints with an awake body
    std::vector<std::uint32_t> free;

    [[nodiscard]] std::size_t size() const { return hot.size(); }
};

using SoftBodyId = Id<struct SoftBody>;

struct SoftParticle {
    WorldPosition place;       ///< m
    WorldPosition before;      ///< m: at the start of the substep
    Vec2 velocity;             ///< m/s
    float inverseMass = 0.0f;  ///< 1/kg; 0 if it is pinned
    float mass = 0.0f;         ///< kg
};

/// Distance constraint between two particles.
struct SoftLink {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    float length = 0.0f;      ///< m
    float compliance = 0.0f;  ///< m/N
    bool isEdge = false;      ///< particles of other soft bodies collide with it
};

/// Force of a shape on a particle at the end of a step; the next step begins with this force.
struct SoftTouch {
    std::uint32_t particle = 0;
    std::uint32_t shape = 0;
    Vec2 force;  ///< N
};

/// A rope, cloth or jelly: particles and their constraints.
struct SoftBody {
    std::vector<SoftParticle> particles;
    std::vector<SoftLink> links;
    std::vector<std::uint32_t> ring;  ///< particles around the area to preserve; empty for none
    std::vector<SoftTouch> touches;   ///< sorted by shape, then by particle
    float area = 0.0f;                ///< m2, at rest; signed by the ring's orientation
    float areaCompliance = 0.0f;      ///< see SoftMaterial::areaCompliance
    float radius = 0.0f;              ///< m: of each particle
    float damping = 0.0f;             ///< 1/s
    float friction = 0.0f;
    std::uint32_t layers = 1;
    std::uint32_t mask = 0xffffffffu;
    std::uint32_t generation = 0;
    std::uint8_t substeps = 8;
    bool isAlive = false;
};

/// A sleeping island: linked lists of its bodies (by BodyInfo::island) and its contacts.
struct SleepingIsland {
    std::uint32_t firstBody = kNone;     ///< first body; the others follow by Sleepers::nextBody
    std::uint32_t firstContact = kNone;  ///< first contact; the others follow by Sleepers::nextContact
};

/// The sleeping islands, which a step does not process.
struct Sleepers {
    std::vector<SleepingIsland> islands;
    std::vector<std::uint32_t> freeIslands;
    std::vector<Contact> contacts;
    std::vector<std::uint32_t> nextContact;  ///< parallel to `contacts`: the next one of the same island
    std::vector<std::uint32_t> freeContacts;
    std::vector<std::uint32_t> nextBody;  ///< indexed by body index: the next one of the same island
    std::vector<std::uint32_t> islandOf;  ///< indexed by body index: its island; kNone for an awake body
};

/// Objects, indexed by Id::index.
template <class Object>
struct Slots {
    std::vector<Object> all;
    std::vector<std::uint32_t> free;
};

/// An overlap too deep to result from the bodies' motion, see initial_overlaps.cpp.
struct InitialOverlap {
    PairKey pair = 0;
    float hidden = 0.0f;  ///< m: part of the overlap that is hidden from the solver
};

/// Owns the Workspace of a world, which can be recomputed from the world. So a copy of the world does not
/// copy it, and a world that is overwritten keeps the memory but refills it.
class WorkspaceHolder {
public:
    WorkspaceHolder() = default;
    WorkspaceHolder(const WorkspaceHolder&) {}
    WorkspaceHolder& operator=(const WorkspaceHolder&) { return state_ = State::Stale, *this; }
    WorkspaceHolder(WorkspaceHolder&&) noexcept = default;
    WorkspaceHolder& operator=(WorkspaceHolder&&) noexcept = default;

    /// Returns the workspace; creates it on first use.
    Workspace& get();
    /// Returns the workspace of the last step; null without a step since creation, copying or overwriting.
    [[nodiscard]] const Workspace* lastStep() const {
        return state_ == State::Stepped ? workspace_.get() : nullptr;
    }
    /// Called at the end of a step.
    void noteStep() {
        if (!stale()) state_ = State::Stepped;
    }
    /// Returns true once after the world was created or overwritten.
    bool takeStale() { return stale() && (state_ = State::Refilled, true); }
    [[nodiscard]] bool stale() const { return workspace_ == nullptr || state_ == State::Stale; }
    /// A callback of StepOptions::hooks is running: setters return errors. Not copied with the world.
    bool isInCallback = false;

private:
    /// Refilled: a query updated the broad phase, but no step has run yet.
    enum class State : unsigned char { Stale, Refilled, Stepped };

    struct Delete {
        void operator()(Workspace* workspace) const;
    };

    std::unique_ptr<Workspace, Delete> workspace_;
    State state_ = State::Stale;
};

/// The whole simulated state as plain data with indices instead of pointers: a copy is a snapshot.
struct World {
    Settings settings;
    Bodies bodies;
    Shapes shapes;
    Joints joints;
    Slots<Field> fields;
    Slots<SoftBody> softBodies;          ///< ropes, cloth and soft bodies
    std::vector<std::uint32_t> awake;    ///< awake dynamic and kinematic bodies
    std::vector<std::uint32_t> moved;    ///< shapes with kLeftBounds, whose pairs must be searched
    std::vector<std::uint32_t> altered;  ///< shapes whose contacts restart in the next step
    std::vector<Contact> contacts;       ///< contacts with at least one awake body
    Sleepers sleepers;
    std::vector<InitialOverlap> initialOverlaps;  ///< sorted by pair
    std::vector<ContactEvent> events;             ///< events of the last step
    std::vector<JointId> brokenJoints;            ///< joints that broke in the last step
    std::vector<JointId> strainedJoints;  ///< joints above reportForce or reportTorque in the last step
    std::vector<BodyId> fellAsleep;       ///< bodies that fell asleep in the last step
    std::vector<BodyId> quarantined;      ///< bodies stopped in the last step: non-finite or beyond kFarthest
    std::vector<SoftBodyId> quarantinedSoft;  ///< soft bodies with particles stopped for this reason
    std::uint32_t qualityCallers = 0;         ///< number of bodies and joints with a quality set
    bool newJoints = false;                   ///< true if a joint has no color yet
    bool filtersStale = false;                ///< a filter or joint changed: contacts may have become invalid
    bool islandsStale = false;  ///< a contact or joint ended: islands may be larger than necessary
    float islandsAge = 0.0f;    ///< s: time for which islandsStale has been true
    Manifest manifest;
    Vec2 gravityOfLastStep;  ///< m/s2: a change of Settings::gravity wakes all bodies
    std::uint64_t steps = 0;
    float stepLength = 1.0f / 60.0f;  ///< s: length of the step that the impulses in `contacts` belong to
    WorkspaceHolder work;             ///< derived data: neither copied nor hashed
};

/// True if the id is the latest one assigned to its index; its object may have been destroyed since.
template <class List, class Thing>
[[nodiscard]] bool isLatest(const List& list, Id<Thing> id) {
    return id.generation != 0 && id.index < list.size() && list[id.index].generation == id.generation;
}
[[nodiscard]] inline bool alive(const World& world, BodyId id) {
    return isLatest(world.bodies.info, id) && world.bodies.info[id.index].kind != BodyKind::None;
}
[[nodiscard]] inline bool alive(const World& world, ShapeId id) {
    return isLatest(world.shapes.info, id) && (world.shapes.motion[id.index] != ProxyMotion::Gone ||
                                               (world.shapes.info[id.index].flags & kShapeOff) != 0);
}
[[nodiscard]] inline bool alive(const World& world, JointId id) {
    return isLatest(world.joints.hot, id) && world.joints.hot[id.index].bodyA != kNone;
}
[[nodiscard]] inline bool alive(const World& world, FieldId id) {
    return isLatest(world.fields.all, id) && world.fields.all[id.index].isAlive;
}
[[nodiscard]] inline bool alive(const World& world, SoftBodyId id) {
    return isLatest(world.softBodies.all, id) && world.softBodies.all[id.index].isAlive;
}

[[nodiscard]] inline BodyId idOfBody(const World& world, std::uint32_t body) {
    return {body, world.bodies.info[body].generation};
}
[[nodiscard]] inline ShapeId idOfShape(const World& world, std::uint32_t shape) {
    return {shape, world.shapes.info[shape].generation};
}
[[nodiscard]] inline JointId idOfJoint(const World& world, std::uint32_t joint) {
    return {joint, world.joints.hot[joint].generation};
}

/// Returns the object's element of a list, or a default value for a stale id. All getters use it.
template <class T, class Thing>
[[nodiscard]] const T& readOf(const World& world, const std::vector<T>& list, Id<Thing> id) {
    static const T kNeutral{};
    return alive(world, id) ? list[id.index] : kNeutral;
}

[[nodiscard]] inline bool isDynamic(const World& world, std::uint32_t body) {
    return world.bodies.info[body].kind == BodyKind::Dynamic;
}
/// Returns a vector without its components along the axes on which a body is locked.
[[nodiscard]] inline Vec2 unlocked(const World& world, std::uint32_t body, Vec2 v) {
    const std::uint8_t flags = world.bodies.info[body].flags;
    return {(flags & kLockX) != 0 ? 0.0f : v.x, (flags & kLockY) != 0 ? 0.0f : v.y};
}
/// True for an awake dynamic body.
[[nodiscard]] inline bool isUp(const World& world, std::uint32_t body) {
    return isDynamic(world, body) && world.bodies.info[body].awakeIndex != kNone;
}

}  // namespace plumb::physics
