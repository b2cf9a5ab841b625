#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/accuracy/reference/find_touches.hpp"

namespace plumb::reference {

/// m: nearer than this a contact is closed. The sizes in a user's world are float and tell no less apart.
inline constexpr double kClosed = 1.0e-8;
/// m: touches further away are no matter of a step, unless something hits something in it.
inline constexpr double kNear = 1.0e-3;

/// What pushed in a touch.
struct Press {
    Touch touch;
    double normal = 0.0;   ///< N
    double tangent = 0.0;  ///< N on B along perpendicular(normal)
};

/// Bodies that may touch or are tied in a step, apart from all others.
struct Group {
    std::vector<std::uint32_t> bodies;  ///< in Scene::bodies; those that can be pushed come first
    std::size_t pushed = 0;             ///< how many of them can be
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  ///< of outlines that may touch
    std::vector<std::uint32_t> laws;                             ///< in Scene::laws
};

/// Where a run is, and what it found on its way.
struct RunState {
    std::vector<Triple> poses, velocities;  ///< by body
    std::vector<Triple> accelerations;      ///< m/s2, rad/s2: of the last step, to guess the next from
    std::vector<Press> presses;             ///< of the last step, sorted by key
    std::vector<Triple> lawForces;          ///< N, N m: on B in the last step, by law
    std::vector<double> lawPushes;          ///< N or N m: the same as the solver counts it
    double worstResidual = 0.0;             ///< ratio to the speeds there were: of all systems
    long factorings = 0;
    long sweeps = 0;
    long events = 0;
    long steps = 0;
    std::string trouble;  ///< empty, or why there is no answer
};

}  // namespace plumb::reference
