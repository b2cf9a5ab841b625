#include "gameplay/systems/pause_system.hpp"

#include "ecs/world.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "gameplay/pause_scene.hpp"
#include "input/input.hpp"
#include "scene/scene_requests.hpp"
#include "scene/scene_stack.hpp"

namespace plumb {

void PauseSystem::update(World& world, float) {
    const PauseScene* pause = world.findResource<PauseScene>();
    if (pause == nullptr || pause->path.empty()) return;
    const Entity player = world.first<const PlayerController>();
    if (!player || !inputFor(world, player).isPressed(Action::Pause)) return;
    SceneRequests& requests = world.resource<SceneRequests>();
    if (!requests.empty()) return;
    requests.next = pause->path.path;
    requests.overlay = true;
}

}  // namespace plumb
