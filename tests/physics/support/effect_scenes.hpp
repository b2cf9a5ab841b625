#pragma once

#include <array>
#include <cstring>

#include "physics/model/fields.hpp"
#include "physics/simulation.hpp"
#include "physics/soft/softbody.hpp"

// For every effect (Effect, a part of the step that runs only if an object requires it): a scene that does
// not require the effect, and a distant object that does. A new effect needs a case in addDistantObject().

namespace plumb::physics::test {

inline constexpr int kCrates = 30;

/// Builds a pile of boxes and discs that does not require the effect `omitted`, nor any rarely used effect.
inline World makeSceneWithout(Effect omitted) {
    World world;
    world.settings.sleeping = false;
    world.settings.continuous = omitted != Effect::Continuous;
    ShapeDefinition shape;
    if (omitted == Effect::Friction) shape.friction = 0.0f;
    if (omitted == Effect::ContactEvents) shape.reportsContacts = false;
    const BodyId floor = *createBody(world, {.kind = BodyKind::Static, .position = {0.0, 1.0}});
    static_cast<void>(createShape(world, floor, box({100.0f, 1.0f}), shape));
    for (int i = 0; i < kCrates; ++i) {
        BodyDefinition body;
        body.position = {-3.0 + 0.7 * (i % 7), -0.6 - 0.9 * (i / 7)};
        body.fixedRotation = omitted == Effect::Rotation;
        body.canSleep = omitted != Effect::Sleep;
        if (omitted == Effect::Gravity) body.gravityScale = 0.0f, body.acceleration = {0.0f, 10.0f};
        const BodyId crate = *createBody(world, body);
        if (omitted == Effect::Contacts) continue;
        const Geometry outline = i % 2 == 0 ? box({0.3f, 0.4f}) : circle(0.35f);
        static_cast<void>(createShape(world, crate, outline, shape));
    }
    return world;
}

/// Creates objects far away from the rest of the scene.
struct Remote {
    World& world;
    BodyDefinition body{
        .position = {5000.0, -5000.0}, .gravityScale = 0.0f, .fixedRotation = true, .canSleep = false};
    ShapeDefinition shape{.friction = 0.0f, .reportsContacts = false};
    FieldDefinition field{.region = RegionKind::Circle, .place = {9000.0, -9000.0}};

    BodyId bare() const { return *createBody(world, body); }
    BodyId solid() const {
        const BodyId made = bare();
        static_cast<void>(createShape(world, made, box({0.5f, 0.5f}), shape));
        return made;
    }
    void make(FieldKind kind) {
        field.kind = kind;
        static_cast<void>(createField(world, field));
    }
    void tie(bool motor) {
        const BodyId a = bare();
        body.position.x += 1.0;
        static_cast<void>(
            createJoint(world, {.a = a, .b = bare(), .anchorA = {1.0f, 0.0f}, .motor = {motor, 0.0f, 1.0f}}));
    }
};

/// Adds a distant object that requires an effect. @return false if this function lacks a case for the effect
inline bool addDistantObject(World& world, Effect effect) {
    Remote far{world};
    switch (effect) {
        case Effect::Gravity: far.body.gravityScale = 1.0f; break;
        case Effect::Rotation: far.body.fixedRotation = false; break;
        case Effect::Drag: far.body.linearDrag = 1.0f; break;
        case Effect::Kinematics: far.body.kind = BodyKind::Kinematic; break;
        case Effect::Locks: far.body.lockX = true; break;
        case Effect::Sleep: world.settings.sleeping = far.body.canSleep = true; break;
        case Effect::Continuous: world.settings.continuous = true; break;
        case Effect::Contacts: break;
        case Effect::Friction: far.shape.friction = 0.5f; break;
        case Effect::Restitution: far.shape.bounciness = 0.5f; break;
        case Effect::Rolling: far.shape.rollingResistance = 0.5f; break;
        case Effect::Triggers: far.shape.isTrigger = true; break;
        case Effect::ContactEvents: far.shape.reportsContacts = true; break;
        case Effect::OneWay: far.shape.oneWay = true; break;
        case Effect::Conveyor: far.shape.surfaceSpeed = 1.0f; break;
        case Effect::Joints: return far.tie(false), true;
        case Effect::Motors: return far.tie(true), true;
        case Effect::AreaGravity: return far.make(FieldKind::AreaGravity), true;
        case Effect::Wind: return far.make(FieldKind::Wind), true;
        case Effect::Buoyancy: return far.make(FieldKind::Buoyancy), true;
        case Effect::Attractor: return far.make(FieldKind::Attractor), true;
        case Effect::Explosion: return far.make(FieldKind::Explosion), true;
        case Effect::Springs:
            far.field.a = far.bare();
            far.field.place = far.body.position;
            far.field.strength = 1.0f;
            return far.make(FieldKind::Spring), true;
        case Effect::SoftBodies: return createRope(world, {5000.0, 0.0}, {5001.0, 0.0}, 3).ok();
        case Effect::Count: return false;
    }
    far.solid();
    return true;
}

/// Makes the world run an effect that no object requires.
inline void pinEffectOn(World& world, Effect effect) {
    world.manifest.pinnedOn |= Manifest::bit(effect);
    if (effect == Effect::Continuous) world.settings.continuous = true;
    if (effect == Effect::Sleep) world.settings.sleeping = true;
}

/// True if poses and velocities of the floor and the pile are equal bit for bit; ignores distant objects.
inline bool samePile(const World& a, const World& b) {
    const std::size_t count = kCrates + 1;
    return std::memcmp(a.bodies.pose.data(), b.bodies.pose.data(), count * sizeof(BodyPose)) == 0 &&
           std::memcmp(a.bodies.motion.data(), b.bodies.motion.data(), count * sizeof(BodyMotion)) == 0;
}

inline std::array<Effect, kEffects> allEffects() {
    std::array<Effect, kEffects> effects;
    for (std::size_t i = 0; i < kEffects; ++i) effects[i] = static_cast<Effect>(i);
    return effects;
}

}  // namespace plumb::physics::test
