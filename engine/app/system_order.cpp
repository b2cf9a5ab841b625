#include "app/system_order.hpp"

#include <array>
#include <vector>

#include "gameplay/systems.hpp"
#include "scene/systems.hpp"

namespace plumb {
namespace {

template <class S>
constexpr SystemRow row(std::string_view calledFor) {
    return {S::kName, calledFor, [](World& world) { static_cast<void>(world.addSystem<S>()); }};
}

// A tick, from top to bottom. What decides comes first, then what moves, then what answers, then what shows.
constexpr std::array kSystems{
    row<ProgressSystem>("PlayerController, Collectible"),
    row<MovingPlatformSystem>("MovingPlatform"),
    row<PatrolSystem>("Patrol"),
    row<PlayerControllerSystem>("PlayerController"),
    row<CharacterControllerSystem>("CharacterController"),
    row<PushControlSystem>("PushControl"),
    row<MouseDragSystem>("MouseDrag"),
    row<DetonatorSystem>("Detonator"),
    row<SliderSystem>("Slider"),
    row<ExperimentSystem>("Experiment"),
    row<PhysicsSystem>("RigidBody, KinematicBody, BoxCollider, CircleCollider, CapsuleCollider, "
                       "PolygonCollider, ChainCollider, TileCollider"),
    row<GhostSystem>("Ghost"),
    row<PlotSystem>("Plot"),
    row<PhysicsCountSystem>("Label"),
    row<SpringSystem>("Spring"),
    row<PortalSystem>("Portal"),
    row<TouchColorSystem>("TouchColor"),
    row<CollectSystem>("Collectible"),
    row<CheckpointSystem>("Checkpoint"),
    row<GoalSystem>("Goal, SceneLink"),
    row<MenuSystem>("Menu, MenuItem"),
    row<DoorSystem>("Door, Button"),
    row<HazardSystem>("Hazard, Stompable, KillPlane"),
    row<RespawnSystem>("Respawn"),
    row<ShortcutSystem>("SceneKey, ToggleKey"),
    row<PauseSystem>("PlayerController"),
    row<MotionDecorSystem>("Bob, Spin, Lifetime"),
    row<CharacterAnimationSystem>("PlayerController, Patrol"),
    row<AnimationSystem>("Animator"),
    row<ParticleSystem>("ParticleEmitter"),
    row<SoundCueSystem>("SoundCues"),
    row<CameraSystem>("Camera"),
    row<RenderSystem>("Sprite, TileLayer, ParticleEmitter, Label, Slider, Plot, Ghost"),
};

}  // namespace

std::span<const SystemRow> systemTable() { return kSystems; }

void useSystemOrder(World& world) {
    std::vector<std::string_view> names;
    for (const SystemRow& system : kSystems) {
        names.push_back(system.name);
    }
    world.setSystemOrder(names);
}

void addAllSystems(World& world) {
    useSystemOrder(world);
    for (const SystemRow& system : kSystems) {
        system.add(world);
    }
}

}  // namespace plumb
