#pragma once

#include "tests/bench/physics/scene_builder.hpp"

namespace plumb::scenes {

/// Errors of a world: overlaps of shapes and gaps of joints.
struct SceneError {
    double maxPenetration = 0.0;   ///< m
    double meanPenetration = 0.0;  ///< m, mean of all pairs that overlap by more than kNoticed
    std::size_t overlaps = 0;      ///< number of pairs that overlap by more than kNoticed
    double maxJointError = 0.0;    ///< m, distance of two anchor points that should coincide
    double meanJointError = 0.0;   ///< m, mean of all joints
    bool finite = true;            ///< no position is NaN or infinite

    static constexpr double kApart = 1.0;  ///< m: gap of a failed joint; soft solvers reach 0.7 m

    /// False if a joint failed or numbers are not finite. The time of such
    /// a scene has no meaning, because separated bodies are cheap to simulate.
    [[nodiscard]] bool holds() const { return finite && maxJointError < kApart; }
};

/// Smallest overlap that counts, m; smaller ones can be rounding errors of positions 100 m from the origin.
inline constexpr double kNoticed = 2e-5;

/// Computes the overlaps of all pairs of shapes that collide, and the gaps of all joints, from the positions.
SceneError errorOf(const SceneBuilder& world);

/// True if a position is not finite or a joint gap is too large to
/// recover (10 m). Some engines never finish a step of such a world.
bool isLost(const SceneBuilder& world);

}  // namespace plumb::scenes
