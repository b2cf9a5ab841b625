#include "physics/model/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/contacts/contacts.hpp"
#include "physics/effects/drag.hpp"
#include "physics/islands/sleeping.hpp"
#include "physics/model/bounds.hpp"
#include "physics/model/checks.hpp"
#include "physics/model/edits.hpp"
#include "physics/model/joints.hpp"
#include "physics/model/mass.hpp"
#include "physics/model/shapes.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

Result<Done> check(const BodyDefinition& definition) {
    return firstOf(
        checkKind("BodyDefinition.kind", definition.kind),
        checkPlace("BodyDefinition.position", definition.position),
        checkNumber("BodyDefinition.angle", definition.angle, -1.0e5, 1.0e5),
        checkVector("BodyDefinition.velocity", definition.velocity, kFastest),
        checkNumber("BodyDefinition.angularVelocity", definition.angularVelocity, -kFastest, kFastest),
        checkVector("BodyDefinition.acceleration", definition.acceleration, kFastest),
        checkNumber("BodyDefinition.gravityScale", definition.gravityScale, -kFastest, kFastest),
        checkNumber("BodyDefinition.linearDrag", definition.linearDrag, 0.0, kFastest),
        checkNumber("BodyDefinition.angularDrag", definition.angularDrag, 0.0, kFastest),
        checkNumber("BodyDefinition.sleepSpeed", definition.sleepSpeed, 0.0, kFastest),
        checkQuality("BodyDefinition.quality", definition.quality));
}

std::uint32_t allocateIndex(World& world) {
    Bodies& bodies = world.bodies;
    if (!bodies.free.empty()) {
        const std::uint32_t index = bodies.free.back();
        bodies.free.pop_back();
        return index;
    }
    const std::size_t count = bodies.size() + 1;
    bodies.pose.resize(count);
    bodies.motion.resize(count);
    bodies.mass.resize(count);
    bodies.info.resize(count);
    world.sleepers.nextBody.resize(count, kNone);
    world.sleepers.islandOf.resize(count, kNone);
    return static_cast<std::uint32_t>(count - 1);
}

std::uint8_t flagsOf(const BodyDefinition& definition) {
    return static_cast<std::uint8_t>((definition.bullet ? kBullet : 0) |
                                     (definition.canSleep ? kCanSleep : 0) |
                                     (definition.fixedRotation ? kFixedRotation : 0) |
                                     (definition.lockX ? kLockX : 0) | (definition.lockY ? kLockY : 0));
}

BodyDrive driveOf(const BodyDefinition& definition) {
    BodyDrive drive;
    drive.acceleration = definition.acceleration;
    drive.gravityScale = definition.gravityScale;
    drive.linearDrag = definition.linearDrag;
    drive.angularDrag = definition.angularDrag;
    return drive;
}

/// Changes a property that a body's effects depend on, and updates the manifest.
template <class Change>
void change(World& world, BodyId body, Change&& change) {
    countEffectsOfBody(world, body.index, -1);
    change();
    countEffectsOfBody(world, body.index, 1);
}

bool isHeldUpright(const BodyInfo& info) {
    return info.kind == BodyKind::Dynamic && (info.flags & kFixedRotation) != 0;
}

bool isDynamic(const World& world, BodyId body) {
    return world.bodies.info[body.index].kind == BodyKind::Dynamic;
}

}  // namespace

void countEffectsOfBody(World& world, std::uint32_t body, int times) {
    const BodyInfo& info = world.bodies.info[body];
    const BodyDrive& drive = world.bodies.driveOf(body);
    const bool dynamic = info.kind == BodyKind::Dynamic;
    Manifest& manifest = world.manifest;
    manifest.call(Effect::Gravity, dynamic && drive.gravityScale != 0.0f, times);
    manifest.call(Effect::Rotation, dynamic && (info.flags & kFixedRotation) == 0, times);
    manifest.call(Effect::Drag, dynamic && (drive.linearDrag > 0.0f || drive.angularDrag > 0.0f), times);
    manifest.call(Effect::Continuous, dynamic, times);
    manifest.call(Effect::Sleep, dynamic && (info.flags & kCanSleep) != 0, times);
    manifest.call(Effect::Kinematics, info.kind == BodyKind::Kinematic, times);
    if (info.quality != kQualityOfWorld) world.qualityCallers += static_cast<std::uint32_t>(times);
    manifest.call(Effect::Locks, dynamic && (info.flags & (kLockX | kLockY)) != 0, times);
}

