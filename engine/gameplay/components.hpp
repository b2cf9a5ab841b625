#pragma once

// Includes every component of the gameplay layer.

#include "gameplay/components/actors/bob.hpp"
#include "gameplay/components/actors/health.hpp"
#include "gameplay/components/actors/moving_platform.hpp"
#include "gameplay/components/actors/patrol.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "gameplay/components/actors/push_control.hpp"
#include "gameplay/components/actors/respawn.hpp"
#include "gameplay/components/actors/spin.hpp"
#include "gameplay/components/actors/stompable.hpp"
#include "gameplay/components/controls/button.hpp"
#include "gameplay/components/controls/menu.hpp"
#include "gameplay/components/controls/menu_item.hpp"
#include "gameplay/components/controls/mouse_drag.hpp"
#include "gameplay/components/controls/save_slot.hpp"
#include "gameplay/components/controls/scene_key.hpp"
#include "gameplay/components/controls/scene_link.hpp"
#include "gameplay/components/controls/toggle_key.hpp"
#include "gameplay/components/music.hpp"
#include "gameplay/components/sound_cues.hpp"
#include "gameplay/components/triggers/checkpoint.hpp"
#include "gameplay/components/triggers/collectible.hpp"
#include "gameplay/components/triggers/detonator.hpp"
#include "gameplay/components/triggers/door.hpp"
#include "gameplay/components/triggers/goal.hpp"
#include "gameplay/components/triggers/hazard.hpp"
#include "gameplay/components/triggers/kill_plane.hpp"
#include "gameplay/components/triggers/lifetime.hpp"
#include "gameplay/components/triggers/portal.hpp"
#include "gameplay/components/triggers/spring.hpp"
#include "gameplay/components/triggers/touch_color.hpp"
#include "reflect/type_list.hpp"

namespace plumb {

/// All components of the gameplay layer, in the order in which files, the inspector and scripts list them.
using GameplayComponents =
    TypeList<PlayerController, Health, Respawn, Hazard, Stompable, Patrol, MovingPlatform, Spring,
             Collectible, Checkpoint, Goal, SceneLink, Door, Button, KillPlane, Bob, Spin, Lifetime,
             SoundCues, Music, Menu, MenuItem, PushControl, MouseDrag, TouchColor, SceneKey, SaveSlot,
             ToggleKey, Detonator, Portal>;

}  // namespace plumb
