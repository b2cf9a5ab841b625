#include "physics/model/bodies.hpp"

#include <algorithm>

#include "physics/bounds.hpp"
#include "physics/contacts/contacts.hpp"
#include "physics/effects/drag.hpp"
#include "physics/islands/sleeping.hpp"
#include "physics/model/checks.hpp"
#include "physics/model/joints.hpp"
#include "physics/model/shapes.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

Result<Done> check(const BodyDefinition& definition) {
    return firstOf(
        checkKind("BodyDefinition.kind", definition.kind),
        checkPosition("BodyDefinition.position", definition.position),
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

std::uint8_t flagsOf(const BodyDefinition& definition) {
    return static_cast<std::uint8_t>((definition.bullet ? kBullet : 0) |
                                     (definition.canSleep ? kCanSleep : 0) |
                                     (definition.fixedRotation ? kFixedRotation : 0) |
                                     (definition.lockX ? kLockX : 0) | (definition.lockY ? kLockY : 0));
}

/// Changes a property on which the effects of a body depend, and updates the manifest.
template <class Change>
void change(World& world, BodyId body, Change&& change) {
    countEffectsOfBody(world, body.index, -1);
    change();
    countEffectsOfBody(world, body.index, 1);
}

/// Changes BodyDrive of a body. A changed acceleration wakes it.
template <class Change>
Result<Done> setDrive(World& world, const char* where, BodyId body, const Result<Done>& value, Change&& set) {
    const auto checked = firstOf(checkAlive(where, world, body), value);
    if (!checked) return checked;
    const BodyDrive before = world.bodies.driveOf(body.index);
    BodyDrive drive = before;
    set(drive);
    if (drive == before) return checked;
    if (drive.acceleration != before.acceleration || drive.gravityScale != before.gravityScale)
        wake(world, body.index);
    change(world, body, [&] { world.bodies.ownDriveOf(body.index) = drive; });
    return checked;
}

/// Changes the forces or the motion of a dynamic body by add(), and wakes the body.
template <class Add>
Result<Done> push(World& world, const char* where, BodyId body, const Result<Done>& value, Add&& add) {
    const auto checked = firstOf(checkAlive(where, world, body), value);
    if (!checked || !isDynamic(world, body.index)) return checked;
    wake(world, body.index);
    add();
    return checked;
}

/// @return false if the flag has this value already, or the body was destroyed
bool setFlag(World& world, BodyId body, BodyFlag flag, bool on) {
    if (!mayChange(world, body)) return false;
    std::uint8_t& flags = world.bodies.info[body.index].flags;
    if (on == ((flags & flag) != 0)) return false;
    change(world, body, [&] { flags ^= flag; });
    return true;
}

bool isHeldUpright(const BodyInfo& info) {
    return info.kind == BodyKind::Dynamic && (info.flags & kFixedRotation) != 0;
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

Result<BodyId> createBody(World& world, const BodyDefinition& definition) {
    if (const auto checked = firstOf(checkOutside("createBody", world), check(definition)); !checked)
        return checked.error();
    Bodies& bodies = world.bodies;
    const std::uint32_t index = takeIndex(bodies.free, bodies.info, bodies.pose, bodies.motion, bodies.mass);
    world.sleepers.nextBody.resize(bodies.size(), kNone);
    world.sleepers.islandOf.resize(bodies.size(), kNone);
    BodyInfo& info = bodies.info[index];
    info = {.generation = info.generation + 1,
            .kind = definition.kind,
            .flags = flagsOf(definition),
            .quality = definition.quality,
            .island = index,
            .sleepSpeed = definition.sleepSpeed,
            .user = definition.user};
    bodies.pose[index] = {definition.position, rotFromAngle(definition.angle), {}};
    bodies.motion[index] = {definition.velocity, definition.angularVelocity, 0.0f};
    if (index < bodies.substepControllers.size()) bodies.substepControllers[index] = {};
    if (index < bodies.energies.size()) bodies.energies[index] = {};
    const BodyDrive drive{.acceleration = definition.acceleration,
                          .gravityScale = definition.gravityScale,
                          .linearDrag = definition.linearDrag,
                          .angularDrag = definition.angularDrag};
    if (!(drive == BodyDrive{})) bodies.ownDriveOf(index) = drive;
    if (definition.kind == BodyKind::Static) bodies.motion[index] = {};
    if (isHeldUpright(info)) bodies.motion[index].angularVelocity = 0.0f;
    updateMass(world, index);
    countEffectsOfBody(world, index, 1);
    const bool isAwake = definition.awake || definition.kind == BodyKind::Kinematic;
    if (definition.kind != BodyKind::Static) isAwake ? addAwake(world, index) : addAsleep(world, index);
    return BodyId{index, info.generation};
}

void destroyBody(World& world, BodyId body) {
    if (!mayChange(world, body)) return;
    wake(world, body.index);
    BodyInfo& info = world.bodies.info[body.index];
    while (info.firstJoint != kNone) destroyJoint(world, idOfJoint(world, info.firstJoint));
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

FreeMotion freeMotionOf(const World& world, std::uint32_t body, float dt) {
    const BodyInfo& info = world.bodies.info[body];
    const BodyMotion& motion = world.bodies.motion[body];
    if (info.kind != BodyKind::Dynamic) return {dt * motion.velocity, dt * motion.angularVelocity};
    const BodyMass& mass = world.bodies.mass[body];
    const BodyDrive& drive = world.bodies.driveOf(body);
    const Vec2 gravity = world.manifest.runs(Effect::Gravity) ? world.settings.gravity : Vec2{};
    const Vec2 pull = drive.gravityScale * gravity + drive.acceleration + mass.inverseMass * drive.force;
    const float spin = mass.inverseInertia * drive.torque;
    FreeMotion free{
        decayOf(drive.linearDrag, dt).drive * motion.velocity + distanceUnder(drive.linearDrag, dt) * pull,
        decayOf(drive.angularDrag, dt).drive * motion.angularVelocity +
            distanceUnder(drive.angularDrag, dt) * spin};
    free.displacement = unlocked(world, body, free.displacement);
    return free;
}

Frame predictTransform(const World& world, BodyId body, float dt) {
    constexpr float kFarthestAhead = 1.0e6f;  // s
    if (!alive(world, body)) return {};
    const FreeMotion free =
        freeMotionOf(world, body.index, std::isnan(dt) ? 0.0f : std::clamp(dt, 0.0f, kFarthestAhead));
    const BodyPose& pose = world.bodies.pose[body.index];
    const Rot rotation = normalized(rotFromAngle(free.angle) * pose.rotation);
    return {toVec2(pose.centre + free.displacement) - rotate(rotation, pose.localCentre), rotation};
}

Result<Done> setPosition(World& world, BodyId body, WorldPosition position, float angle) {
    const auto checked =
        firstOf(checkAlive("setPosition", world, body), checkPosition("setPosition", position),
                checkNumber("setPosition angle", angle, -1.0e5, 1.0e5));
    if (!checked) return checked;
    wakeTouching(world, body.index);
    BodyPose& pose = world.bodies.pose[body.index];
    const Rot before = std::exchange(pose.rotation, rotFromAngle(angle));
    pose.centre = position + rotate(pose.rotation, pose.localCentre);
    refreshBounds(world, body.index);
    forJointsOf(world, body.index, [&](std::uint32_t j) { world.joints.hot[j].flags |= kEdited; });
    // Contacts of bodies that cannot rotate assume a constant rotation (kAlongAxes).
    if (!(pose.rotation == before) && !canRotate(world, body.index)) refreshContactsOf(world, body.index);
    return Done{};
}

Result<Done> setVelocity(World& world, BodyId body, Vec2 velocity) {
    const auto checked =
        firstOf(checkAlive("setVelocity", world, body), checkVector("setVelocity", velocity, kFastest));
    if (!checked || world.bodies.info[body.index].kind == BodyKind::Static) return checked;
    if (velocity != Vec2{}) wakeForMotion(world, body.index);
    world.bodies.motion[body.index].velocity = velocity;
    return checked;
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
    return setDrive(world, "setAcceleration", body, checkVector("setAcceleration", acceleration, kFastest),
                    [&](BodyDrive& drive) { drive.acceleration = acceleration; });
}

Result<Done> setGravityScale(World& world, BodyId body, float scale) {
    return setDrive(world, "setGravityScale", body,
                    checkNumber("setGravityScale", scale, -kFastest, kFastest),
                    [&](BodyDrive& drive) { drive.gravityScale = scale; });
}

Result<Done> setDrag(World& world, BodyId body, float linear, float angular) {
    const auto checked = firstOf(checkNumber("setDrag linear", linear, 0.0, kFastest),
                                 checkNumber("setDrag angular", angular, 0.0, kFastest));
    return setDrive(world, "setDrag", body, checked, [&](BodyDrive& drive) {
        drive.linearDrag = linear;
        drive.angularDrag = angular;
    });
}

Result<Done> setMass(World& world, BodyId body, float mass) {
    const auto checked =
        firstOf(checkAlive("setMass", world, body), checkNumber("setMass", mass, 0.0, kStrongest));
    if (!checked || !isDynamic(world, body.index)) return checked;
    BodyInfo& info = world.bodies.info[body.index];
    const float wanted = mass > 0.0f ? std::max(mass, kLightest) : 0.0f;
    if (wanted != ((info.owned & kSetMass) != 0 ? massOf(world, body) : 0.0f)) wake(world, body.index);
    info.owned = static_cast<std::uint8_t>((info.owned & kBodyOff) | (wanted > 0.0f ? kSetMass : 0));
    world.bodies.mass[body.index].mass = wanted;
    updateMass(world, body.index);
    return checked;
}

Result<Done> setQuality(World& world, BodyId body, Quality quality) {
    const auto checked = firstOf(checkAlive("setQuality", world, body), checkQuality("setQuality", quality));
    if (checked) change(world, body, [&] { world.bodies.info[body.index].quality = quality; });
    return checked;
}

Result<Done> applyForce(World& world, BodyId body, Vec2 force) {
    return push(world, "applyForce", body, checkVector("applyForce", force, kStrongest),
                [&] { world.bodies.ownDriveOf(body.index).force += force; });
}

Result<Done> applyForceAt(World& world, BodyId body, Vec2 force, WorldPosition point) {
    if (const auto checked = checkPosition("applyForceAt point", point); !checked) return checked;
    const Result<Done> applied = applyForce(world, body, force);
    if (!applied || !isDynamic(world, body.index)) return applied;
    world.bodies.ownDriveOf(body.index).torque += cross(point - world.bodies.pose[body.index].centre, force);
    return applied;
}

Result<Done> applyTorque(World& world, BodyId body, float torque) {
    return push(world, "applyTorque", body, checkNumber("applyTorque", torque, -kStrongest, kStrongest),
                [&] { world.bodies.ownDriveOf(body.index).torque += torque; });
}

Result<Done> applyImpulse(World& world, BodyId body, Vec2 impulse) {
    return push(world, "applyImpulse", body, checkVector("applyImpulse", impulse, kStrongest), [&] {
        world.bodies.motion[body.index].velocity += world.bodies.mass[body.index].inverseMass * impulse;
    });
}

Result<Done> applyAngularImpulse(World& world, BodyId body, float impulse) {
    return push(world, "applyAngularImpulse", body,
                checkNumber("applyAngularImpulse", impulse, -kStrongest, kStrongest), [&] {
                    world.bodies.motion[body.index].angularVelocity +=
                        world.bodies.mass[body.index].inverseInertia * impulse;
                });
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
    if (const auto checked = checkPosition("applyImpulseAt point", point); !checked) return checked;
    const Result<Done> applied = applyImpulse(world, body, impulse);
    if (!applied || !isDynamic(world, body.index)) return applied;
    world.bodies.motion[body.index].angularVelocity +=
        world.bodies.mass[body.index].inverseInertia *
        cross(point - world.bodies.pose[body.index].centre, impulse);
    return applied;
}

Result<Done> moveTo(World& world, BodyId body, WorldPosition position, float angle, float dt) {
    const auto checked = firstOf(checkAlive("moveTo", world, body), checkPosition("moveTo", position),
                                 checkNumber("moveTo angle", angle, -1.0e5, 1.0e5),
                                 checkNumber("moveTo dt", dt, 1.0e-6, 1.0e6));
    if (!checked) return checked;
    if (world.bodies.info[body.index].kind != BodyKind::Kinematic) {
        return usageError("moveTo", "expected a kinematic body, found a static or dynamic one",
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
    if (!setFlag(world, body, kFixedRotation, fixed)) return;
    wake(world, body.index);
    if (isHeldUpright(world.bodies.info[body.index])) world.bodies.motion[body.index].angularVelocity = 0.0f;
    updateMass(world, body.index);
    refreshContactsOf(world, body.index);
}

void setBullet(World& world, BodyId body, bool bullet) { setFlag(world, body, kBullet, bullet); }

void setCanSleep(World& world, BodyId body, bool canSleep) {
    if (setFlag(world, body, kCanSleep, canSleep) && !canSleep) wake(world, body.index);
}

void setLocks(World& world, BodyId body, bool lockX, bool lockY) {
    if (!mayChange(world, body)) return;
    setFlag(world, body, kLockX, lockX);
    setFlag(world, body, kLockY, lockY);
    world.work.get().joints.trees.stale = true;
    wake(world, body.index);
}

void setDropThrough(World& world, BodyId body, bool drops) {
    if (setFlag(world, body, kDropsThrough, drops)) wake(world, body.index);
}

Result<Done> setKind(World& world, BodyId id, BodyKind kind) {
    const auto checked = firstOf(checkAlive("setKind", world, id), checkKind("setKind", kind));
    if (!checked) return checked;
    const std::uint32_t body = id.index;
    BodyInfo& info = world.bodies.info[body];
    if (kind == info.kind) return Done{};
    const auto kindOf = [&](std::uint32_t i) { return i == body ? kind : world.bodies.info[i].kind; };
    bool holds = true;
    forJointsOf(world, body, [&](std::uint32_t j) {
        const Joint& joint = world.joints.hot[j];
        holds &= canActOn(joint.kind, kindOf(joint.bodyA), kindOf(joint.bodyB));
    });
    if (!holds)
        return usageError("setKind", "one of the body's joints would have no dynamic body",
                          "destroy this joint first");
    wakeTouching(world, body);
    forJointsOf(world, body, [&](std::uint32_t j) {
        releaseColour(world, j);
        world.joints.hot[j].colour = kNoColour;
        world.newJoints = true;
    });
    forShapesOf(world, body, [&](std::uint32_t s) { countEffectsOfShape(world, s, -1); });
    countEffectsOfBody(world, body, -1);
    removeAwake(world, body);
    info.kind = kind;
    info.flags &= static_cast<std::uint8_t>(~(kHasTarget | kMoved));
    info.owned &= kBodyOff;
    countEffectsOfBody(world, body, 1);
    forShapesOf(world, body, [&](std::uint32_t s) { countEffectsOfShape(world, s, 1); });
    updateMass(world, body);
    BodyMotion& motion = world.bodies.motion[body];
    if (kind == BodyKind::Static) motion = {};
    if (isHeldUpright(info)) motion.angularVelocity = 0.0f;
    motion.restTime = 0.0f;
    if (kind != BodyKind::Static && isEnabled(world, id)) addAwake(world, body);
    forShapesOf(world, body, [&](std::uint32_t s) { alter(world, s); });
    forJointsOf(world, body, [&](std::uint32_t j) { joinIslandsOf(world, world.joints.hot[j]); });
    world.islandsStale |= info.firstJoint != kNone;
    return Done{};
}

void setEnabled(World& world, BodyId id, bool enabled) {
    if (!mayChange(world, id) || enabled == isEnabled(world, id)) return;
    const std::uint32_t body = id.index;
    wakeTouching(world, body);
    if (!enabled) forJointsOf(world, body, [&](std::uint32_t j) { removeAwakeJoint(world, j); });
    removeAwake(world, body);
    BodyInfo& info = world.bodies.info[body];
    info.owned ^= kBodyOff;
    forShapesOf(world, body, [&](std::uint32_t s) { world.shapes.info[s].flags ^= kShapeOff; });
    if (enabled && info.kind != BodyKind::Static) addAwake(world, body);
    forShapesOf(world, body, [&](std::uint32_t s) { alter(world, s); });
    world.islandsStale |= info.firstJoint != kNone;
    if (!enabled) return;
    forJointsOf(world, body, [&](std::uint32_t j) {
        const Joint& joint = world.joints.hot[j];
        wake(world, joint.bodyA);
        wake(world, joint.bodyB);
        addAwakeJoint(world, j);
        joinIslandsOf(world, joint);
    });
    world.newJoints = true;
}

Result<Done> setMassData(World& world, BodyId body, const MassData& data) {
    const auto checked = firstOf(checkAlive("setMassData", world, body),
                                 checkNumber("MassData.mass", data.mass, 0.0, kStrongest),
                                 checkVector("MassData.centre", data.centre, kLargest),
                                 checkNumber("MassData.inertia", data.inertia, 0.0, kStrongest));
    if (!checked || !isDynamic(world, body.index)) return checked;
    if (data.mass == 0.0f) return setMass(world, body, 0.0f);
    wake(world, body.index);
    world.bodies.info[body.index].owned |= kSetMass | kSetMassData;
    world.bodies.mass[body.index].mass = data.mass;
    world.bodies.mass[body.index].inertia = data.inertia;
    moveCentre(world, body.index, data.centre);
    updateMass(world, body.index);
    return checked;
}

}  // namespace plumb::physics
