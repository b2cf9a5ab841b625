#pragma once

#include <vector>

#include "core/result.hpp"
#include "physics/world.hpp"

namespace plumb::reference {

// The reference solver computes the motion of a scene with rigid bodies, hard contacts and Coulomb friction
// in double precision. Every island is solved to convergence, and steps are halved until the result no longer
// depends on them. It is slow and used in tests only. See README.md.

struct Options {
    double step = 1.0 / 240.0;  ///< step of the coarsest run, s; each further run halves it
    int leastRuns = 3;          ///< minimum number of runs: two give an error, three the order of convergence
    int mostRuns = 7;           ///< maximum number of runs
    double wantedError = 1.0e-4;  ///< steps are halved until the error is below this, m
    double patience = 60.0;       ///< limit of the total wall time, s; then the solver returns an error
};

/// Final state of a body.
struct BodyAnswer {
    physics::BodyId body;
    physics::WorldPosition centre;  ///< position of the centre of mass, m
    double angle = 0.0;             ///< angle including full revolutions, rad
    double velocityX = 0.0;         ///< of the centre of mass, m/s
    double velocityY = 0.0;         ///< of the centre of mass, m/s
    double angularVelocity = 0.0;   ///< rad/s
};

/// Final force at a contact point.
struct ContactAnswer {
    physics::BodyId a, b;
    std::uint32_t shapeA = 0, shapeB = 0;  ///< indices in World::shapes
    physics::WorldPosition point;          ///< contact point, m
    double normalX = 0.0, normalY = 0.0;   ///< unit normal from a to b
    double force = 0.0;                    ///< normal force on b, N
    double friction = 0.0;                 ///< friction force on b along the normal rotated by +90 degrees, N
};

/// Final force (at the anchor) and torque that a joint exerts on its body B.
struct JointAnswer {
    std::uint32_t joint = 0;            ///< index in World::joints
    double forceX = 0.0, forceY = 0.0;  ///< N
    double torque = 0.0;                ///< constraint torque, N m
};

/// The reference solution: the state after `seconds`, and its accuracy.
struct Answer {
    double seconds = 0.0;            ///< simulated time, s
    std::vector<BodyAnswer> bodies;  ///< all dynamic bodies
    std::vector<ContactAnswer> contacts;
    std::vector<JointAnswer> joints;
    double energy = 0.0;         ///< kinetic energy plus potential energy relative to the world's origin, J
    double error = 0.0;          ///< estimated maximum error of the bodies' centres, m
    double angleError = 0.0;     ///< estimated maximum error of the angles, rad
    double velocityError = 0.0;  ///< estimated maximum error of the velocities, m/s
    double order = 0.0;          ///< observed order of convergence; 0 if all runs agree except for rounding
    double step = 0.0;           ///< time step of the finest run, whose results are stored here, s
    int runs = 0;                ///< number of runs
    std::vector<double> differences;  ///< largest distance of a body between consecutive runs, m
    double residual = 0.0;            ///< largest residual of all solved systems, ratio to the velocities
    long steps = 0, hits = 0, factorings = 0, sweeps = 0;  ///< counts of the finest run

    /// True if the solution can be used to measure an error of `judged` m: it is 100 times as accurate.
    [[nodiscard]] bool canJudge(double judged) const { return error <= 0.01 * judged; }
};

/// Computes the motion of a world over a time, s. The world is not changed.
/// @error an unsupported feature of the scene, or runs that did not converge within Options::patience,
/// mostly because the scene is chaotic
Result<Answer> solveReference(const physics::World& world, double seconds, const Options& options = {});

/// Deviation of a world from the reference solution.
struct Difference {
    double position = 0.0;  ///< largest distance of a body's centre from the solution, m
    double angle = 0.0;     ///< largest difference of a body's angle, rad
    double velocity = 0.0;  ///< largest difference of a body's velocity, m/s
    physics::BodyId body;   ///< the body with the largest distance
};

/// Compares a world, simulated for Answer::seconds, with the reference solution. Skips destroyed bodies.
[[nodiscard]] Difference compare(const physics::World& world, const Answer& answer);

}  // namespace plumb::reference
