#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/accuracy/families/stage.hpp"

namespace plumb::families {

/// What came of a scene.
struct Outcome {
    bool sound = true;        ///< every number finite, and nothing quarantined
    bool reached = true;      ///< every goal
    std::string missed;       ///< the first goal that was not, with its error
    double maxOverlap = 0.0;  ///< m, of scale 1; the largest of what was measured while it ran
    double maxJointError = 0.0;
    double energyGain = 0.0;   ///< part of the largest energy of motion; of closed scenes
    double maxJump = 0.0;      ///< m: by which a body moved further in a step than its speeds explain
    double restSpeed = 0.0;    ///< m/s: of the fastest body at the end
    std::size_t contacts = 0;  ///< the most in a step
    std::size_t awake = 0;     ///< dynamic bodies at the end
    double microsPerStep = 0.0;
    std::uint64_t bits = 0;           ///< hash of all poses and motions at the end, where the engine is ours
    std::vector<scenes::Point> ends;  ///< m: by body
    std::string missing;  ///< what the engine does not have for this scene; all else is then empty
};

/// Builds the scene and runs it to its end.
Outcome play(const Blueprint& plan, const Variation& variation = {});

/// m: how far a body of one outcome is from where it is in the other, at most.
double largestDistance(const Outcome& a, const Outcome& b);

}  // namespace plumb::families
