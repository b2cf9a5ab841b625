#pragma once

#include <functional>

#include "physics/stages.hpp"

namespace plumb::physics {

// Optional parts of the solver, which run only if a contact needs them.

// Restitution: after the substeps have stopped bodies that approached fast enough, they get a fraction of
// their approach speed. Source: E. Catto, "Solver2D", 2024 (restitution after the substeps).

/// Records the approach speeds of contacts that bounce. Called after prepareConstraints, before the substeps.
void prepareRestitution(StepContext& step);
/// Records the largest impulses for restitution. Called after each substep.
void noteLargestImpulses(StepContext& step, const SolveGroup& group);
/// Applies restitution. Called after all substeps.
void applyRestitution(StepContext& step, const SolveGroup& group);

/// Value of BounceBlock::sum for a contact that does not propagate impacts.
inline constexpr float kNoChain = -1.0f;

/// Propagates simultaneous impacts: a ball that hits a row of touching balls ejects the last one. The
/// substeps distribute the momentum among all balls, so their impulses are removed, and the pairs collide
/// sequentially until none approaches. Only for contacts of circles that bounce: bodies that rest on two
/// points, or under a load, do not transmit an impact as a whole. Source: B. Smith et al., "Reflections on
/// Simultaneous Impact", SIGGRAPH 2012, section 3, on what a sequence of pairwise impacts gets right.
void runImpactsOn(StepContext& step, const SolveGroup& group);

// Rolling resistance: a torque against rotation, at most the resistance (m) times the normal force.

void prepareRolling(StepContext& step);
void warmStartRolling(StepContext& step, const SolveGroup& group);
/// Relax pass of rolling resistance. Called after the relax pass of the contacts.
void relaxRolling(StepContext& step, const SolveGroup& group);
void storeRolling(StepContext& step);

// Impulses of contacts with an event, summed over all substeps (blocks only store those of the last substep):
// Workspace::stepImpulses.

/// Clears the sums of the last step. Called before the first group.
void clearImpulseSums(StepContext& step);
/// Finds the contacts of a group with an event. Called before its substeps.
void startImpulseSums(StepContext& step, const SolveGroup& group);
/// Adds the impulses of a substep. Called after each substep.
void addImpulses(Workspace& work);
/// Adds the impulses of restitution and stores the sums in Workspace::stepImpulses.
void finishImpulseSums(Workspace& work);

/// Clears stored impulses of contacts and joints with isBad(bodyA, bodyB): they must not warm start.
void forgetImpulses(StepContext& step, const std::function<bool(std::uint32_t a, std::uint32_t b)>& isBad);

}  // namespace plumb::physics
