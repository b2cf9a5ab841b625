#include "editor/model/tools/motion_paths.hpp"

#include <algorithm>

#include "ecs/hierarchy.hpp"
#include "editor/model/tools/handles.hpp"
#include "gameplay/components/actors/moving_platform.hpp"
#include "gameplay/components/actors/patrol.hpp"

namespace plumb::editor {
namespace {

constexpr int kLeftEnd = 0;
constexpr int kRightEnd = 1;
constexpr float kNoLimit = 32.0f;    // px from the entity: position of the handle of a path end without limit
constexpr float kLeastLimit = 4.0f;  // px: a shorter distance removes the limit
constexpr Color kWay{240, 185, 74, 220};
constexpr Color kFree{240, 185, 74, 110};
constexpr float kMark = 5.0f;  // px on screen: half the length of an end mark

Pose parentPose(const World& world, EntityId entity) {
    const EntityId parent = parentOf(world, entity);
    return parent ? worldPose(world, parent) : Pose{};
}

Vec2 placed(const Pose& parent, Vec2 at) { return composed(parent, {at, 0.0f, {1.0f, 1.0f}}).position; }

MotionPath platformWay(const World& world, EntityId entity, const MovingPlatform& platform) {
    const Pose parent = parentPose(world, entity);
    const Vec2 home = platform.started ? platform.home : world.get<Transform>(entity).position;
    return {placed(parent, home), placed(parent, home + platform.way)};
}

MotionPath patrolWay(const World& world, EntityId entity, const Patrol& patrol) {
    const Pose parent = parentPose(world, entity);
    Vec2 home = world.get<Transform>(entity).position;
    if (patrol.direction != 0) home.x = patrol.homeX;
    const auto reach = [](float limit) { return limit > 0.0f ? limit : kNoLimit; };
    return {placed(parent, home - Vec2{reach(patrol.leftLimit), 0.0f}),
            placed(parent, home + Vec2{reach(patrol.rightLimit), 0.0f}), patrol.leftLimit > 0.0f,
            patrol.rightLimit > 0.0f, true};
}

float limitOf(float away) { return away < kLeastLimit ? 0.0f : away; }

}  // namespace

std::optional<MotionPath> motionPathOf(const World& world, EntityId entity) {
    if (!world.alive(entity) || !world.has<Transform>(entity)) return std::nullopt;
    if (const auto* platform = world.find<MovingPlatform>(entity))
        return platformWay(world, entity, *platform);
    if (const auto* patrol = world.find<Patrol>(entity)) return patrolWay(world, entity, *patrol);
    return std::nullopt;
}

void addWaySpots(const Document& document, ObjectId id, std::vector<ShapeHandle>& spots) {
    const auto way = motionPathOf(document.world, document.find(id));
    if (!way) return;
    const TypeRegistry& types = document.types();
    const TypeInfo& type = way->walks ? types.of<Patrol>() : types.of<MovingPlatform>();
    // A platform's path starts at its position, which the other tools move, so only the far end has a handle.
    if (way->walks) spots.push_back({way->from, &type, kLeftEnd, ShapeHandleKind::Way});
    spots.push_back({way->to, &type, kRightEnd, ShapeHandleKind::Way});
}

void dragWay(const Document& document, ObjectId id, ComponentState& state, int part, Vec2 to) {
    const World& world = document.world;
    const EntityId entity = document.find(id);
    const Vec2 there = relativeTo(parentPose(world, entity), {to, 0.0f, {1.0f, 1.0f}}).position;
    const Vec2 away = there - world.get<Transform>(entity).position;
    void* bytes = state.bytes.data();
    if (state.type->key == typeKey<MovingPlatform>()) {
        static_cast<MovingPlatform*>(bytes)->way = away;
    } else if (part == kLeftEnd) {
        static_cast<Patrol*>(bytes)->leftLimit = limitOf(-away.x);
    } else {
        static_cast<Patrol*>(bytes)->rightLimit = limitOf(away.x);
    }
}

void drawSetWay(const MotionPath& way, float pixel, Overlay& overlay) {
    const bool free = !way.endsFrom && !way.endsTo;
    overlay.line(way.from, way.to, free ? kFree : kWay, 1.5f);
    for (const auto& [at, ends] : {std::pair{way.from, way.endsFrom}, std::pair{way.to, way.endsTo}}) {
        const Vec2 up{0.0f, kMark * pixel};
        if (ends) {
            overlay.line(at - up, at + up, kWay, 2.0f);
        } else {
            overlay.circle(at, kMark * 0.5f * pixel, kFree, 1.5f);
        }
    }
}

}  // namespace plumb::editor
