#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

// Bouncing: what came in fast enough leaves with a part of its speed, once all substeps have stopped it.
// Costs nothing where nothing bounces. Source: E. Catto, "Solver2D", 2024 (restitution after the substeps).

/// Notes how fast bouncy contacts approach. After prepareConstraints, before the substeps.
void prepareRestitution(StepContext& step);
/// After each substep.
void noteLargestImpulses(StepContext& step, const SolveGroup& group);
/// After all.
void applyRestitution(StepContext& step, const SolveGroup& group);

}  // namespace plumb::physics
