#pragma once

#include <functional>

#include "physics/stages.hpp"

namespace plumb::physics {

// Parts of the solver besides the passes of passes.hpp. They cost nothing if no contact needs them.

// Restitution: what arrives fast enough leaves with a fraction of its speed, once the
// substeps have stopped it. Source: E. Catto, "Solver2D", 2024 (restitution after the substeps).

/// Records the approach speeds of contacts that bounce. After prepareConstraints, before the substeps.
void prepareRestitution(StepContext& step);
/// After each substep.
void noteLargestImpulses(StepContext& step, const SolveGroup& group);
/// After all substeps.
void applyRestitution(StepContext& step, const SolveGroup& group);

/// BounceBlock::sum of a contact that does not propagate impacts.
inline constexpr float kNoChain = -1.0f;

/// Propagation of simultaneous impacts: a ball that hits a row of balls which touch without load ejects the
/// last one. The substeps stop all balls at once and share out the momentum, so their impulses are taken
/// back, and the pairs collide sequentially until none approaches. Only for round contacts that bounce:
/// bodies that rest on two points, or under a load, do not transmit an impact as a whole. Source: B. Smith et
/// al., "Reflections on Simultaneous Impact", SIGGRAPH 2012, section 3, on what a sequence of pairwise
/// impacts gets right.
void runImpactsOn(StepContext& step, const SolveGroup& group);

// Rolling resistance: a torque against rotation, at most the resistance (m) times the force.

void prepareRolling(StepContext& step);
void warmStartRolling(StepContext& step, const SolveGroup& group);
/// After the contacts' relax pass of a substep.
void relaxRolling(StepContext& step, const SolveGroup& group);
void storeRolling(StepContext& step);

// Blocks only keep the impulses of the last substep. For contacts with
// an event they are summed over all substeps: Workspace::stepImpulses.

/// Before the first group: clears the sums of the last step.
void clearImpulseSums(StepContext& step);
/// Before the substeps of a group: finds its contacts with an event.
void startImpulseSums(StepContext& step, const SolveGroup& group);
/// After each substep.
void addImpulses(Workspace& work);
/// After restitution.
void finishImpulseSums(Workspace& work);

/// Clears the stored impulses of contacts and joints between bad bodies, which warm starting would repeat.
void forgetImpulses(StepContext& step, const std::function<bool(std::uint32_t a, std::uint32_t b)>& isBad);

}  // namespace plumb::physics
