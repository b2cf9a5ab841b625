#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/profile.hpp"
#include "ecs/world.hpp"

namespace plumb {

/// How long the stages of a world's physics take, while they are shown. A service of that world: has to
/// outlive it, or at least its last tick.
class PhysicsTimes {
public:
    struct Row {
        std::string_view stage;
        float milliseconds = 0.0f;  ///< CPU time of a tick, the mean of half a second
    };

    /// Measures this world from now on, or nothing any more.
    void watch(World& world, bool on);

    /// Of the half second before this one, in the order of the stages; those that did not run have no row.
    [[nodiscard]] std::span<const Row> rows() const { return rows_; }

    // For the physics.
    /// Where to measure; null while they are not shown.
    [[nodiscard]] Profile* profile() { return watching_ ? &profile_ : nullptr; }
    void endStep();
    /// Counts what another profile measured of a tick: a world has one at a time.
    void take(const Profile& tick);

private:
    void readRows();

    Profile profile_;
    std::vector<Row> rows_;
    int steps_ = 0;
    bool watching_ = false;
};

/// Zones of the bridge, beside those of physics::stages().
inline constexpr std::string_view kPhysicsSync = "physics sync";

}  // namespace plumb
