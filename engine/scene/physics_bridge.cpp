#include "scene/physics_bridge.hpp"

#include <algorithm>
#include <cmath>

#include "core/log.hpp"
#include "core/profile.hpp"
#include "ecs/hierarchy.hpp"
#include "scene/body_sync.hpp"
#include "scene/components/kinematic_body.hpp"
#include "scene/components/rigid_body.hpp"
#include "scene/contact_events.hpp"
#include "scene/physics_state.hpp"
#include "scene/physics_units.hpp"
#include "scene/systems/physics_system.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

namespace {

EntityId entityOf(std::uint64_t user) {
    return {static_cast<std::uint32_t>(user >> 32), static_cast<std::uint32_t>(user)};
}

/// Writes where a body went into the Transform of its entity, through the pose of its parent if it has one.
void placeEntity(World& world, EntityId entity, Vec2 place) {
    Transform* transform = world.find<Transform>(entity);
    if (transform == nullptr) return;
    const EntityId parent = parentOf(std::as_const(world), entity);
    if (!parent) {
        transform->position = place;
        return;
    }
    const Pose pose = worldPose(world, parent);
    transform->position = relativeTo(pose, {place, 0.0f, {1.0f, 1.0f}}).position;
}

void writeRigidBody(World& world, const PhysicsState& state, std::uint32_t index, BodyLink& link) {
    const box_physics::Bodies& bodies = state.world.bodies;
    const bool grounded = (bodies.flags[index] & box_physics::kGrounded) != 0;
    const Vec2 velocity = toPixels(bodies.velocity[index]);
    const RigidBody* known = std::as_const(world).find<RigidBody>(link.entity);
    if (known == nullptr || (known->velocity == velocity && known->grounded == grounded)) return;
    RigidBody& body = world.get<RigidBody>(link.entity);
    body.velocity = link.velocity = velocity;
    body.grounded = grounded;
}

/// Poses and velocities back into the components, only where something changed.
void publishBodies(World& world, PhysicsState& state) {
    const box_physics::Bodies& bodies = state.world.bodies;
    for (const std::uint32_t index : state.world.work.movers) {
        BodyLink& link = state.links[index];
        const bool moved = (bodies.flags[index] & box_physics::kMoved) != 0;
        const Vec2 place = toPixels(bodies.position[index]);
        if (moved && place != link.place) {
            const bool driven = bodies.kind[index] == box_physics::BodyKind::Kinematic && link.drivenByOwner;
            if (!driven) placeEntity(world, link.entity, place);
            link.place = place;
        }
        if (bodies.kind[index] == box_physics::BodyKind::Dynamic) writeRigidBody(world, state, index, link);
    }
}

template <class Event>
void emitContact(World& world, const box_physics::ContactEvent& event) {
    Event out;
    out.a = entityOf(event.userA);
    out.b = entityOf(event.userB);
    out.normal = event.normal;
    out.point = toPixels(event.point);
    out.impulse = std::max(event.impulse, 0.0f) * kPixelsPerMetre;
    world.emit(out);
}

template <class Event>
void emitOverlap(World& world, const PhysicsState& state, const box_physics::ContactEvent& event) {
    const auto isTrigger = [&](box_physics::BodyId body) {
        return (state.world.bodies.flags[body.index] & box_physics::kTrigger) != 0;
    };
    // When a body is gone, or no trigger any more, its partner's part is told all the same.
    const bool first = isTrigger(event.a);
    if (first || !isTrigger(event.b)) world.emit(Event{{entityOf(event.userA), entityOf(event.userB)}});
    if (!first || isTrigger(event.b)) world.emit(Event{{entityOf(event.userB), entityOf(event.userA)}});
}

void publishContacts(World& world, const PhysicsState& state) {
    for (const box_physics::ContactEvent& event : state.world.events) {
        switch (event.phase) {
            case box_physics::ContactPhase::Began:
                event.isTrigger ? emitOverlap<TriggerEntered>(world, state, event)
                                : emitContact<ContactBegan>(world, event);
                break;
            case box_physics::ContactPhase::Stayed:
                event.isTrigger ? emitOverlap<TriggerStayed>(world, state, event)
                                : emitContact<ContactStayed>(world, event);
                break;
            case box_physics::ContactPhase::Ended:
                event.isTrigger ? emitOverlap<TriggerLeft>(world, state, event)
                                : emitContact<ContactEnded>(world, event);
                break;
        }
    }
}

}  // namespace

unsigned effectsOf(World& world) {
    const unsigned set = world.resource<PhysicsSettings>().effects;
    if (set != 0) return set;
    const unsigned bySystems =
        (world.hasSystem<GravitySystem>() ? box_physics::kGravity : 0u) |
        (world.hasSystem<MovementSystem>() ? box_physics::kMotion : 0u) |
        (world.hasSystem<CollisionSystem>() ? box_physics::kContacts | box_physics::kTriggers : 0u);
    if (bySystems != 0) return bySystems;
    const bool falls = world.count<RigidBody>() > 0;
    const bool moves = falls || world.count<KinematicBody>() > 0;
    const bool meets = moves && hasColliders(world);
    return (falls ? box_physics::kGravity : 0u) | (moves ? box_physics::kMotion : 0u) |
           (meets ? box_physics::kContacts | box_physics::kTriggers : 0u);
}

void stepPhysics(World& world, float dt) {
    PhysicsState& state = world.resource<PhysicsState>();
    Profile* profile = world.service<Profile>();
    const unsigned effects = effectsOf(world);
    if (effects == 0 && state.world.bodies.size() == 0) return;
    {
        const ProfileScope scope{profile, "physics sync"};
        syncBodies(world, dt);
    }
    box_physics::step(state.world, physicsSettingsOf(world), dt, effects, profile);
    const ProfileScope scope{profile, "physics sync"};
    publishBodies(world, state);
    publishContacts(world, state);
}

box_physics::BodyId bodyOf(World& world, EntityId entity) {
    const PhysicsState& state = world.resource<PhysicsState>();
    if (entity.index >= state.bodyOf.size() || state.bodyOf[entity.index] == 0) return {};
    const std::uint32_t index = state.bodyOf[entity.index] - 1;
    if (state.links[index].entity != entity) return {};
    return {index, state.world.bodies.generation[index]};
}

void rebuildTileColliders(World& world) {
    for (BodyLink& link : world.resource<PhysicsState>().links) link.tilesVersion = 0;
}

}  // namespace plumb
