#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

// Joints that make up trees (chains, ragdolls, bridges) are solved all at once in each substep, in time that
// grows with their number: the system of masses and joints is factored from the twigs to the root, and
// nothing fills in. However long the chain and heavy what hangs on it, its joints hold. Joints that close
// loops, limits, motors, springs and contacts stay with the lanes, beside it. Sources: D. Baraff,
// "Linear-Time Dynamics using Lagrange Multipliers", SIGGRAPH 1996. What pushes looks ahead to where the
// bodies will be, and what relaxes makes their velocities fit together there: H. Andersen, "RATTLE", Journal
// of Computational Physics 52, 1983, which neither gains nor loses energy.

/// Fills in masses, arms and gaps of the start of the step. After gatherBodies.
void prepareTrees(StepContext& step);

/// True when a joint is as good as closed at the start of the step.
/// @param held  it is one of a tree that is held at several ends
bool isClosed(const World& world, Link& link, bool held);

/// Velocities that close all gaps within a substep of h seconds.
/// @param substep  the number of it
/// @param again  in the same substep, since something else pushed at the bodies
void pushTrees(StepContext& step, const SolveGroup& group, float h, int substep, bool again);
/// Velocities that open none, after the bodies have moved.
void relaxTrees(StepContext& step, const SolveGroup& group, float h, int substep, bool again);

/// N on B, and N m, of a link in the last substep.
struct LinkForce {
    Vec2 force;
    float torque = 0.0f;
};
LinkForce forceOf(const Link& link);
void storeTrees(StepContext& step);

}  // namespace plumb::physics
