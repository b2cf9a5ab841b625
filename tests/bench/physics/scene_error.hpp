#pragma once

#include "tests/bench/physics/scene_builder.hpp"

namespace plumb::scenes {

/// Deviation of a world from its shapes and joints.
struct SceneError {
    double maxPenetration = 0.0;   ///< m
    double meanPenetration = 0.0;  ///< m, of the pairs that overlap by more than kNoticed
    std::size_t overlaps = 0;
    double maxJointError = 0.0;  ///< m between two points that should be one
    double meanJointError = 0.0;
    bool finite = true;  ///< no position is NaN or infinite

    static constexpr double kApart = 1.0;  ///< m; the weakest solver that still holds stretches by 0.7

    /// False if a joint came apart or numbers are not finite. A scene
    /// that fell apart is cheap to simulate, so its time has no meaning.
    [[nodiscard]] bool holds() const { return finite && maxJointError < kApart; }
};

/// Smaller values are rounding of positions 100 m from the origin.
inline constexpr double kNoticed = 2e-5;  // m

/// Exact overlaps of all pairs of shapes that should not overlap, computed from the positions.
SceneError errorOf(const SceneBuilder& world);

/// True if a position is not finite or a joint gap is too large to
/// recover (10 m). Some engines never finish a step of such a world.
bool isLost(const SceneBuilder& world);

}  // namespace plumb::scenes
