#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

// The quality of an island where there is a tolerance: up quickly when its error is too large, by as much as
// the error says; down slowly, and back again where that was too much. Numbers only: no clock, no chance, so
// it is the same wherever the world is stepped again.

/// That of an island that two others make up: of the one that takes more trouble. In any order the same.
[[nodiscard]] Effort merged(const Effort& a, const Effort& b);

/// That of an island that was never judged.
[[nodiscard]] Effort begun(Quality quality);

/// What comes after a step that left an error.
/// @param error  m: the largest overlap or opening of the island
/// @param least  the quality that its bodies and joints ask for
[[nodiscard]] Effort judged(Effort effort, float error, float tolerance, Quality least);

/// True while an error is being worked off: an island that slept now would keep it.
[[nodiscard]] constexpr bool isAtWork(const Effort& effort) {
    return effort.phase == EffortPhase::Strained || effort.phase == EffortPhase::Rising;
}

}  // namespace plumb::physics
