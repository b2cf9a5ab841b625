#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/accuracy/reference/find_touches.hpp"

namespace plumb::reference {

/// m: a contact with a smaller gap is closed. The sizes in a user's world are floats and no more accurate.
inline constexpr double kClosed = 1.0e-8;
/// m: contacts with larger gaps are ignored in a step, unless there is a hit.
inline constexpr double kNear = 1.0e-3;

/// The force of a contact.
struct Press {
    Touch touch;
    double normal = 0.0;   ///< N
    double tangent = 0.0;  ///< N on B along perpendicular(normal)
};

/// Bodies that may touch or have joints in a step, separate from all others.
struct Group {
    std::vector<std::uint32_t> bodies;                           ///< in Scene::bodies; dynamic ones first
    std::size_t pushed = 0;                                      ///< number of dynamic ones
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  ///< of outlines that may touch
    std::vector<std::uint32_t> laws;                             ///< in Scene::laws
};

/// State of a run, and its statistics.
struct RunState {
    std::vector<Triple> poses, velocities;  ///< by body
    std::vector<Triple> accelerations;      ///< m/s2, rad/s2: of the last step, to guess the next from
    std::vector<Press> presses;             ///< of the last step, sorted by key
    std::vector<Triple> lawForces;          ///< N, N m: on B in the last step, by law
    std::vector<double> lawPushes;          ///< N or N m: the same in the units of the solver
    double worstResidual = 0.0;             ///< ratio to the speeds there were: of all systems
    long factorings = 0;
    long sweeps = 0;
    long events = 0;
    long steps = 0;
    std::string trouble;  ///< empty, or the reason why there is no answer
};

}  // namespace plumb::reference
