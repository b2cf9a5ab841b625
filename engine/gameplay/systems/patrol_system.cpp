#include "gameplay/systems/patrol_system.hpp"

#include "ecs/world.hpp"
#include "gameplay/components/actors/patrol.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "gameplay/touches.hpp"
#include "scene/components/bodies/kinematic_body.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/transform.hpp"
#include "scene/physics/physics_queries.hpp"
#include "scene/physics_bridge.hpp"

namespace plumb {

namespace {

constexpr float kLookAhead = 2.0f;  // px beyond its next step that are checked
constexpr float kEdgeDepth = 6.0f;  // px, minimum depth of a ledge
constexpr float kWallLift = 3.0f;   // px above the feet from which walls are detected, to ignore slopes

bool leavesLimits(const Patrol& patrol, float x) {
    const float away = x - patrol.homeX;
    if (patrol.direction < 0) return patrol.leftLimit > 0.0f && away <= -patrol.leftLimit;
    return patrol.rightLimit > 0.0f && away >= patrol.rightLimit;
}

QueryFilter groundFilter(EntityId self) {
    QueryFilter filter;
    filter.except = self;
    filter.movers = false;  // other enemies and the player do not make it reverse
    return filter;
}

bool meetsWall(World& world, EntityId entity, AABB box, float step) {
    box.max.y -= kWallLift;
    const auto hit = castBox(world, box, {step, 0.0f}, groundFilter(entity));
    return hit && hit->normal.x * step < 0.0f;
}

bool meetsEdge(World& world, EntityId entity, const AABB& box, float step) {
    const float front = step < 0.0f ? box.min.x : box.max.x;
    const Vec2 foot{front + step, box.max.y - kEdgeDepth};
    if (!castRay(world, {box.center().x, foot.y}, {0.0f, 2.0f * kEdgeDepth}, groundFilter(entity)))
        return false;
    return !castRay(world, foot, {0.0f, 2.0f * kEdgeDepth}, groundFilter(entity));
}

bool mustTurn(World& world, EntityId entity, const Patrol& patrol, float dt) {
    const Vec2 at = std::as_const(world).get<Transform>(entity).position;
    if (leavesLimits(patrol, at.x)) return true;
    if (!world.has<BoxCollider>(entity)) return false;
    const AABB box = boxOf(world, entity);
    const float step = static_cast<float>(patrol.direction) * (patrol.speed * dt + kLookAhead);
    return (patrol.turnAtWalls && meetsWall(world, entity, box, step)) ||
           (patrol.turnAtEdges && meetsEdge(world, entity, box, step));
}

void setSpeed(World& world, EntityId entity, float speed) {
    if (auto* body = world.find<RigidBody>(entity)) {
        body->velocity.x = speed;
    } else if (auto* kinematic = world.find<KinematicBody>(entity)) {
        kinematic->velocity.x = speed;
    }
}

}  // namespace

void PatrolSystem::update(World& world, float dt) {
    if (world.count<Patrol>() == 0) return;
    if (world.count<PlayerController>() == 0)
        syncBodies(world, dt);  // otherwise PlayerControllerSystem does it in every tick
    for (auto [entity, patrol] : world.query<Patrol>(with<Transform>)) {
        if (patrol.direction == 0) {
            patrol.direction = patrol.startLeft ? -1 : 1;
            patrol.homeX = std::as_const(world).get<Transform>(entity).position.x;
        }
        if (mustTurn(world, entity, patrol, dt)) {
            patrol.direction = -patrol.direction;
            // The entity stands still between two walls or on ground as narrow as itself.
            if (mustTurn(world, entity, patrol, dt)) {
                setSpeed(world, entity, 0.0f);
                continue;
            }
        }
        setSpeed(world, entity, static_cast<float>(patrol.direction) * patrol.speed);
        if (auto* sprite = world.find<Sprite>(entity))
            sprite->flipX = (patrol.direction < 0) != patrol.facesLeft;
    }
}

}  // namespace plumb