bool alive(const World& world, BodyId body) {
    return body.generation != 0 && body.index < world.bodies.size() &&
           world.bodies.info[body.index].generation == body.generation &&
           world.bodies.info[body.index].kind != BodyKind::None;
}

std::size_t bodyCount(const World& world) {
    return world.bodies.size() - world.bodies.free.size() - world.bodies.dying.size();
}

Result<BodyId> createBody(World& world, const BodyDefinition& definition) {
    if (const auto checked = firstOf(checkOutside("createBody", world), check(definition)); !checked)
        return checked.error();
    const std::uint32_t index = allocateIndex(world);
    Bodies& bodies = world.bodies;
    BodyInfo& info = bodies.info[index];
    const std::uint32_t generation = info.generation + 1;
    info = {};
    info.generation = generation;
    info.kind = definition.kind;
    info.flags = flagsOf(definition);
    info.quality = definition.quality;
    info.island = index;
    info.sleepSpeed = definition.sleepSpeed;
    info.user = definition.user;
    bodies.pose[index] = {definition.position, rotFromAngle(definition.angle), {}};
    bodies.motion[index] = {definition.velocity, definition.angularVelocity, 0.0f};
    if (index < bodies.substepControllers.size()) bodies.substepControllers[index] = {};
    if (index < bodies.energies.size()) bodies.energies[index] = {};
    const BodyDrive drive = driveOf(definition);
    if (!(drive == BodyDrive{})) bodies.ownDriveOf(index) = drive;
    if (definition.kind == BodyKind::Static) bodies.motion[index] = {};
    if (isHeldUpright(info)) bodies.motion[index].angularVelocity = 0.0f;
    updateMass(world, index);
    countEffectsOfBody(world, index, 1);
    if (definition.kind == BodyKind::Kinematic ||
        (definition.kind == BodyKind::Dynamic && definition.awake)) {
        addAwake(world, index);
    } else if (definition.kind == BodyKind::Dynamic) {
        addAsleep(world, index);
    }
    return BodyId{index, generation};
}

void destroyBody(World& world, BodyId body) {
    if (!mayChange(world, body)) return;
    wake(world, body.index);
    BodyInfo& info = world.bodies.info[body.index];
    while (info.firstJoint != kNone) {
        destroyJoint(world, {info.firstJoint, world.joints.hot[info.firstJoint].generation});
    }
    destroyShapes(world, body);
    countEffectsOfBody(world, body.index, -1);
    removeAwake(world, body.index);
    info.kind = BodyKind::None;
    info.owned = static_cast<std::uint8_t>(info.owned & ~kBodyOff);
    world.bodies.drives.release(info.drive);
    world.bodies.mass[body.index] = {};
    world.bodies.motion[body.index] = {};
    world.bodies.dying.push_back(body.index);
}

bool isAwake(const World& world, BodyId body) { return world.bodies.info[body.index].place != kNone; }

FreeMotion freeMotionOf(const World& world, std::uint32_t body, float dt) {
    const BodyInfo& info = world.bodies.info[body];
    const BodyMotion& motion = world.bodies.motion[body];
    if (info.kind != BodyKind::Dynamic) return {dt * motion.velocity, dt * motion.angularVelocity};
    const BodyMass& mass = world.bodies.mass[body];
    const BodyDrive& drive = world.bodies.driveOf(body);
    const Vec2 pull =
        drive.gravityScale * world.settings.gravity + drive.acceleration + mass.inverseMass * drive.force;
    const float spin = mass.inverseInertia * drive.torque;
    FreeMotion free{
        decayOf(drive.linearDrag, dt).drive * motion.velocity + distanceUnder(drive.linearDrag, dt) * pull,
        decayOf(drive.angularDrag, dt).drive * motion.angularVelocity +
            distanceUnder(drive.angularDrag, dt) * spin};
    if ((info.flags & kLockX) != 0) free.displacement.x = 0.0f;
    if ((info.flags & kLockY) != 0) free.displacement.y = 0.0f;
    return free;
}

