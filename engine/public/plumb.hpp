#pragma once

// Everything that a game's code needs.

#include "app/engine.hpp"
#include "app/game.hpp"
#include "assets/animation.hpp"
#include "core/log.hpp"
#include "core/random.hpp"
#include "ecs/hierarchy.hpp"
#include "ecs/world.hpp"
#include "gameplay/components.hpp"
#include "gameplay/systems.hpp"
#include "math/angle.hpp"
#include "math/color.hpp"
#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "scene/components.hpp"
#include "scene/systems.hpp"
