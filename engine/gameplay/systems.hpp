#pragma once

// The systems behind the ready-made parts, all of them.
#include "gameplay/systems/character_animation_system.hpp"
#include "gameplay/systems/checkpoint_system.hpp"
#include "gameplay/systems/collect_system.hpp"
#include "gameplay/systems/door_system.hpp"
#include "gameplay/systems/goal_system.hpp"
#include "gameplay/systems/hazard_system.hpp"
#include "gameplay/systems/menu_system.hpp"
#include "gameplay/systems/motion_decor_system.hpp"
#include "gameplay/systems/moving_platform_system.hpp"
#include "gameplay/systems/patrol_system.hpp"
#include "gameplay/systems/pause_system.hpp"
#include "gameplay/systems/player_controller_system.hpp"
#include "gameplay/systems/progress_system.hpp"
#include "gameplay/systems/respawn_system.hpp"
#include "gameplay/systems/sound_cue_system.hpp"
#include "gameplay/systems/spring_system.hpp"
