#include "editor/model/overlays/trajectories.hpp"

#include <algorithm>

#include "core/clock.hpp"
#include "editor/model/workspace.hpp"
#include "gameplay/components/actors/moving_platform.hpp"
#include "gameplay/components/actors/patrol.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/transform.hpp"
#include "scene/world_transform.hpp"

namespace plumb::editor {
namespace {

constexpr std::size_t kMost = 600;  // maximum number of trajectories

/// True if the physics or a gameplay component moves the entity.
bool movesByItself(const World& world, EntityId entity) {
    return world.has<RigidBody>(entity) || world.has<MovingPlatform>(entity) || world.has<Patrol>(entity);
}

}  // namespace

void Trajectories::clear() {
    ghost_.clear();
    game_ = nullptr;
    ways_.clear();
    begun_ = false;
}

void Trajectories::choose(const Workspace& workspace, bool all) {
    const World& world = workspace.shownWorld();
    const std::vector<ObjectId>& from =
        all ? workspace.document.objects() : workspace.document.selection.all();
    ways_.clear();
    for (const ObjectId id : from) {
        const EntityId entity = workspace.shownEntity(id);
        const bool moves =
            world.alive(entity) && world.has<Transform>(entity) && (!all || movesByItself(world, entity));
        if (moves && ways_.size() < kMost) ways_.push_back({id, {}, {}});
    }
}

void Trajectories::update(Workspace& workspace, bool all) {
    const bool playing = workspace.play.running();
    Asked now{playing, all, workspace.document.sceneRevision, workspace.document.selection.revision(),
              playing ? workspace.play.ticks() : 0};
    if (playing && !workspace.play.paused()) {
        // The past grows tick by tick. A copy of the game for the future would have to restart in every
        // frame.
        Asked before = asked_;
        before.tick = now.tick;
        if (!begun_ || before != now || game_ != nullptr) choose(workspace, all);
        game_ = nullptr;
        if (asked_.tick != now.tick || !begun_) follow(workspace);
    } else if (!begun_ || asked_ != now || (playing && game_ == nullptr)) {
        if (workspace.undo.inGesture() && begun_) return;
        choose(workspace, all);
        begin(workspace);
    } else {
        goOn(workspace);
    }
    asked_ = now;
    begun_ = true;
}

void Trajectories::follow(const Workspace& workspace) {
    const World& world = workspace.shownWorld();
    for (Way& way : ways_) {
        way.future.clear();
        const EntityId entity = workspace.shownEntity(way.object);
        if (!world.alive(entity) || !world.has<Transform>(entity)) continue;
        way.past.push_back(worldPose(world, entity).position);
        if (way.past.size() > static_cast<std::size_t>(kBehind)) way.past.erase(way.past.begin());
    }
}

void Trajectories::addPlaces(const World& world, bool future) {
    for (std::size_t i = 0; i < ways_.size(); ++i) {
        if (!world.alive(entities_[i]) || !world.has<Transform>(entities_[i])) continue;
        (future ? ways_[i].future : ways_[i].past).push_back(worldPose(world, entities_[i]).position);
    }
}

/// Computes the past at once; `goOn` computes the future, spread over frames.
void Trajectories::begin(Workspace& workspace) {
    const PlayMode& play = workspace.play;
    const std::int64_t now = play.running() ? play.ticks() : 0;
    const std::int64_t from = play.running() ? std::max(play.oldest(), now - kBehind) : 0;
    game_ = play.running() && from < now ? ghost_.at(workspace, from) : ghost_.now(workspace);
    ahead_ = game_ == nullptr ? kAhead : 0;
    if (game_ == nullptr) return;
    entities_.clear();
    for (const Way& way : ways_) entities_.push_back(entityIn(game_->world(), way.object));
    addPlaces(game_->world(), false);
    for (std::int64_t tick = from; tick < now; ++tick) {
        ghost_.playRecorded(workspace, tick);
        addPlaces(game_->world(), false);
    }
}

void Trajectories::goOn(Workspace& workspace) {
    if (game_ == nullptr) return;
    const PlayMode& play = workspace.play;
    const std::int64_t now = play.running() ? play.ticks() : 0;
    const double end = threadSeconds() + kBudget;
    for (; ahead_ < kAhead && threadSeconds() < end; ++ahead_) {
        if (play.running() && now + ahead_ < play.newest()) {
            ghost_.playRecorded(workspace, now + ahead_);
        } else {
            const bool known = play.running() && play.newest() > play.oldest();
            game_->tick(known ? play.recording().inputAfter(play.newest() - 1) : InputFrame{});
        }
        addPlaces(game_->world(), true);
    }
}

}  // namespace plumb::editor
