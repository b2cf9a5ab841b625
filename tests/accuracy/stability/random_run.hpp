#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/accuracy/stability/play.hpp"

namespace plumb::stability {

/// Results of scenes without initial overlaps and drives: FairScene.
struct FairFindings {
    std::size_t count = 0;
    std::size_t bad = 0;     ///< with non-finite numbers
    std::size_t gained = 0;  ///< whose energy grew by more than 1 %
    double mostGain = 0.0;   ///< ratio
    std::uint64_t seed = 0;  ///< of the scene with the largest gain, or with non-finite numbers
};

/// Results of many random scenes.
struct RandomFindings {
    std::size_t wild = 0;         ///< with overlaps and random edits: only checked for non-finite numbers
    std::size_t bad = 0;          ///< of these, with non-finite numbers
    std::uint64_t firstBad = 0;   ///< its seed
    FairFindings loose, jointed;  ///< fair ones without and with joints

    [[nodiscard]] bool isSound() const {
        return bad + loose.bad + loose.gained + jointed.bad + jointed.gained == 0;
    }
};

/// Runs `count` wild and as many fair scenes on several threads.
RandomFindings playRandomScenes(std::size_t count, int threads, const accuracy::ShowDone& show = {});
std::string textOf(const RandomFindings& findings);

}  // namespace plumb::stability
