#include "app/system_order.hpp"

#include <array>
#include <vector>

#include "gameplay/systems.hpp"
#include "scene/systems.hpp"

namespace plumb {
namespace {

template <class S>
constexpr SystemRow row(std::string_view effect) {
    return {S::kName, effect, typeKey<S>, [](World& world) { static_cast<void>(world.addSystem<S>()); }};
}

// A tick, from top to bottom. What decides comes first, then what moves, then what answers, then what shows.
constexpr std::array kSystems{
    row<ProgressSystem>("progress"),
    row<MovingPlatformSystem>("moving_platforms"),
    row<PatrolSystem>("patrols"),
    row<PlayerControllerSystem>("players"),
    row<CharacterControllerSystem>("characters"),
    row<PushControlSystem>("push_controls"),
    row<MouseDragSystem>("mouse_drag"),
    row<DetonatorSystem>("detonators"),
    row<SliderSystem>("sliders"),
    row<ExperimentSystem>("experiments"),
    row<PhysicsSystem>(""),  // its own manifest says which of its stages run
    row<GhostSystem>("ghosts"),
    row<PlotSystem>("plots"),
    row<PhysicsCountSystem>("physics_counts"),
    row<SpringSystem>("bouncers"),
    row<PortalSystem>("portals"),
    row<TouchColorSystem>("touch_colors"),
    row<CollectSystem>("collectibles"),
    row<CheckpointSystem>("checkpoints"),
    row<GoalSystem>("goals"),
    row<MenuSystem>("menus"),
    row<DoorSystem>("doors"),
    row<HazardSystem>("hazards"),
    row<RespawnSystem>("respawn"),
    row<ShortcutSystem>("shortcuts"),
    row<PauseSystem>("players"),
    row<MotionDecorSystem>("decor"),
    row<CharacterAnimationSystem>("character_animation"),
    row<AnimationSystem>("animation"),
    row<ParticleSystem>("particles"),
    row<SoundCueSystem>("sound"),
    row<CameraSystem>("camera"),
    row<RenderSystem>("picture"),
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
