#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/accuracy/families/stage.hpp"

namespace plumb::families {

/// Result of simulating a scene.
struct Outcome {
    bool sound = true;           ///< true if all numbers are finite and no body is quarantined
    bool reached = true;         ///< true if all goals are reached
    std::string missed;          ///< first missed goal, with its error
    double maxOverlap = 0.0;     ///< maximum of the sampled overlaps, m, converted to a placement scale of 1
    double maxJointError = 0.0;  ///< maximum of the sampled joint errors, likewise, m
    double energyGain = 0.0;     ///< energy gain, ratio to the converted energy; 0 if not Blueprint::closed
    double maxJump = 0.0;        ///< maximum displacement of a body in a step beyond velocity times step, m
    double restSpeed = 0.0;      ///< speed of the fastest body at the end, m/s
    std::size_t contacts = 0;    ///< maximum number of contacts in a step
    std::size_t awake = 0;       ///< number of awake dynamic bodies at the end
    double microsPerStep = 0.0;
    std::uint64_t bits = 0;           ///< hash of all poses and velocities at the end; Plumb only
    std::vector<scenes::Point> ends;  ///< final position of each body, m
    std::string missing;              ///< feature that the engine lacks; not empty: the scene was not run
};

/// Builds a scene and simulates it to its end.
Outcome play(const Blueprint& plan, const Variation& variation = {});

/// Maximum distance between the final positions of a body in two outcomes, m.
double largestDistance(const Outcome& a, const Outcome& b);

}  // namespace plumb::families
