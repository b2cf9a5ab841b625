#include "editor/ui/overlays/overlay_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "editor/model/document/bounds.hpp"
#include "editor/ui/overlays/cost_overlays.hpp"
#include "editor/ui/overlays/tile_collision.hpp"
#include "editor/ui/overlays/way_overlays.hpp"
#include "render/view.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/transform.hpp"

namespace plumb::editor::ui {
namespace {

constexpr Color kCamera{190, 150, 240, 220};
constexpr Color kName{221, 224, 229, 220};
constexpr float kClosestLines = 12.0f;  // px on screen, minimum distance; else only every 8th line is drawn

/// True if a running game is shown through its own camera, as in the player.
bool showsGamePicture(const Workspace& workspace) {
    return workspace.play.running() && workspace.followsGame;
}

void drawGrid(const Workspace& workspace, const World&, Overlay& overlay) {
    if (showsGamePicture(workspace)) return;
    const AABB seen = visibleBox(workspace.view.view());
    const Color weak = workspace.grid.color;
    const Color heavy{weak.r, weak.g, weak.b, static_cast<std::uint8_t>(std::min(weak.a * 2 + 2, 255))};
    Vec2 step = workspace.grid.size;
    while (step.x * workspace.view.zoom() < kClosestLines || step.y * workspace.view.zoom() < kClosestLines) {
        step = step * 8.0f;
    }
    const auto strong = [](float line) { return static_cast<long>(line) % 8 == 0; };
    for (float i = std::floor(seen.min.x / step.x); i * step.x <= seen.max.x; ++i) {
        overlay.line({i * step.x, seen.min.y}, {i * step.x, seen.max.y}, strong(i) ? heavy : weak);
    }
    for (float i = std::floor(seen.min.y / step.y); i * step.y <= seen.max.y; ++i) {
        overlay.line({seen.min.x, i * step.y}, {seen.max.x, i * step.y}, strong(i) ? heavy : weak);
    }
}

void drawNames(const Workspace& workspace, const World& world, Overlay& overlay) {
    const bool all = workspace.reachOf("names") == PhysicsReach::All;
    for (const ObjectId id : all ? workspace.document.objects() : workspace.document.selection.all()) {
        const EntityId entity = workspace.shownEntity(id);
        if (!world.alive(entity) || !world.has<Transform>(entity)) continue;
        overlay.text(boundsOf(world, entity).min, workspace.document.nameOf(id), kName);
    }
}

void drawCameras(const Workspace& workspace, const World& world, Overlay& overlay) {
    if (showsGamePicture(workspace)) return;  // the whole image is the camera's view
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
        OverlayRow{"names", "Names", &drawNames, true},
        OverlayRow{"camera", "Camera", &drawCameras},
        OverlayRow{"reach", "Jump reach", &drawJumpReach, true},
        OverlayRow{"ways", "Paths of platforms and walkers", &drawFixedPaths, true},
        OverlayRow{"trajectories", "Trajectories", &drawTrajectories, true},
        OverlayRow{"bodyErrors", "Body errors", &drawBodyErrors, true},
        OverlayRow{"contactForces", "Contact forces", &drawContactForces, true},
        OverlayRow{"collision", "Tile collision", &drawTileCollision},
    };
    return kOverlays;
}

}  // namespace plumb::editor::ui
