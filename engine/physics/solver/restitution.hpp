#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

// Restitution: what arrives fast enough leaves with a fraction of its speed, once the substeps have stopped
// it. Costs nothing if nothing bounces. Source: E. Catto, "Solver2D", 2024 (restitution after the substeps).

/// Records the approach speeds of contacts that bounce. After prepareConstraints, before the substeps.
void prepareRestitution(StepContext& step);
/// After each substep.
void noteLargestImpulses(StepContext& step, const SolveGroup& group);
/// After all substeps.
void applyRestitution(StepContext& step, const SolveGroup& group);

}  // namespace plumb::physics
