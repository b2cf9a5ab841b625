#include "app/system_order.hpp"

#include <array>

#include "gameplay/systems.hpp"
#include "scene/systems.hpp"
#include "script/script_system.hpp"

namespace plumb {
namespace {

template <class S>
constexpr SystemRow row(std::string_view effect) {
    return {S::kName, effect, typeKey<S>, [](World& world) { static_cast<void>(world.addSystem<S>()); }};
}

// Order of execution in a tick: control, then physics, then reactions to it, then animation and drawing.
constexpr std::array kSystems{
    row<TimerSystem>("timers"),
    row<ProgressSystem>("progress"),
    row<ScriptSystem>("scripts"),
    row<MovingPlatformSystem>("moving_platforms"),
    row<PatrolSystem>("patrols"),
    row<PlayerControllerSystem>("players"),
    row<CharacterControllerSystem>("characters"),
    row<PushControlSystem>("push_controls"),
    row<MouseDragSystem>("mouse_drag"),
    row<DetonatorSystem>("detonators"),
    row<SliderSystem>("sliders"),
    row<ExperimentSystem>("experiments"),
    row<PhysicsSystem>(""),  // always runs: its manifest controls which stages of the physics run
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
    row<TweenSystem>("tweens"),
    // Systems of a project's code run here unless they choose another place.
    row<ScriptEventSystem>("scripts"),
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

}  // namespace plumb
