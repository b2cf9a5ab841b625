#include "editor/model/overlays/reach_view.hpp"

#include "editor/model/workspace.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/transform.hpp"

namespace plumb::editor {
namespace {

constexpr float kMoved = 8.0f;       // px: minimum displacement of the player that needs a new result
constexpr std::int64_t kAgain = 30;  // minimum ticks between two results in a running game

}  // namespace

ObjectId ReachView::playerOf(const Workspace& workspace, bool any) {
    const World& world = workspace.shownWorld();
    const auto plays = [&](ObjectId id) {
        const EntityId entity = workspace.shownEntity(id);
        return world.alive(entity) && world.has<PlayerController>(entity) && world.has<RigidBody>(entity) &&
               world.has<Transform>(entity);
    };
    const std::vector<ObjectId>& selected = workspace.document.selection.all();
    for (auto id = selected.rbegin(); id != selected.rend(); ++id) {
        if (plays(*id)) return *id;
    }
    if (!any) return {};
    for (const ObjectId id : workspace.document.objects()) {
        if (plays(id)) return id;
    }
    return {};
}

bool ReachView::outdated(const Workspace& workspace, const Asked& now) const {
    if (now.player != asked_.player || now.playing != asked_.playing) return true;
    if (!now.playing) return now.revision != asked_.revision && !workspace.undo.inGesture();
    if (workspace.play.paused()) return now.tick != asked_.tick;
    const World& world = workspace.shownWorld();
    const EntityId player = workspace.shownEntity(now.player);
    return std::abs(now.tick - asked_.tick) >= kAgain && world.get<RigidBody>(player).grounded &&
           distance(world.get<Transform>(player).position, from_) >= kMoved;
}

void ReachView::update(Workspace& workspace, bool anyPlayer) {
    const Asked now{playerOf(workspace, anyPlayer), workspace.play.running(),
                    workspace.document.sceneRevision, workspace.play.running() ? workspace.play.ticks() : 0};
    if (!now.player) {
        reach_.clear();
        asked_ = now;
        return;
    }
    if (outdated(workspace, now)) {
        asked_ = now;
        const World& world = workspace.shownWorld();
        from_ = world.get<Transform>(workspace.shownEntity(now.player)).position;
        reach_.clear();
        if (PlaySession* game = ghost_.now(workspace))
            reach_.begin(*game, entityIn(game->world(), now.player));
    }
    static_cast<void>(reach_.work(kBudget));
}

void ReachView::clear() {
    reach_.clear();
    ghost_.clear();
    asked_ = {};
}

}  // namespace plumb::editor
