#pragma once

#include "tests/bench/physics/scene_builder.hpp"

namespace plumb::scenes {

/// How far a world is from what its shapes and joints say.
struct SceneError {
    double maxPenetration = 0.0;   ///< m
    double meanPenetration = 0.0;  ///< m, of the pairs that overlap by more than kNoticed
    std::size_t overlaps = 0;
    double maxJointError = 0.0;  ///< m between two points that should be one
    double meanJointError = 0.0;
    bool finite = true;  ///< no position is NaN or infinite

    static constexpr double kApart = 1.0;  ///< m; the weakest solver that still holds stretches by 0.7

    /// False when a joint let go or numbers went bad. What has come apart is cheap to go on with, so such a
    /// time says nothing.
    [[nodiscard]] bool holds() const { return finite && maxJointError < kApart; }
};

/// Less is rounding of positions 100 m from the origin.
inline constexpr double kNoticed = 2e-5;  // m

/// Exact overlaps of all pairs of shapes that should not overlap, from the positions read back.
SceneError errorOf(const SceneBuilder& world);

/// Whether a position is NaN or infinite or a joint is open by more than anything comes back from (10 m).
/// Some engines never end a step of such a world.
bool isLost(const SceneBuilder& world);

}  // namespace plumb::scenes
