#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/accuracy/reference/find_touches.hpp"

namespace plumb::reference {

/// Gap below which a contact counts as closed, m. The lengths
/// of a physics world are floats and not more accurate.
inline constexpr double kClosed = 1.0e-8;
/// Gap above which contacts are ignored in a step, unless an impact occurs, m.
inline constexpr double kNear = 1.0e-3;

/// A contact with its force.
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
    std::vector<std::uint32_t> laws;                             ///< indices in Scene::laws
};

/// State and statistics of a run.
struct RunState {
    std::vector<Triple> poses, velocities;  ///< one per body
    std::vector<Triple> accelerations;      ///< last step's, guess for the next step, m/s2, rad/s2
    std::vector<Press> presses;             ///< contact forces of the last step, sorted by key
    std::vector<Triple> lawForces;          ///< force on B in the last step per law, N, N m
    std::vector<double> lawPushes;          ///< impulse row values of the last step per law, N or N m
    double worstResidual = 0.0;             ///< largest residual of all systems, ratio to the speeds
    long factorings = 0;
    long sweeps = 0;
    long events = 0;
    long steps = 0;
    std::string trouble;  ///< reason why the run failed; empty: none
};

}  // namespace plumb::reference
