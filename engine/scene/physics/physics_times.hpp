#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/profile.hpp"
#include "ecs/world.hpp"

namespace plumb {

/// Measures the time of the stages of a world's physics while it is shown. A service of that world, so it
/// must outlive the world's last tick.
class PhysicsTimes {
public:
    struct Row {
        std::string_view stage;
        float milliseconds = 0.0f;  ///< CPU time per tick, mean over half a second
    };

    /// Starts measuring this world, or stops measuring.
    void watch(World& world, bool on);

    /// Times of the last complete half second, in the order
    /// of the stages; stages that did not run have no row.
    [[nodiscard]] std::span<const Row> rows() const { return rows_; }

    // Called by the physics.
    /// Returns the profile to measure with; null while times are not shown.
    [[nodiscard]] Profile* profile() { return watching_ ? &profile_ : nullptr; }
    void endStep();
    /// Adds the times of a tick that was measured with another
    /// profile, as only one profile can measure at a time.
    void take(const Profile& tick);

private:
    void readRows();

    Profile profile_;
    std::vector<Row> rows_;
    int steps_ = 0;
    bool watching_ = false;
};

/// Profiler zone of the synchronization of components and bodies, in addition to those of physics::stages().
inline constexpr std::string_view kPhysicsSync = "physics sync";

}  // namespace plumb
