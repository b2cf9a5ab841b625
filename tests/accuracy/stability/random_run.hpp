#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/accuracy/stability/play.hpp"

namespace plumb::stability {

/// What came out of many random scenes.
struct RandomFindings {
    std::size_t wild = 0;        ///< thrown together and mistreated: only their numbers are looked at
    std::size_t bad = 0;         ///< of those, with numbers that went bad
    std::size_t fair = 0;        ///< nothing overlaps at the start and nothing is driven: energy is counted
    std::size_t fairBad = 0;     ///< of those, with numbers that went bad
    std::size_t gained = 0;      ///< of those, whose energy grew by more than 1 %
    double mostGain = 0.0;       ///< ratio
    std::uint64_t firstBad = 0;  ///< seeds, to look into
    std::uint64_t mostGainSeed = 0;

    [[nodiscard]] bool isSound() const { return bad + fairBad + gained == 0; }
};

/// Plays `count` scenes of each kind, on some threads.
RandomFindings playRandomScenes(std::size_t count, int threads, const Progress& progress = {});
std::string textOf(const RandomFindings& findings);

/// Of one fair scene: most energy at any time over that at the start, minus 1; infinite for bad numbers.
double energyGainOfFairScene(std::uint64_t seed);

}  // namespace plumb::stability
