// Automatic quality depends only on the simulated state, not on the speed at which it is played.

#include <algorithm>

#include "app/step_clock.hpp"
#include "physics/simulation.hpp"
#include "tests/app/playground/playground.hpp"

namespace plumb {
namespace {

constexpr int kTicks = 240;

/// A heavy box on two light ones, with an error tolerance of half a pixel.
struct HeldMasses : Playground {
    HeldMasses() : Playground{"masses", "physics-lab"} {
        auto& physics = game.world.get<ScenePhysics>(find("how exact"));
        physics.quality = 0;
        physics.tolerance = 0.5f;
    }
    [[nodiscard]] const physics::World& bodies() { return game.world.resource<PhysicsState>().world; }
    /// Maximum quality (log2 of the substeps) of all islands of bodies.
    [[nodiscard]] int quality() {
        int best = -1;
        for (const physics::SubstepController& effort : bodies().bodies.substepControllers)
            best = std::max(best, int{effort.quality});
        return best;
    }
    /// Plays at a multiple of real time, in frames of a display of `rate` Hz.
    void runAt(double speed, double rate) {
        StepClock clock;
        for (int done = 0; done < kTicks;) {
            for (int ticks = clock.advance(speed / rate).ticks; ticks > 0 && done < kTicks; --ticks, ++done)
                run(1);
        }
    }
};

TEST(TolerancePace, theSameBitsAtTenTimesAndATenthOfRealTime) {
    HeldMasses real;
    real.runAt(1.0, 60.0);
    ASSERT_GT(real.quality(), 0) << "the tolerance must raise the quality";
    ASSERT_GT(real.bodies().contacts.size(), 0u);
    for (const auto& [speed, rate] : {std::pair{10.0, 60.0}, {0.1, 60.0}, {10.0, 144.0}, {0.1, 30.0}}) {
        HeldMasses other;
        other.runAt(speed, rate);
        EXPECT_EQ(other.game.world.hash(), real.game.world.hash()) << speed << " times, at " << rate << " Hz";
    }
}

TEST(TolerancePace, theToleranceOfAComponentIsInPixels) {
    HeldMasses held;
    held.run(1);
    EXPECT_FLOAT_EQ(held.bodies().settings.tolerance, 0.5f / 128.0f);
    held.game.world.get<ScenePhysics>(held.find("how exact")).tolerance = 0.0f;
    held.run(1);
    EXPECT_EQ(held.bodies().settings.tolerance, 0.0f);
}

}  // namespace
}  // namespace plumb
