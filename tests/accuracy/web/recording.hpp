#pragma once

#include <string>
#include <vector>

#include "tests/accuracy/experiments.hpp"

namespace plumb::accuracy {

/// What can be seen of an experiment: its shapes, and where its bodies are before the first and after each
/// step.
struct Recording {
    std::vector<scenes::SceneBuilder::Body> bodies;
    std::vector<scenes::SceneBuilder::Shape> shapes;
    std::vector<scenes::JointSetup> joints;
    /// x, y (m) and angle (rad) of each body, one moment after the other. The position is relative to the
    /// first moving body at the beginning, because scenes may be far from the origin. NaN: it was destroyed.
    std::vector<float> poses;
    int moments = 0;  ///< number of recorded moments: 60 in a second
};

/// Runs an experiment and records it. Bodies that it creates after its first step are not recorded.
Recording record(const Experiment& experiment, const Method& method);

/// Returns the bodies, shapes and joints as a JSON object, without the poses.
std::string sceneJson(const Recording& recording);

}  // namespace plumb::accuracy
