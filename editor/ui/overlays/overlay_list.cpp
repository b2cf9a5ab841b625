#include "editor/ui/overlays/overlay_list.hpp"

#include <array>
#include <cmath>

#include "editor/model/bounds.hpp"
#include "render/view.hpp"
#include "scene/components/box_collider.hpp"
#include "scene/components/camera.hpp"
#include "scene/components/circle_collider.hpp"
#include "scene/components/kinematic_body.hpp"
#include "scene/components/rigid_body.hpp"
#include "scene/components/transform.hpp"
#include "scene/world_transform.hpp"

namespace plumb::editor::ui {
namespace {

constexpr Color kGridLine{255, 255, 255, 16};
constexpr Color kGridStrong{255, 255, 255, 34};
constexpr Color kSolid{88, 201, 130, 220};
constexpr Color kTrigger{240, 185, 74, 220};
constexpr Color kVelocity{240, 104, 160, 230};
constexpr Color kCamera{190, 150, 240, 220};
constexpr Color kName{221, 224, 229, 220};
constexpr float kClosestLines = 6.0f;     // px on screen; a finer grid is only its tenth lines
constexpr float kVelocitySeconds = 0.2f;  // s of way that an arrow shows

/// Whether one looks at a running game as its player would.
bool showsGamePicture(const Workspace& workspace) {
    return workspace.play.running() && workspace.followsGame;
}

void drawGrid(const Workspace& workspace, const World&, Overlay& overlay) {
    if (showsGamePicture(workspace)) return;
    const AABB seen = visibleBox(workspace.view.view());
    Vec2 step = workspace.grid.size;
    while (step.x * workspace.view.zoom() < kClosestLines || step.y * workspace.view.zoom() < kClosestLines) {
        step = step * 8.0f;
    }
    const auto strong = [](float line) { return static_cast<long>(line) % 8 == 0; };
    for (float i = std::floor(seen.min.x / step.x); i * step.x <= seen.max.x; ++i) {
        overlay.line({i * step.x, seen.min.y}, {i * step.x, seen.max.y}, strong(i) ? kGridStrong : kGridLine);
    }
    for (float i = std::floor(seen.min.y / step.y); i * step.y <= seen.max.y; ++i) {
        overlay.line({seen.min.x, i * step.y}, {seen.max.x, i * step.y}, strong(i) ? kGridStrong : kGridLine);
    }
}

void drawColliders(const Workspace&, const World& world, Overlay& overlay) {
    world.each<const BoxCollider>([&](EntityId entity, const BoxCollider& collider) {
        const Pose pose = worldPose(world, entity);
        const Vec2 from = pose.position + collider.offset;
        overlay.box({from, from + scaled({collider.width, collider.height}, pose.scale)},
                    collider.isTrigger ? kTrigger : kSolid, 1.5f);
    });
    world.each<const CircleCollider>([&](EntityId entity, const CircleCollider& collider) {
        const Pose pose = worldPose(world, entity);
        overlay.circle(pose.position + collider.offset, collider.radius * std::abs(pose.scale.x),
                       collider.isTrigger ? kTrigger : kSolid, 1.5f);
    });
}

void drawVelocities(const Workspace&, const World& world, Overlay& overlay) {
    const auto arrow = [&](EntityId entity, Vec2 velocity) {
        if (velocity == Vec2{}) return;
        const Vec2 from = boundsOf(world, entity).center();
        overlay.arrow(from, from + velocity * kVelocitySeconds, kVelocity, 1.5f);
    };
    world.each<const RigidBody>(
        [&](EntityId entity, const RigidBody& body) { arrow(entity, body.velocity); });
    world.each<const KinematicBody>(
        [&](EntityId entity, const KinematicBody& body) { arrow(entity, body.velocity); });
}

void drawNames(const Workspace& workspace, const World& world, Overlay& overlay) {
    for (const ObjectId id : workspace.document.objects()) {
        const EntityId entity = workspace.shownEntity(id);
        if (!world.alive(entity) || !world.has<Transform>(entity)) continue;
        overlay.text(boundsOf(world, entity).min, workspace.document.nameOf(id), kName);
    }
}

void drawCameras(const Workspace& workspace, const World& world, Overlay& overlay) {
    if (showsGamePicture(workspace)) return;  // all of it is what the camera sees
    world.each<const Camera, const Transform>([&](const Camera& camera, const Transform& transform) {
        const Vec2 half = workspace.project.picture * (0.5f / std::max(camera.zoom, 0.01f));
        overlay.box({transform.position - half, transform.position + half}, kCamera, 1.5f);
        const Rect& limits = camera.limits;
        if (limits.empty()) return;
        overlay.box({{limits.x, limits.y}, {limits.x + limits.width, limits.y + limits.height}},
                    {kCamera.r, kCamera.g, kCamera.b, 90});
    });
}

}  // namespace

std::span<const OverlayRow> overlayTable() {
    static constexpr std::array kOverlays{
        OverlayRow{"grid", "Grid", &drawGrid},
        OverlayRow{"colliders", "Colliders", &drawColliders},
        OverlayRow{"velocities", "Velocities", &drawVelocities},
        OverlayRow{"names", "Names", &drawNames},
        OverlayRow{"camera", "Camera", &drawCameras},
    };
    return kOverlays;
}

}  // namespace plumb::editor::ui
