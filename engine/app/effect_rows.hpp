#pragma once

#include <vector>

#include "scene/effect_table.hpp"

namespace plumb {

/// Every effect of the engine, those of the physics among them, and which systems run for them. To add an
/// effect: one row in effect_rows.cpp.
const EffectTable& engineEffects();

/// The effects of the physics library.
std::vector<EffectRow> physicsEffectRows();

}  // namespace plumb
