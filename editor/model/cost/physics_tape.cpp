#include "editor/model/cost/physics_tape.hpp"

#include <algorithm>
#include <cmath>

#include "physics/bounds.hpp"
#include "physics/model/fields.hpp"
#include "physics/model/joints.hpp"

namespace plumb::editor {
namespace {

using physics::BodyKind;

constexpr float kTurnsToRest = 0.05f;  // rad/s; a body that rotates faster is not at rest

bool has(std::uint8_t flags, std::uint8_t flag) { return (flags & flag) != 0; }

bool isThere(const physics::Bodies& bodies, std::uint32_t body) {
    return body < bodies.size() && bodies.info[body].kind != BodyKind::None;
}

/// True if both worlds have the same body (equal generation) in this slot.
bool isSame(const physics::Bodies& a, const physics::Bodies& b, std::uint32_t body) {
    return isThere(a, body) && isThere(b, body) && a.info[body].generation == b.info[body].generation;
}

std::uint8_t changesOf(const physics::Bodies& before, const physics::Bodies& now, std::uint32_t body) {
    std::uint8_t changed = 0;
    const physics::BodyPose &poseBefore = before.pose[body], &pose = now.pose[body];
    if (!(pose.centre == poseBefore.centre) || !(pose.rotation == poseBefore.rotation))
        changed |= BodyInput::Placed;
    const physics::BodyMotion &motionBefore = before.motion[body], &motion = now.motion[body];
    const std::uint8_t flags = now.info[body].flags;
    if (motion.velocity != motionBefore.velocity || motion.angularVelocity != motionBefore.angularVelocity ||
        has(flags, physics::kHasTarget))
        changed |= BodyInput::Pushed;
    if (!(before.driveOf(body) == now.driveOf(body))) changed |= BodyInput::Driven;
    if (has(flags, physics::kDropsThrough) != has(before.info[body].flags, physics::kDropsThrough))
        changed |= BodyInput::DropsThrough;
    return changed;
}

void place(physics::World& world, std::uint32_t body, const physics::BodyPose& pose) {
    world.bodies.pose[body].centre = pose.centre;
    world.bodies.pose[body].rotation = pose.rotation;
    physics::refreshBounds(world, body);
}

void push(physics::World& world, const BodyInput& input) {
    static_cast<void>(setVelocity(world, input.body, input.motion.velocity));
    static_cast<void>(setAngularVelocity(world, input.body, input.motion.angularVelocity));
    if (input.hasTarget) world.bodies.info[input.body.index].flags |= physics::kHasTarget;
}

void applyForces(physics::World& world, const BodyInput& input) {
    if (input.drive.force != Vec2{}) static_cast<void>(applyForce(world, input.body, input.drive.force));
    if (input.drive.torque != 0.0f) static_cast<void>(applyTorque(world, input.body, input.drive.torque));
}

void applyBody(physics::World& world, const BodyInput& input, int part) {
    if (!alive(world, input.body)) return;
    if (part > 0) {
        if (input.hasTarget) push(world, input);
        return applyForces(world, input);
    }
    if (has(input.changed, BodyInput::Gone)) return destroyBody(world, input.body);
    if (has(input.changed, BodyInput::Placed)) place(world, input.body.index, input.pose);
    if (has(input.changed, BodyInput::Pushed)) push(world, input);
    if (has(input.changed, BodyInput::DropsThrough)) setDropThrough(world, input.body, input.dropsThrough);
    if (!has(input.changed, BodyInput::Driven)) return;
    const physics::BodyDrive& drive = input.drive;
    static_cast<void>(setAcceleration(world, input.body, drive.acceleration));
    static_cast<void>(setGravityScale(world, input.body, drive.gravityScale));
    static_cast<void>(setDrag(world, input.body, drive.linearDrag, drive.angularDrag));
    applyForces(world, input);
}

void applyJoint(physics::World& world, const JointInput& input) {
    if (!alive(world, input.joint)) return;
    if (input.gone) return destroyJoint(world, input.joint);
    static_cast<void>(setMotorSpeed(world, input.joint, input.motorSpeed));
    static_cast<void>(setTarget(world, input.joint, input.target));
}

void applyField(physics::World& world, const FieldInput& input) {
    if (input.made) {
        static_cast<void>(createField(world, input.definition));
    } else if (input.gone) {
        destroyField(world, input.field);
    } else if (alive(world, input.field)) {
        static_cast<void>(setField(world, input.field, input.definition));
    }
}

/// True if the members of two field definitions that a game can change are equal.
bool looksSame(const physics::FieldDefinition& a, const physics::FieldDefinition& b) {
    return a.place == b.place && a.half == b.half && a.radius == b.radius &&
           a.acceleration == b.acceleration && a.velocity == b.velocity && a.strength == b.strength &&
           a.layers == b.layers;
}

}  // namespace

void applyInput(physics::World& world, const TickInput& input, int part) {
    for (const BodyInput& body : input.bodies) applyBody(world, body, part);
    if (part > 0) return;
    for (const JointInput& joint : input.joints) applyJoint(world, joint);
    for (const FieldInput& field : input.fields) applyField(world, field);
    world.settings.gravity = input.gravity;
}

void TapeRecorder::begin(const physics::World& world, PixelScale scale) {
    tape = {};
    tape.scale = scale;
    for (std::uint32_t body = 0; body < world.bodies.size(); ++body) {
        const physics::BodyInfo& info = world.bodies.info[body];
        if (info.kind != BodyKind::Dynamic) continue;
        WatchedBody& watched = tape.watched.emplace_back();
        watched.body = {body, info.generation};
        watched.reach = info.reach;
        watched.isBullet = has(info.flags, physics::kBullet);
        watched.sleepSpeed = info.sleepSpeed;
    }
    remember(world);
    on = true;
}

void TapeRecorder::keepStart(const physics::World& world) {
    tape.starts.push_back({tape.ticks.size(), world});
}

void TapeRecorder::beforeStep(const physics::World& world) {
    TickInput& input = tape.ticks.emplace_back();
    input.gravity = world.settings.gravity;
    takeBodies(world, input);
    takeJoints(world, input);
    takeFields(world, input);
}

void TapeRecorder::takeBodies(const physics::World& world, TickInput& input) {
    const std::size_t count = std::max(world.bodies.size(), bodies_.size());
    for (std::uint32_t body = 0; body < count; ++body) {
        if (!isSame(bodies_, world.bodies, body)) {
            if (isThere(bodies_, body)) {
                BodyInput& gone = input.bodies.emplace_back();
                gone.body = {body, bodies_.info[body].generation};
                gone.changed = BodyInput::Gone;
            }
            if (isThere(world.bodies, body)) ++tape.leftOut;
            continue;
        }
        const std::uint8_t changed = changesOf(bodies_, world.bodies, body);
        if (changed == 0) continue;
        const physics::BodyInfo& info = world.bodies.info[body];
        input.bodies.push_back({{body, info.generation},
                                changed,
                                world.bodies.pose[body],
                                world.bodies.motion[body],
                                world.bodies.driveOf(body),
                                has(info.flags, physics::kHasTarget),
                                has(info.flags, physics::kDropsThrough)});
    }
}

void TapeRecorder::takeJoints(const physics::World& world, TickInput& input) {
    for (std::uint32_t j = 0; j < std::max(world.joints.size(), joints_.size()); ++j) {
        const bool was = j < joints_.size() && joints_.hot[j].bodyA != physics::kNone;
        const physics::JointId before{j, was ? joints_.hot[j].generation : 0u};
        if (was && !alive(world, before)) {
            input.joints.push_back({before, true, 0.0f, {}});
        } else if (was) {
            const physics::JointDefinition &old = joints_.definition[j], &now = world.joints.definition[j];
            if (old.motor.speed != now.motor.speed || !(old.target == now.target))
                input.joints.push_back({before, false, now.motor.speed, now.target});
        }
        if (j >= world.joints.size()) continue;
        const physics::JointId now{j, world.joints.hot[j].generation};
        if (alive(world, now) && !(was && now == before)) ++tape.leftOut;
    }
}

void TapeRecorder::takeFields(const physics::World& world, TickInput& input) {
    const auto& all = world.fields.all;
    for (std::uint32_t f = 0; f < std::max(all.size(), fields_.all.size()); ++f) {
        const bool was = f < fields_.all.size() && fields_.all[f].isAlive;
        const bool is = f < all.size() && all[f].isAlive;
        const bool same = was && is && fields_.all[f].generation == all[f].generation;
        if (was && !same) input.fields.push_back({{f, fields_.all[f].generation}, true, false, {}});
        if (is && !same) input.fields.push_back({{f, all[f].generation}, false, true, all[f].definition});
        if (same && !looksSame(fields_.all[f].definition, all[f].definition))
            input.fields.push_back({{f, all[f].generation}, false, false, all[f].definition});
    }
}

void TapeRecorder::afterTick(const physics::World& world) {
    for (WatchedBody& watched : tape.watched) {
        if (!alive(world, watched.body)) continue;
        const physics::BodyMotion& motion = world.bodies.motion[watched.body.index];
        const float speed = length(motion.velocity);
        watched.topSpeed = std::max(watched.topSpeed, speed);
        const bool rests = speed < watched.sleepSpeed && std::abs(motion.angularVelocity) < kTurnsToRest;
        watched.restTicks = rests ? watched.restTicks + 1 : 0;
    }
    tape.contacts += world.contacts.size();
    for (const physics::ContactEvent& event : world.events)
        tape.stays += event.phase == physics::ContactPhase::Stayed && !event.isTrigger ? 1u : 0u;
    remember(world);
}

void TapeRecorder::remember(const physics::World& world) {
    bodies_ = world.bodies;
    joints_ = world.joints;
    fields_ = world.fields;
}

}  // namespace plumb::editor
