#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

/// Ratio to Settings::pushSpeed: how fast joints close what is open. Without a limit a joint that something
/// tore open (a sweep that stops one of its bodies at a wall) hurls both together: with long arms, at many
/// times the speed that they had. Below 6 a cloth of ten thousand joints comes apart under its weight.
inline constexpr float kJointPushing = 10.0f;

/// The bodies that a joint can push: kNone for one that is fixed, or that the joint leaves alone.
struct PushedBodies {
    std::uint32_t a;
    std::uint32_t b;
};
PushedBodies pushedBodies(const World& world, const Joint& joint);

/// Gives a colour to each awake joint that has none.
void colourNewJoints(World& world, Workspace& work);

/// Puts awake joints into blocks. After gatherBodies.
void prepareJoints(StepContext& step);

enum class JointAct : std::uint8_t { WarmStart, Push, Relax };

/// What a substep of h seconds is to joints.
JointPass jointPass(const Settings& settings, float h);
/// One pass over the joints of a group that have a colour.
void solveJoints(const StepContext& step, const SolverBodies& bodies, const JointPass& pass,
                 const SolveGroup& group, int colour, JointAct act);
/// After each substep: notes the forces on joints that can break.
void noteJointForces(StepContext& step, const SolveGroup& group, float substepRate);

/// Forces back to the joints, and an end to those that were pulled too hard.
void storeJoints(StepContext& step);

}  // namespace plumb::physics
