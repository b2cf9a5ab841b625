#include "scene/physics_bridge.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/profile.hpp"
#include "physics/model/bodies.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/effects.hpp"
#include "scene/physics/body_sync.hpp"
#include "scene/physics/contact_events.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/physics/field_sync.hpp"
#include "scene/physics/joint_sync.hpp"
#include "scene/physics/kinematics.hpp"
#include "scene/physics/physics_threads.hpp"
#include "scene/physics/physics_times.hpp"
#include "scene/physics/publish_bodies.hpp"
#include "scene/physics/soft_grips.hpp"
#include "scene/systems/physics_system.hpp"

namespace plumb {

namespace {

using physics::Effect;
using physics::Manifest;

/// Effects (features of the physics) that a step must or must not run, from the pins of scenes and from the
/// systems GravitySystem, MovementSystem and CollisionSystem; without these, components decide.
struct Calls {
    bool motion = true;     // bodies move; otherwise only velocities change
    std::uint32_t off = 0;  // bits of physics::Manifest: effects that do not run
    std::uint32_t on = 0;   // bits of physics::Manifest: effects that run even if not requested
};

Calls callsOf(World& world) {
    Calls calls;
    const bool gravity = world.hasSystem<GravitySystem>();
    const bool motion = world.hasSystem<MovementSystem>();
    const bool contacts = world.hasSystem<CollisionSystem>();
    calls.off = world.resource<PhysicsSettings>().effectsOff;
    if (const auto* effects = world.service<Effects>()) {
        calls.off |= effects->physicsOff();
        calls.on = effects->physicsOn();
    }
    if (!gravity && !motion && !contacts) return calls;
    if (!gravity) calls.off |= Manifest::bit(Effect::Gravity);
    if (!contacts) calls.off |= Manifest::bit(Effect::Contacts) | Manifest::bit(Effect::Triggers);
    calls.motion = motion || contacts;
    return calls;
}

/// Applies gravity to velocities only, for a world with a GravitySystem but no motion.
void pull(World& world, Vec2 gravity, float dt) {
    for (auto [entity, body] : world.query<RigidBody>()) body.velocity += gravity * (body.gravityScale * dt);
}

template <class Event>
void emitContact(World& world, const PhysicsState& state, const physics::ContactEvent& event) {
    Event out;
    out.a = ownerOf(state, event.a);
    out.b = ownerOf(state, event.b);
    out.normal = event.normal;
    out.point = toPixels(event.point, state.scale);
    out.impulse = std::max(event.impulse, 0.0f) * state.scale.pixels;
    world.emit(out);
}

template <class Event>
void emitOverlap(World& world, const PhysicsState& state, const physics::ContactEvent& event) {
    const auto isTrigger = [&](physics::ShapeId shape) {
        return (state.world.shapes.info[shape.index].flags & physics::kTrigger) != 0;
    };
    const EntityId a = ownerOf(state, event.a), b = ownerOf(state, event.b);
    if (isTrigger(event.shapeA)) world.emit(Event{{a, b}});
    if (isTrigger(event.shapeB)) world.emit(Event{{b, a}});
}

void publishContacts(World& world, const PhysicsState& state) {
    for (const physics::ContactEvent& event : state.world.events) {
        switch (event.phase) {
            case physics::ContactPhase::Began:
                event.isTrigger ? emitOverlap<TriggerEntered>(world, state, event)
                                : emitContact<ContactBegan>(world, state, event);
                break;
            case physics::ContactPhase::Stayed:
                event.isTrigger ? emitOverlap<TriggerStayed>(world, state, event)
                                : emitContact<ContactStayed>(world, state, event);
                break;
            case physics::ContactPhase::Ended:
                event.isTrigger ? emitOverlap<TriggerLeft>(world, state, event)
                                : emitContact<ContactEnded>(world, state, event);
                break;
        }
    }
}

}  // namespace

void syncBodies(World& world, float dt) {
    PhysicsState& state = world.resource<PhysicsState>();
    followComponents(world, state, physicsSettingsOf(world));
    driveKinematics(world, state, dt);
}

void stepPhysics(World& world, float dt) {
    PhysicsState& state = world.resource<PhysicsState>();
    PhysicsTimes* times = world.service<PhysicsTimes>();
    Profile* profile = world.service<Profile>();
    if ((profile == nullptr || !profile->on) && times != nullptr) profile = times->profile();
    const Calls calls = callsOf(world);
    {
        const ProfileScope scope{profile, kPhysicsSync};
        followComponents(world, state, physicsSettingsOf(world));
        driveKinematics(world, state, dt);
        pullSoftBodies(world, state, dt);
        state.world.manifest.pinnedOff = calls.off;
        state.world.manifest.pinnedOn = calls.on;
        state.stepped.assign(state.world.awake.begin(), state.world.awake.end());
    }
    if (!calls.motion) {
        pull(world, toPixels(state.world.settings.gravity, state.scale), dt);
        return;
    }
    PhysicsThreads* threads = world.service<PhysicsThreads>();
    physics::step(state.world, dt, {threads != nullptr ? threads->of(state.world) : nullptr, profile});
    {
        const ProfileScope scope{profile, kPhysicsSync};
        publishBodies(world, state);
        publishContacts(world, state);
        publishBroken(world, state);
        removeExploded(world, state);
        state.mark = world.markChanges();  // the writes above are already synchronized
    }
    if (times != nullptr) times->endStep();
}

physics::BodyId bodyOf(World& world, EntityId entity) {
    return bodyOf(std::as_const(world.resource<PhysicsState>()), entity);
}

void rebuildTileColliders(World& world) {
    for (TileTerrain& terrain : world.resource<PhysicsState>().terrains) terrain.made = 0;
}

}  // namespace plumb
