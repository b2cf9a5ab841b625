#pragma once

// Includes every system of the scene layer.

#include "scene/drawing/render_system.hpp"
#include "scene/systems/animation_system.hpp"
#include "scene/systems/camera_system.hpp"
#include "scene/systems/character_controller_system.hpp"
#include "scene/systems/collision_system.hpp"
#include "scene/systems/experiment_system.hpp"
#include "scene/systems/ghost_system.hpp"
#include "scene/systems/gravity_system.hpp"
#include "scene/systems/movement_system.hpp"
#include "scene/systems/particle_system.hpp"
#include "scene/systems/physics_system.hpp"
#include "scene/systems/plot_system.hpp"
#include "scene/systems/slider_system.hpp"
