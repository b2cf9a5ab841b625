#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/accuracy/stability/play.hpp"

namespace plumb::stability {

/// Results of several FairScene runs.
struct FairFindings {
    std::size_t count = 0;   ///< number of scenes
    std::size_t bad = 0;     ///< number of scenes with non-finite numbers
    std::size_t gained = 0;  ///< number of scenes whose energy grew by more than 1 %
    double mostGain = 0.0;   ///< largest energy gain, ratio to the initial energy
    std::uint64_t seed = 0;  ///< seed of the scene with the largest gain, or with non-finite numbers
};

/// Results of a run of random scenes.
struct RandomFindings {
    std::size_t wild = 0;  ///< number of extreme scenes (overlaps, random edits), which must stay finite
    std::size_t bad = 0;   ///< number of extreme scenes with non-finite numbers
    std::uint64_t firstBad = 0;   ///< seed of the first extreme scene with non-finite numbers
    FairFindings loose, jointed;  ///< results of FairScenes without and with joints

    [[nodiscard]] bool isSound() const {
        return bad + loose.bad + loose.gained + jointed.bad + jointed.gained == 0;
    }
};

/// Runs `count` extreme scenes and `count` FairScenes on several threads.
RandomFindings playRandomScenes(std::size_t count, int threads, const accuracy::ShowDone& show = {});
std::string textOf(const RandomFindings& findings);  ///< for the terminal

}  // namespace plumb::stability
