#pragma once

// The physics library, for programs that use nothing else of the engine.

#include "physics/character/character_controller.hpp"
#include "physics/debug_draw.hpp"
#include "physics/effects/shape_wind.hpp"
#include "physics/measure/snapshot.hpp"
#include "physics/model/fields.hpp"
#include "physics/objects.hpp"
#include "physics/queries/lists.hpp"
#include "physics/queries/overlap.hpp"
#include "physics/queries/ray_cast.hpp"
#include "physics/queries/shape_cast.hpp"
#include "physics/simulation.hpp"
#include "physics/soft/softbody.hpp"
