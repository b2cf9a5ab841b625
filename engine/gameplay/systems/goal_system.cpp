#include "gameplay/systems/goal_system.hpp"

#include <algorithm>

#include "ecs/world.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "gameplay/components/actors/respawn.hpp"
#include "gameplay/components/controls/scene_link.hpp"
#include "gameplay/components/triggers/goal.hpp"
#include "gameplay/game_progress.hpp"
#include "gameplay/sound_cue.hpp"
#include "gameplay/touches.hpp"
#include "input/input.hpp"
#include "math/portable.hpp"
#include "scene/scene_requests.hpp"
#include "scene/scene_stack.hpp"

namespace plumb {

namespace {

void request(World& world, SceneId scene, bool overlay) {
    SceneRequests& requests = world.resource<SceneRequests>();
    requests.next = scene.path;
    requests.overlay = overlay;
}

void reach(World& world, EntityId goalId, EntityId player) {
    Goal& goal = world.get<Goal>(goalId);
    const Respawn* respawn = std::as_const(world).find<Respawn>(player);
    if (goal.leaving > 0 || (respawn != nullptr && respawn->waiting > 0)) return;
    goal.leaving = std::max(floorToInt(goal.delay * 60.0f), 1);
    GameProgress& progress = world.resource<GameProgress>();
    progress.levelFinished = true;
    progress.gameFinished = progress.gameFinished || goal.endsGame;
    setParameter(world, goalId, "active", 1.0f);
    playCue(world, goalId, &SoundCues::activate);
}

/// Counts down to the next scene. Stops at 1, so that a goal requests it only once.
void leave(World& world, Goal& goal) {
    if (goal.leaving <= 1) return;
    if (--goal.leaving == 1 && !goal.next.empty()) request(world, goal.next, false);
}

void follow(World& world, EntityId entity, SceneLink& link, float dt) {
    const bool confirmed = inputFor(world, entity).isPressed(Action::Confirm);
    const float seconds = static_cast<float>(link.ticks++) * dt;
    const bool pressed = confirmed && seconds >= link.delay;
    if (!pressed && (link.after <= 0.0f || seconds < link.after)) return;
    if (link.scene.empty()) return;
    if (pressed) playCue(world, entity, &SoundCues::activate);
    if (link.newGame) world.resource<GameProgress>() = {};
    request(world, link.scene, link.overlay);
}

}  // namespace

void GoalSystem::update(World& world, float dt) {
    forEachTouch<TriggerEntered, Goal, PlayerController>(
        world, [&world](EntityId goal, EntityId player) { reach(world, goal, player); });
    for (auto [entity, goal] : world.query<Goal>()) leave(world, goal);
    for (auto [entity, link] : world.query<SceneLink>()) follow(world, entity, link, dt);
}

}  // namespace plumb
