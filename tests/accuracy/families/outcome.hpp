#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/accuracy/families/stage.hpp"

namespace plumb::families {

/// The result of a scene.
struct Outcome {
    bool sound = true;        ///< all numbers finite, and nothing quarantined
    bool reached = true;      ///< every goal
    std::string missed;       ///< the first goal that was missed, with its error
    double maxOverlap = 0.0;  ///< m, at scale 1; maximum of the samples during the run
    double maxJointError = 0.0;
    double energyGain = 0.0;   ///< relative to the maximum kinetic energy; of closed scenes
    double maxJump = 0.0;      ///< m: displacement of a body in a step beyond what its velocities explain
    double restSpeed = 0.0;    ///< m/s: of the fastest body at the end
    std::size_t contacts = 0;  ///< maximum in a step
    std::size_t awake = 0;     ///< dynamic bodies at the end
    double microsPerStep = 0.0;
    std::uint64_t bits = 0;           ///< hash of all poses and motions at the end, for our engine
    std::vector<scenes::Point> ends;  ///< m: by body
    std::string missing;  ///< feature that the engine lacks for this scene; then all else is empty
};

/// Builds the scene and runs it to its end.
Outcome play(const Blueprint& plan, const Variation& variation = {});

/// m: maximum distance of a body's final positions in two outcomes.
double largestDistance(const Outcome& a, const Outcome& b);

}  // namespace plumb::families
