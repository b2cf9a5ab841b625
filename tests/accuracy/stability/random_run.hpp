#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/accuracy/stability/play.hpp"

namespace plumb::stability {

/// Results of several FairScene runs.
struct FairFindings {
    std::size_t count = 0;
    std::size_t bad = 0;     ///< scenes with non-finite numbers
    std::size_t gained = 0;  ///< scenes whose energy grew by more than 1 %
    double mostGain = 0.0;   ///< largest energy gain, ratio
    std::uint64_t seed = 0;  ///< seed of the scene with the largest gain, or with non-finite numbers
};

/// Results of a run of random scenes.
struct RandomFindings {
    std::size_t wild = 0;  ///< scenes with overlaps and random edits, only checked for non-finite numbers
    std::size_t bad = 0;   ///< scenes of `wild` with non-finite numbers
    std::uint64_t firstBad = 0;   ///< seed of the first such scene
    FairFindings loose, jointed;  ///< FairScene runs without and with joints

    [[nodiscard]] bool isSound() const {
        return bad + loose.bad + loose.gained + jointed.bad + jointed.gained == 0;
    }
};

/// Runs `count` extreme scenes and `count` FairScenes on several threads.
RandomFindings playRandomScenes(std::size_t count, int threads, const accuracy::ShowDone& show = {});
std::string textOf(const RandomFindings& findings);

}  // namespace plumb::stability
