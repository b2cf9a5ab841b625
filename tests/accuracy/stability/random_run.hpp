#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/accuracy/stability/play.hpp"

namespace plumb::stability {

/// What came out of scenes in which nothing overlaps at the start and nothing is driven: FairScene.
struct FairFindings {
    std::size_t count = 0;
    std::size_t bad = 0;     ///< with numbers that went bad
    std::size_t gained = 0;  ///< whose energy grew by more than 1 %
    double mostGain = 0.0;   ///< ratio
    std::uint64_t seed = 0;  ///< of the scene that gained most, or whose numbers went bad
};

/// What came out of many random scenes.
struct RandomFindings {
    std::size_t wild = 0;         ///< thrown together and mistreated: only their numbers are looked at
    std::size_t bad = 0;          ///< of those, with numbers that went bad
    std::uint64_t firstBad = 0;   ///< its seed
    FairFindings loose, jointed;  ///< fair ones without and with joints

    [[nodiscard]] bool isSound() const {
        return bad + loose.bad + loose.gained + jointed.bad + jointed.gained == 0;
    }
};

/// Plays `count` wild and as many fair scenes, on some threads.
RandomFindings playRandomScenes(std::size_t count, int threads, const accuracy::ShowDone& show = {});
std::string textOf(const RandomFindings& findings);

}  // namespace plumb::stability