Frame predictTransform(const World& world, BodyId body, float dt) {
    constexpr float kFarthestAhead = 1.0e6f;  // s
    const FreeMotion free =
        freeMotionOf(world, body.index, std::isnan(dt) ? 0.0f : std::clamp(dt, 0.0f, kFarthestAhead));
    const BodyPose& pose = world.bodies.pose[body.index];
    const Rot rotation = normalized(rotFromAngle(free.angle) * pose.rotation);
    return {toVec2(pose.centre + free.displacement) - rotate(rotation, pose.localCentre), rotation};
}

Result<Done> setPosition(World& world, BodyId body, WorldPosition position, float angle) {
    const auto checked = firstOf(checkAlive("setPosition", world, body), checkPlace("setPosition", position),
                                 checkNumber("setPosition angle", angle, -1.0e5, 1.0e5));
    if (!checked) return checked;
    wakeTouching(world, body.index);
    BodyPose& pose = world.bodies.pose[body.index];
    const Rot before = std::exchange(pose.rotation, rotFromAngle(angle));
    pose.centre = position + rotate(pose.rotation, pose.localCentre);
    refreshBounds(world, body.index);
    // Contacts of bodies that cannot rotate assume a constant rotation (kAlongAxes).
    if (!(pose.rotation == before) && !canTurn(world, body.index)) refreshContactsOf(world, body.index);
    return Done{};
}

Result<Done> setVelocity(World& world, BodyId body, Vec2 velocity) {
    const auto checked =
        firstOf(checkAlive("setVelocity", world, body), checkVector("setVelocity", velocity, kFastest));
    if (!checked) return checked;
    if (world.bodies.info[body.index].kind == BodyKind::Static) return Done{};
    if (velocity != Vec2{}) wakeForMotion(world, body.index);
    world.bodies.motion[body.index].velocity = velocity;
    return Done{};
}

Result<Done> setAngularVelocity(World& world, BodyId body, float velocity) {
    const auto checked = firstOf(checkAlive("setAngularVelocity", world, body),
                                 checkNumber("setAngularVelocity", velocity, -kFastest, kFastest));
    if (!checked) return checked;
    const BodyInfo& info = world.bodies.info[body.index];
    if (info.kind == BodyKind::Static || isHeldUpright(info)) return Done{};
    if (velocity != 0.0f) wakeForMotion(world, body.index);
    world.bodies.motion[body.index].angularVelocity = velocity;
    return Done{};
}

Result<Done> setAcceleration(World& world, BodyId body, Vec2 acceleration) {
    const auto checked = firstOf(checkAlive("setAcceleration", world, body),
                                 checkVector("setAcceleration", acceleration, kFastest));
    if (!checked) return checked;
    if (acceleration == world.bodies.driveOf(body.index).acceleration) return Done{};
    wake(world, body.index);
    world.bodies.ownDriveOf(body.index).acceleration = acceleration;
    return Done{};
}

Result<Done> setGravityScale(World& world, BodyId body, float scale) {
    const auto checked = firstOf(checkAlive("setGravityScale", world, body),
                                 checkNumber("setGravityScale", scale, -kFastest, kFastest));
    if (!checked) return checked;
    if (scale == world.bodies.driveOf(body.index).gravityScale) return Done{};
    wake(world, body.index);
    change(world, body, [&] { world.bodies.ownDriveOf(body.index).gravityScale = scale; });
    return Done{};
}

Result<Done> setDrag(World& world, BodyId body, float linear, float angular) {
    const auto checked =
        firstOf(checkAlive("setDrag", world, body), checkNumber("setDrag linear", linear, 0.0, kFastest),
                checkNumber("setDrag angular", angular, 0.0, kFastest));
    if (!checked) return checked;
    const BodyDrive& drive = world.bodies.driveOf(body.index);
    if (linear == drive.linearDrag && angular == drive.angularDrag) return Done{};
    change(world, body, [&] {
        BodyDrive& own = world.bodies.ownDriveOf(body.index);
        own.linearDrag = linear;
        own.angularDrag = angular;
    });
    return Done{};
}

