#include "scene/physics/publish_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/model/bodies.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/physics/entity_bodies.hpp"

namespace plumb {

namespace {

constexpr float kGroundCosine = 0.6428f;  // cosine of 50 degrees: maximum slope of ground
constexpr float kLeaving = 0.1f;          // m/s: minimum separating speed of a body that leaves the ground

bool presses(const physics::Contact& contact, float slop) {
    return contact.impulse0 > 0.0f || contact.impulse1 > 0.0f ||
           std::min(contact.separation0, contact.separation1) <= slop;
}

/// Sets `grounded` to 1 for bodies that rest on another body.
void findGrounded(const PhysicsState& state, std::vector<std::uint8_t>& grounded) {
    const physics::World& world = state.world;
    grounded.assign(world.bodies.size(), 0);
    const Vec2 down = normalized(world.settings.gravity);
    if (down == Vec2{}) return;
    for (const physics::Contact& contact : world.contacts) {
        if ((contact.flags & (physics::kTouching | physics::kTriggered | physics::kDisabled)) !=
                physics::kTouching ||
            !presses(contact, world.settings.slop))
            continue;
        const float towardsB = dot(contact.normal, down);
        if (std::abs(towardsB) < kGroundCosine) continue;
        const Vec2 a = world.bodies.motion[contact.bodyA].velocity;
        const Vec2 b = world.bodies.motion[contact.bodyB].velocity;
        if (dot(contact.normal, b - a) > kLeaving) continue;
        grounded[towardsB > 0.0f ? contact.bodyA : contact.bodyB] = 1;
    }
}

void publishRigid(World& world, const PhysicsState& state, std::uint32_t index, BodyLink& link,
                  bool grounded) {
    const physics::BodyMotion& motion = state.world.bodies.motion[index];
    const Vec2 velocity = toPixels(motion.velocity, state.scale);
    link.velocity = velocity;
    link.angularVelocity = motion.angularVelocity;
    const RigidBody* known = std::as_const(world).find<RigidBody>(link.entity);
    if (known == nullptr || (known->velocity == velocity && known->grounded == grounded &&
                             known->angularVelocity == motion.angularVelocity))
        return;
    RigidBody& body = world.get<RigidBody>(link.entity);
    body.velocity = velocity;
    body.angularVelocity = motion.angularVelocity;
    body.grounded = grounded;
}

void publishPose(World& world, PhysicsState& state, physics::BodyId body, BodyLink& link) {
    if (link.driven || (state.world.bodies.info[body.index].flags & physics::kMoved) == 0) return;
    const Vec2 place = positionInPixels(positionOf(state.world, body), state.scale);
    const Rot rotation = rotationOf(state.world, body);
    // Without rotation the angle stays bit-identical.
    const bool turned = !(rotation == link.rotation);
    if (!turned && place == link.pose.position) return;
    link.pose.position = place;
    if (turned) link.pose.rotation = angleOf(rotation);
    link.rotation = rotation;
    placeEntity(world, state.poses, link.entity, link.pose);
}

}  // namespace

void publishBodies(World& world, PhysicsState& state) {
    findGrounded(state, state.grounded);
    state.poses.clear();
    const auto publish = [&](std::uint32_t index, bool asleep) {
        const physics::BodyInfo& info = state.world.bodies.info[index];
        if (index >= state.links.size() || !state.links[index].entity) return;
        BodyLink& link = state.links[index];
        publishPose(world, state, {index, info.generation}, link);
        if (info.kind != physics::BodyKind::Dynamic) return;
        const RigidBody* known = asleep ? std::as_const(world).find<RigidBody>(link.entity)
                                        : nullptr;  // a body that fell asleep keeps its value
        publishRigid(world, state, index, link,
                     known != nullptr ? known->grounded : state.grounded[index] != 0);
    };
    for (const std::uint32_t index : state.world.awake) publish(index, false);
    for (const std::uint32_t index : state.stepped) {
        if (state.world.bodies.info[index].awakeIndex == physics::kNone) publish(index, true);
    }
}

}  // namespace plumb
