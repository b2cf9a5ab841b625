#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/accuracy/reference/find_touches.hpp"

namespace plumb::reference {

/// Gap below which a contact counts as closed, m. A smaller limit is
/// useless, because the lengths of a physics world are floats.
inline constexpr double kClosed = 1.0e-8;
/// Gap above which a contact is ignored in a step, m. Contacts that close in the step are found as impacts.
inline constexpr double kNear = 1.0e-3;

/// A contact and the force that it exerts.
struct Press {
    Touch touch;
    double normal = 0.0;   ///< normal force, N
    double tangent = 0.0;  ///< friction force on B along perpendicular(normal), N
};

/// An independent group of bodies that may touch each other in a step or are connected by joints.
struct Group {
    std::vector<std::uint32_t> bodies;  ///< indices in Scene::bodies; dynamic bodies first
    std::size_t pushed = 0;             ///< number of dynamic bodies
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  ///< pairs of outlines that may touch
    std::vector<std::uint32_t> laws;                             ///< joint laws: indices in Scene::laws
};

/// State and statistics of a run.
struct RunState {
    std::vector<Triple> poses, velocities;  ///< one per body
    std::vector<Triple> accelerations;      ///< in the last step, m/s2, rad/s2; the guess for the next step
    std::vector<Press> presses;             ///< contact forces of the last step, sorted by key
    std::vector<Triple> lawForces;          ///< per law: its force on body B in the last step, N, N m
    std::vector<double> lawPushes;          ///< per law: force of its solver row in the last step, N or N m
    double worstResidual = 0.0;             ///< largest residual of all solved systems, ratio to the speeds
    long factorings = 0;                    ///< number of matrix factorizations
    long sweeps = 0;                        ///< number of Gauss-Seidel sweeps
    long events = 0;                        ///< number of impacts
    long steps = 0;                         ///< number of time steps
    std::string trouble;                    ///< reason why the run failed; empty: none
};

}  // namespace plumb::reference
