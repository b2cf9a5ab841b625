#include "editor/ui/overlays/way_overlays.hpp"

#include <algorithm>

#include "editor/model/tools/motion_paths.hpp"

namespace plumb::editor::ui {
namespace {

constexpr Color kOneJump{88, 201, 130, 64};
constexpr Color kMoreJumps{77, 163, 255, 40};
constexpr Color kArc{130, 235, 165, 70};
constexpr Color kLanding{150, 255, 185, 230};
constexpr Color kFarLanding{120, 185, 255, 190};
constexpr Color kBehind{255, 255, 255, 150};
constexpr Color kAhead{240, 185, 74, 220};
constexpr std::size_t kStep = 3;  // ticks between two drawn points of an arc

/// Draws one box per vertical run of cells that are reached with one jump, or with more.
void drawCells(const JumpReach& reach, Overlay& overlay) {
    constexpr float kCell = JumpReach::kCell;
    const auto& cells = reach.cells();
    for (auto at = cells.begin(); at != cells.end();) {
        const auto first = at;
        auto last = at;
        while (++at != cells.end() && at->first.x == first->first.x && at->first.y == last->first.y + 1 &&
               (at->second > 1) == (first->second > 1))
            last = at;
        const Vec2 from{static_cast<float>(first->first.x), static_cast<float>(first->first.y)};
        const Vec2 to{from.x + 1.0f, static_cast<float>(last->first.y + 1)};
        overlay.filledBox({from * kCell, to * kCell}, first->second > 1 ? kMoreJumps : kOneJump);
    }
}

void drawLine(const std::vector<Vec2>& points, std::size_t step, Color color, float thickness,
              Overlay& overlay) {
    for (std::size_t i = 0; i + 1 < points.size(); i += step)
        overlay.line(points[i], points[std::min(i + step, points.size() - 1)], color, thickness);
}

}  // namespace

void drawJumpReach(const Workspace& workspace, const World&, Overlay& overlay) {
    const JumpReach& reach = workspace.reach.reach();
    drawCells(reach, overlay);
    for (const JumpReach::Arc& arc : reach.arcs()) drawLine(arc.points, kStep, kArc, 1.0f, overlay);
    for (const JumpReach::Landing& landing : reach.landings()) {
        const AABB& box = landing.box;
        overlay.line({box.min.x, box.max.y}, box.max, landing.hops > 1 ? kFarLanding : kLanding, 3.0f);
    }
}

void drawTrajectories(const Workspace& workspace, const World&, Overlay& overlay) {
    for (const Trajectories::Way& way : workspace.trajectories.ways()) {
        drawLine(way.past, 1, kBehind, 1.5f, overlay);
        drawLine(way.future, 2, kAhead, 1.5f, overlay);
    }
}

void drawFixedPaths(const Workspace& workspace, const World& world, Overlay& overlay) {
    const bool all = workspace.reachOf("ways") == PhysicsReach::All;
    const float pixel = 1.0f / workspace.view.zoom();
    for (const ObjectId id : all ? workspace.document.objects() : workspace.document.selection.all()) {
        if (const auto way = motionPathOf(world, workspace.shownEntity(id))) drawSetWay(*way, pixel, overlay);
    }
}

}  // namespace plumb::editor::ui
