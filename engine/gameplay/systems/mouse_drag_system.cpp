#include "gameplay/systems/mouse_drag_system.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "ecs/hierarchy.hpp"
#include "gameplay/components/controls/mouse_drag.hpp"
#include "input/input.hpp"
#include "math/angle.hpp"
#include "math/portable.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/bodies/soft_grip.hpp"
#include "scene/components/drawing/hidden.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/joints/mouse_joint.hpp"
#include "scene/components/transform.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/physics/physics_queries.hpp"
#include "scene/physics/soft_grips.hpp"
#include "scene/scene_stack.hpp"
#include "scene/systems/camera_system.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

namespace {

constexpr float kHertz = 5.0f;       ///< Hz, frequency of the mouse joint's spring
constexpr float kDragReach = 10.0f;  ///< px, maximum distance from the mouse, to grab thin bodies

Vec2 placeOfMouse(World& world, EntityId hand, const Input& input) {
    const Vec2 picture = world.resource<PictureSize>().size;
    const View view = cameraView(world, picture, 1.0f, static_cast<int>(placeOf(world, hand)));
    return toWorld(view, input.mouse());
}

/// Returns the first body within `reach` (px) of a position, or the empty id.
EntityId bodyAt(World& world, Vec2 place, float reach, std::uint32_t mask) {
    QueryFilter filter;
    filter.layers = 0xffffffffu;
    filter.mask = mask;
    std::vector<EntityId> found;
    overlapBox(world, AABB{place - Vec2{reach, reach}, place + Vec2{reach, reach}}, filter, found);
    for (const EntityId entity : found) {
        if (world.has<RigidBody>(entity) && !world.has<MouseJoint>(entity)) return entity;
    }
    return {};
}

bool takeSoftBody(World& world, MouseDrag& hand, Vec2 place, float reach) {
    const auto hit = softBodyAt(world, place, reach, hand.mask);
    if (!hit || world.has<SoftGrip>(hit->entity)) return false;
    hand.held = hit->entity;
    SoftGrip grip;
    grip.particle = hit->particle;
    grip.anchor = place - hit->place;
    grip.target = place;
    grip.acceleration = hand.acceleration;
    world.add<SoftGrip>(hit->entity, grip);
    return true;
}

bool takeBody(World& world, MouseDrag& hand, Vec2 place, float reach) {
    hand.held = bodyAt(world, place, reach, hand.mask);
    if (!world.alive(hand.held)) return false;
    const Pose pose = worldPose(world, hand.held);
    MouseJoint pull;
    pull.anchor = rotated(place - pose.position, -pose.rotation);
    pull.target = place;
    pull.hertz = kHertz;
    pull.maxForce = hand.acceleration * std::as_const(world).get<RigidBody>(hand.held).mass;
    world.add<MouseJoint>(hand.held, pull);
    return true;
}

/// Grabs a body. Bodies under the mouse have priority over bodies near it, and rigid over soft ones.
void take(World& world, MouseDrag& hand, Vec2 place) {
    for (const float reach : {1.0f, kDragReach}) {
        if (takeBody(world, hand, place, reach) || takeSoftBody(world, hand, place, reach)) return;
    }
}

/// Moves the target of the dragged body to the mouse.
/// @return true if a body is dragged
bool lead(World& world, const MouseDrag& hand, Vec2 place) {
    if (!world.alive(hand.held)) return false;
    auto* joint = world.find<MouseJoint>(hand.held);
    auto* grip = world.find<SoftGrip>(hand.held);
    if (joint != nullptr) joint->target = place;
    if (grip != nullptr) grip->target = place;
    return joint != nullptr || grip != nullptr;
}

void release(World& world, MouseDrag& hand) {
    if (world.alive(hand.held)) {
        world.remove<MouseJoint>(hand.held);
        world.remove<SoftGrip>(hand.held);
    }
    hand.held = {};
}

/// Returns the point at which the dragged body is held (px).
std::optional<Vec2> gripOf(const World& world, EntityId held) {
    if (!world.alive(held)) return std::nullopt;
    const auto* joint = world.find<MouseJoint>(held);
    if (joint == nullptr) return gripPlace(world, held);
    const Pose pose = worldPose(world, held);
    return pose.position + rotated(joint->anchor, pose.rotation);
}

/// Stretches the child sprites of the entity from the held
/// point to the mouse; to length 0 if no body is dragged.
void stretchLines(World& world, EntityId hand, Vec2 from, Vec2 to) {
    const Vec2 way = to - from;
    const float far = length(way);
    for (const Entity line : childrenOf(world, hand)) {
        const auto* sprite = std::as_const(world).find<Sprite>(line);
        auto* transform = sprite != nullptr ? world.find<Transform>(line) : nullptr;
        if (transform == nullptr) continue;
        transform->position = from - to;
        transform->scale.x = far / static_cast<float>(std::max(sprite->width, 1));
        if (far > 0.0f) transform->rotation = arcTangent(way.y, way.x);
        transform->previousRotation =
            transform->rotation;  // no interpolation, so that the line follows the dragged body exactly
    }
}

void show(World& world, EntityId hand, bool shown) {
    if (shown == !world.has<Hidden>(hand)) return;
    if (shown) {
        world.remove<Hidden>(hand);
    } else {
        world.add<Hidden>(hand);
    }
}

}  // namespace

void MouseDragSystem::update(World& world, float) {
    for (auto [entity, hand] : world.query<MouseDrag>()) {
        const Input& input = inputFor(world, entity);
        const Vec2 place = placeOfMouse(world, entity, input);
        if (!input.isHeld(MouseButton::Left)) release(world, hand);
        if (input.isPressed(MouseButton::Left)) take(world, hand, place);
        const bool holds = lead(world, hand, place);
        if (Transform* transform = world.find<Transform>(entity)) transform->position = place;
        const std::optional<Vec2> grip = gripOf(world, hand.held);
        stretchLines(world, entity, grip.value_or(place), place);
        show(world, entity, holds);
    }
}

}  // namespace plumb
