#pragma once

#include <vector>

#include "core/result.hpp"
#include "physics/world.hpp"

namespace plumb::reference {

// The reference solver computes the exact motion of a scene in the limit of rigid bodies, hard contacts,
// Coulomb friction and infinitely small steps. In double precision, with every island solved to convergence,
// with steps that are halved until the result no longer depends on them. Slow; the engine does not use it.
// See README.md.

struct Options {
    double step = 1.0 / 240.0;  ///< s: of the coarsest run; the others halve it
    int leastRuns = 3;          ///< minimum number: two give an error, three the order of convergence
    int mostRuns = 7;
    double wantedError = 1.0e-4;  ///< m: steps are halved until the error is below this
    double patience = 60.0;       ///< s of wall time in total: no run is started that would probably
                                  ///< take longer, and one that does ends without an answer
};

/// A body at the end.
struct BodyAnswer {
    physics::BodyId body;
    physics::WorldPosition centre;  ///< m: its centre of mass
    double angle = 0.0;             ///< rad; full turns are counted
    double velocityX = 0.0;         ///< m/s
    double velocityY = 0.0;
    double angularVelocity = 0.0;  ///< rad/s
};

/// The force in one contact point at the end.
struct ContactAnswer {
    physics::BodyId a, b;
    std::uint32_t shapeA = 0, shapeB = 0;  ///< in World::shapes
    physics::WorldPosition point;          ///< m
    double normalX = 0.0, normalY = 0.0;   ///< from a to b
    double force = 0.0;                    ///< N on b along the normal
    double friction = 0.0;                 ///< N on b along the normal turned from x towards y
};

/// The force at the anchor and the torque on body B with which a joint holds at the end.
struct JointAnswer {
    std::uint32_t joint = 0;            ///< in World::joints
    double forceX = 0.0, forceY = 0.0;  ///< N
    double torque = 0.0;                ///< N m
};

/// The state after `seconds`, and its accuracy.
struct Answer {
    double seconds = 0.0;
    std::vector<BodyAnswer> bodies;  ///< all dynamic bodies
    std::vector<ContactAnswer> contacts;
    std::vector<JointAnswer> joints;
    double energy = 0.0;         ///< J: kinetic, and potential from the origin of the world
    double error = 0.0;          ///< m: estimated from the runs; no centre deviates by more
    double angleError = 0.0;     ///< rad
    double velocityError = 0.0;  ///< m/s
    double order = 0.0;          ///< of convergence, as observed; 0 if all runs agree except for rounding
    double step = 0.0;           ///< s: of the finest run, which gives this answer
    int runs = 0;
    std::vector<double> differences;  ///< m: between each run and the one before it
    double residual = 0.0;            ///< ratio to velocities: residual of the worst system of all steps
    long steps = 0, hits = 0, factorings = 0, sweeps = 0;  ///< the work of the finest run

    /// True if it is a hundred times as accurate as an error (m) that it is used to judge.
    [[nodiscard]] bool canJudge(double judged) const { return error <= 0.01 * judged; }
};

/// Computes the motion of a world for so many seconds. The world does not change.
/// @error a feature of the scene that is not modeled, by name; or no convergence,
/// because the scene is chaotic or needs more patience
Result<Answer> solveReference(const physics::World& world, double seconds, const Options& options = {});

/// The deviation of a world from an answer.
struct Difference {
    double position = 0.0;  ///< m: of the centre that is furthest off
    double angle = 0.0;     ///< rad
    double velocity = 0.0;  ///< m/s
    physics::BodyId body;   ///< the body with that deviation of its centre
};

/// Compares a world that has been simulated for Answer::seconds. Bodies that no longer exist are skipped.
[[nodiscard]] Difference compare(const physics::World& world, const Answer& answer);

}  // namespace plumb::reference
