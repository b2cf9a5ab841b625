#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

// Adaptive substep controller: the quality (2^quality substeps) of an island where Settings::tolerance is
// set. It raises the quality quickly when the error is too large, by as much as the error calls for, lowers
// it slowly, and reverts if that was too much. Its state consists of numbers of the world, without clocks and
// randomness, so a repeated step gives the same result.

/// State of an island merged from two others: that of the one with the higher quality, or the maximum of each
/// member. Commutative and associative.
[[nodiscard]] SubstepController merged(const SubstepController& a, const SubstepController& b);

[[nodiscard]] SubstepController begun(Quality quality, float dt);

/// State after a step that left an error.
/// @param error  m: largest overlap or joint error of the island
/// @param minimum  quality that its bodies and joints ask for
[[nodiscard]] SubstepController judged(SubstepController controller, float error, float tolerance,
                                       Quality minimum, float dt);

/// True while an error is being reduced: an island that fell asleep now would keep it.
[[nodiscard]] constexpr bool isAtWork(const SubstepController& controller) {
    return controller.phase == SubstepPhase::Strained || controller.phase == SubstepPhase::Rising;
}

}  // namespace plumb::physics