Result<Done> setMass(World& world, BodyId body, float mass) {
    const auto checked =
        firstOf(checkAlive("setMass", world, body), checkNumber("setMass", mass, 0.0, kStrongest));
    if (!checked) return checked;
    if (!isDynamic(world, body)) return Done{};
    BodyInfo& info = world.bodies.info[body.index];
    const float wanted = mass > 0.0f ? std::max(mass, kLightest) : 0.0f;
    if (wanted != ((info.owned & kSetMass) != 0 ? massOf(world, body) : 0.0f)) wake(world, body.index);
    info.owned = static_cast<std::uint8_t>((info.owned & kBodyOff) | (wanted > 0.0f ? kSetMass : 0));
    world.bodies.mass[body.index].mass = wanted;
    updateMassInContact(world, body.index);
    return Done{};
}

Result<Done> setQuality(World& world, BodyId body, Quality quality) {
    const auto checked = firstOf(checkAlive("setQuality", world, body), checkQuality("setQuality", quality));
    if (!checked) return checked;
    change(world, body, [&] { world.bodies.info[body.index].quality = quality; });
    return Done{};
}

Result<Done> applyForce(World& world, BodyId body, Vec2 force) {
    const auto checked =
        firstOf(checkAlive("applyForce", world, body), checkVector("applyForce", force, kStrongest));
    if (!checked) return checked;
    if (!isDynamic(world, body)) return Done{};
    wake(world, body.index);
    world.bodies.ownDriveOf(body.index).force += force;
    return Done{};
}

Result<Done> applyForceAt(World& world, BodyId body, Vec2 force, WorldPosition point) {
    if (const auto checked = checkPlace("applyForceAt point", point); !checked) return checked;
    const Result<Done> applied = applyForce(world, body, force);
    if (!applied || !isDynamic(world, body)) return applied;
    world.bodies.ownDriveOf(body.index).torque += cross(point - world.bodies.pose[body.index].centre, force);
    return applied;
}

Result<Done> applyTorque(World& world, BodyId body, float torque) {
    const auto checked = firstOf(checkAlive("applyTorque", world, body),
                                 checkNumber("applyTorque", torque, -kStrongest, kStrongest));
    if (!checked) return checked;
    if (!isDynamic(world, body)) return Done{};
    wake(world, body.index);
    world.bodies.ownDriveOf(body.index).torque += torque;
    return Done{};
}

Result<Done> applyImpulse(World& world, BodyId body, Vec2 impulse) {
    const auto checked =
        firstOf(checkAlive("applyImpulse", world, body), checkVector("applyImpulse", impulse, kStrongest));
    if (!checked) return checked;
    if (!isDynamic(world, body)) return Done{};
    wake(world, body.index);
    world.bodies.motion[body.index].velocity += world.bodies.mass[body.index].inverseMass * impulse;
    return Done{};
}

Result<Done> applyAngularImpulse(World& world, BodyId body, float impulse) {
    const auto checked = firstOf(checkAlive("applyAngularImpulse", world, body),
                                 checkNumber("applyAngularImpulse", impulse, -kStrongest, kStrongest));
    if (!checked || !isDynamic(world, body)) return checked;
    wake(world, body.index);
    world.bodies.motion[body.index].angularVelocity += world.bodies.mass[body.index].inverseInertia * impulse;
    return Done{};
}

void clearForces(World& world, BodyId body) {
    if (!mayChange(world, body) || world.bodies.info[body.index].drive == kNone) return;
    BodyDrive& drive = world.bodies.ownDriveOf(body.index);
    drive.force = {};
    drive.torque = 0.0f;
}

Result<Done> setSleepSpeed(World& world, BodyId body, float speed) {
    const auto checked =
        firstOf(checkAlive("setSleepSpeed", world, body), checkNumber("setSleepSpeed", speed, 0.0, kFastest));
    if (!checked) return checked;
    if (speed < std::exchange(world.bodies.info[body.index].sleepSpeed, speed)) wake(world, body.index);
    return Done{};
}

