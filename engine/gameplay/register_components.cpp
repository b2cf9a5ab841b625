#include "gameplay/register_components.hpp"

#include "gameplay/components/bob.hpp"
#include "gameplay/components/button.hpp"
#include "gameplay/components/checkpoint.hpp"
#include "gameplay/components/collectible.hpp"
#include "gameplay/components/detonator.hpp"
#include "gameplay/components/door.hpp"
#include "gameplay/components/goal.hpp"
#include "gameplay/components/hazard.hpp"
#include "gameplay/components/health.hpp"
#include "gameplay/components/kill_plane.hpp"
#include "gameplay/components/lifetime.hpp"
#include "gameplay/components/menu.hpp"
#include "gameplay/components/menu_item.hpp"
#include "gameplay/components/mouse_drag.hpp"
#include "gameplay/components/moving_platform.hpp"
#include "gameplay/components/music.hpp"
#include "gameplay/components/patrol.hpp"
#include "gameplay/components/player_controller.hpp"
#include "gameplay/components/portal.hpp"
#include "gameplay/components/push_control.hpp"
#include "gameplay/components/respawn.hpp"
#include "gameplay/components/scene_key.hpp"
#include "gameplay/components/scene_link.hpp"
#include "gameplay/components/sound_cues.hpp"
#include "gameplay/components/spin.hpp"
#include "gameplay/components/spring.hpp"
#include "gameplay/components/stompable.hpp"
#include "gameplay/components/toggle_key.hpp"
#include "gameplay/components/touch_color.hpp"
#include "reflect/type_registry.hpp"

namespace plumb {

void registerGameplayComponents(TypeRegistry& types) {
    types.add<PlayerController>();
    types.add<Health>();
    types.add<Respawn>();
    types.add<Hazard>();
    types.add<Stompable>();
    types.add<Patrol>();
    types.add<MovingPlatform>();
    types.add<Spring>();
    types.add<Collectible>();
    types.add<Checkpoint>();
    types.add<Goal>();
    types.add<SceneLink>();
    types.add<Door>();
    types.add<Button>();
    types.add<KillPlane>();
    types.add<Bob>();
    types.add<Spin>();
    types.add<Lifetime>();
    types.add<SoundCues>();
    types.add<Music>();
    types.add<Menu>();
    types.add<MenuItem>();
    types.add<PushControl>();
    types.add<MouseDrag>();
    types.add<TouchColor>();
    types.add<SceneKey>();
    types.add<ToggleKey>();
    types.add<Detonator>();
    types.add<Portal>();
}

}  // namespace plumb
