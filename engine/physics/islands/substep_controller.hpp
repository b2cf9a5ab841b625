#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

// Adaptive substep controller: chooses the quality (2^quality substeps) of an island if Settings::tolerance
// is set. Raises the quality quickly if the error is too large, lowers it slowly, and reverts if the error
// then grows too much. Its state is part of the world, without clocks and randomness: steps are reproducible.

/// Returns the state of an island merged from two others: that of the one with the higher quality; at equal
/// quality the maximum of each member. Commutative and associative.
[[nodiscard]] SubstepController merged(const SubstepController& a, const SubstepController& b);

[[nodiscard]] SubstepController begun(Quality quality, float dt);  ///< the initial state

/// Returns the state after a step.
/// @param error  m: largest overlap or joint error of the island after the step
/// @param minimum  lower limit: the highest quality set for its bodies and joints
[[nodiscard]] SubstepController judged(SubstepController controller, float error, float tolerance,
                                       Quality minimum, float dt);

/// True while an error is being reduced. The island must not fall asleep, or the error would remain.
[[nodiscard]] constexpr bool isAtWork(const SubstepController& controller) {
    return controller.phase == SubstepPhase::Strained || controller.phase == SubstepPhase::Rising;
}

}  // namespace plumb::physics
