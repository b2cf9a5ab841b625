#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

// Blocks keep the impulses of the last substep only. Those of contacts with an event are summed up beside
// them, in Workspace::stepImpulses; all others cost nothing.

/// Before the first group: forgets the sums of the last step.
void clearImpulseSums(StepContext& step);
/// Before the substeps of a group: finds its contacts with an event.
void startImpulseSums(StepContext& step, const SolveGroup& group);
/// After each substep.
void addImpulses(Workspace& work);
/// After restitution.
void finishImpulseSums(Workspace& work);

}  // namespace plumb::physics
