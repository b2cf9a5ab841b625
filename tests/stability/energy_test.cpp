#include <cmath>

#include <gtest/gtest.h>

#include "tests/accuracy/stability/fair_scene.hpp"
#include "tests/accuracy/stability/lab.hpp"

// Energy that came from nowhere once, and must not again.

namespace plumb::stability {
namespace {

// A small body on a long arm, thrown about, was spun until its numbers went bad.
TEST(StabilityEnergy, aSpinHasAnEnd) {
    FairScene scene{4616};
    scene.run();
    EXPECT_TRUE(scene.isSound());
    const physics::World& world = scene.world();
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const float spin = std::fabs(world.bodies.motion[i].angularVelocity);
        EXPECT_LE(spin * world.bodies.info[i].reach, 1.001f * world.settings.maxSpeed) << "body " << i;
    }
    // Its speed is one that anybody may have.
    Lab lab{{.gravity = 0.0}, {.rests = false}};
    const BodyHandle plank = lab.add(scenes::box({1.0f, 0.1f}), {});
    lab.setVelocity(plank, {}, 1000.0);
    lab.run(1.0);
    EXPECT_FLOAT_EQ(physics::angularVelocityOf(lab.world(), lab.idOf(plank)), 1000.0f);
}

}  // namespace
}  // namespace plumb::stability
