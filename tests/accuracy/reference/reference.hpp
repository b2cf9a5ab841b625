#pragma once

#include <vector>

#include "core/result.hpp"
#include "physics/world.hpp"

namespace plumb::reference {

// The reference solver: what a scene would do if bodies were rigid, contacts had no give, friction were
// Coulomb's and time had no steps. In double, with every island solved to convergence, at steps that become
// smaller until the answer no longer depends on them. Slow; nothing in the engine uses it. See README.md.

struct Options {
    double step = 1.0 / 240.0;  ///< s: of the coarsest run; the others halve it
    int leastRuns = 3;          ///< so many at least: two give an error, three the order of convergence
    int mostRuns = 7;
    double wantedError = 1.0e-4;  ///< m: steps are halved until the answer is as good
    double patience = 60.0;  ///< s of the clock in all: no run is begun that would probably take longer, and
                             ///< one that does ends without an answer
};

/// A body at the end.
struct BodyAnswer {
    physics::BodyId body;
    physics::WorldPosition centre;  ///< m: its centre of mass
    double angle = 0.0;             ///< rad; turns are counted on from the start
    double velocityX = 0.0;         ///< m/s
    double velocityY = 0.0;
    double angularVelocity = 0.0;  ///< rad/s
};

/// What pushes in one point of a contact at the end.
struct ContactAnswer {
    physics::BodyId a, b;
    std::uint32_t shapeA = 0, shapeB = 0;  ///< in World::shapes
    physics::WorldPosition point;          ///< m
    double normalX = 0.0, normalY = 0.0;   ///< from a to b
    double force = 0.0;                    ///< N on b along the normal
    double friction = 0.0;                 ///< N on b along the normal turned from x towards y
};

/// What a joint needs to hold at the end, on its body B: a force at its anchor, and a torque.
struct JointAnswer {
    std::uint32_t joint = 0;            ///< in World::joints
    double forceX = 0.0, forceY = 0.0;  ///< N
    double torque = 0.0;                ///< N m
};

/// What is to be after `seconds`, and how exactly that is known.
struct Answer {
    double seconds = 0.0;
    std::vector<BodyAnswer> bodies;  ///< all that can be pushed
    std::vector<ContactAnswer> contacts;
    std::vector<JointAnswer> joints;
    double energy = 0.0;         ///< J: of motion, and of gravity from the origin of the world
    double error = 0.0;          ///< m: estimated from the runs; no centre deviates by more
    double angleError = 0.0;     ///< rad
    double velocityError = 0.0;  ///< m/s
    double order = 0.0;  ///< of convergence, as observed; 0 where all runs are the same but for rounding
    double step = 0.0;   ///< s: of the finest run, which this is
    int runs = 0;
    std::vector<double> differences;  ///< m: between each run and the one before it
    double residual = 0.0;  ///< ratio to its speeds: by how much the worst system of all steps is not solved
    long steps = 0, hits = 0, factorings = 0, sweeps = 0;  ///< the work of the finest run

    /// True when it is a hundred times as exact as an error (m) that it is to judge.
    [[nodiscard]] bool canJudge(double judged) const { return error <= 0.01 * judged; }
};

/// Finds out what a world does in the next so many seconds. The world does not change.
/// @error what the scene has that is not modelled, by name; or that runs do not come together, so that there
///        is no telling: the scene is chaotic, or wants more patience
Result<Answer> solveReference(const physics::World& world, double seconds, const Options& options = {});

/// How far a world is from an answer.
struct Difference {
    double position = 0.0;  ///< m: of the centre that is furthest off
    double angle = 0.0;     ///< rad
    double velocity = 0.0;  ///< m/s
    physics::BodyId body;   ///< whose centre it is
};

/// Compares a world that has been simulated for Answer::seconds. Bodies that it has no longer are left out.
[[nodiscard]] Difference compare(const physics::World& world, const Answer& answer);

}  // namespace plumb::reference
