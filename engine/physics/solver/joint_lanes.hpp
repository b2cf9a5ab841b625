#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

/// Ratio to Settings::pushSpeed: maximum speed at which joint errors are closed. Without a limit, a joint
/// that was torn open (by a sweep that stops one of its bodies at a wall) would hurl both bodies together:
/// with long arms, at many times their speed. Below 6 a cloth of ten thousand joints comes apart under its
/// weight.
inline constexpr float kJointPushing = 10.0f;

/// The bodies that a joint moves: kNone for one that is not dynamic, or that the joint leaves alone.
struct PushedBodies {
    std::uint32_t a;
    std::uint32_t b;
};
PushedBodies pushedBodies(const World& world, const Joint& joint);

/// Assigns a color to each awake joint that has none.
void colourNewJoints(World& world, Workspace& work);

/// Packs awake joints into blocks. After gatherBodies.
void prepareJoints(StepContext& step);

enum class JointAct : std::uint8_t { WarmStart, Push, Relax };

/// Parameters of joints for a substep of h seconds.
JointPass jointPass(const Settings& settings, float h);
/// One pass over the joints of one color of a group.
void solveJoints(const StepContext& step, const SolverBodies& bodies, const JointPass& pass,
                 const SolveGroup& group, int colour, JointAct act);
/// After each substep: records the largest forces on breakable joints.
void noteJointForces(StepContext& step, const SolveGroup& group, float substepRate);

/// Writes forces back to the joints, and destroys those whose maximum was exceeded.
void storeJoints(StepContext& step);

}  // namespace plumb::physics
