#pragma once

#include <vector>

#include "scene/effect_table.hpp"

namespace plumb {

/// Returns all effects of the engine, including those of the physics, and the systems that run for them. An
/// effect is an optional part of the simulation that runs only if an entity of the scene requires it, such as
/// particles or wind. To add one, add a row in effect_rows.cpp.
const EffectTable& engineEffects();

/// Returns the effects of the physics library.
std::vector<EffectRow> physicsEffectRows();

}  // namespace plumb