Result<Done> applyImpulseAt(World& world, BodyId body, Vec2 impulse, WorldPosition point) {
    if (const auto checked = checkPlace("applyImpulseAt point", point); !checked) return checked;
    const Result<Done> applied = applyImpulse(world, body, impulse);
    if (!applied || !isDynamic(world, body)) return applied;
    world.bodies.motion[body.index].angularVelocity +=
        world.bodies.mass[body.index].inverseInertia *
        cross(point - world.bodies.pose[body.index].centre, impulse);
    return applied;
}

Result<Done> moveTo(World& world, BodyId body, WorldPosition position, float angle, float dt) {
    const auto checked = firstOf(checkAlive("moveTo", world, body), checkPlace("moveTo", position),
                                 checkNumber("moveTo angle", angle, -1.0e5, 1.0e5),
                                 checkNumber("moveTo dt", dt, 1.0e-6, 1.0e6));
    if (!checked) return checked;
    if (world.bodies.info[body.index].kind != BodyKind::Kinematic) {
        return wrong("moveTo", "expected a kinematic body, found one of another kind",
                     "set the velocity of a dynamic body, or the position of a static one");
    }
    const BodyPose& pose = world.bodies.pose[body.index];
    const Rot target = rotFromAngle(angle);
    BodyMotion& motion = world.bodies.motion[body.index];
    const Vec2 velocity = (position + rotate(target, pose.localCentre) - pose.centre) / dt;
    const float spin = angleOf(between(pose.rotation, target)) / dt;
    if (velocity != Vec2{} || spin != 0.0f) wakeForMotion(world, body.index);
    motion.velocity = velocity;
    motion.angularVelocity = spin;
    world.bodies.info[body.index].flags |= kHasTarget;
    return Done{};
}

void setAwake(World& world, BodyId body, bool awake) {
    if (!mayChange(world, body)) return;
    awake ? wake(world, body.index) : sleepNow(world, body.index);
}

void setFixedRotation(World& world, BodyId body, bool fixed) {
    if (!mayChange(world, body)) return;
    BodyInfo& info = world.bodies.info[body.index];
    if (fixed == ((info.flags & kFixedRotation) != 0)) return;
    change(world, body, [&] {
        info.flags =
            static_cast<std::uint8_t>(fixed ? info.flags | kFixedRotation : info.flags & ~kFixedRotation);
    });
    wake(world, body.index);
    if (isHeldUpright(info)) world.bodies.motion[body.index].angularVelocity = 0.0f;
    updateMass(world, body.index);
    refreshContactsOf(world, body.index);
}

void setBullet(World& world, BodyId body, bool bullet) {
    if (!mayChange(world, body)) return;
    std::uint8_t& flags = world.bodies.info[body.index].flags;
    flags = static_cast<std::uint8_t>(bullet ? flags | kBullet : flags & ~kBullet);
}

void setCanSleep(World& world, BodyId body, bool canSleep) {
    if (!mayChange(world, body)) return;
    change(world, body, [&] {
        std::uint8_t& flags = world.bodies.info[body.index].flags;
        flags = static_cast<std::uint8_t>(canSleep ? flags | kCanSleep : flags & ~kCanSleep);
    });
    if (!canSleep) wake(world, body.index);
}

void setLocks(World& world, BodyId body, bool lockX, bool lockY) {
    if (!mayChange(world, body)) return;
    change(world, body, [&] {
        std::uint8_t& flags = world.bodies.info[body.index].flags;
        flags = static_cast<std::uint8_t>((flags & ~(kLockX | kLockY)) | (lockX ? kLockX : 0) |
                                          (lockY ? kLockY : 0));
    });
    world.work.get().joints.trees.stale = true;
    wake(world, body.index);
}

void setDropThrough(World& world, BodyId body, bool drops) {
    if (!mayChange(world, body)) return;
    std::uint8_t& flags = world.bodies.info[body.index].flags;
    if (drops == ((flags & kDropsThrough) != 0)) return;
    flags = static_cast<std::uint8_t>(drops ? flags | kDropsThrough : flags & ~kDropsThrough);
    wake(world, body.index);
}

}  // namespace plumb::physics
