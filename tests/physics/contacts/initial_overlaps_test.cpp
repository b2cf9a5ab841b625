#include <algorithm>

#include <gtest/gtest.h>

#include "tests/physics/support/world_of_bodies.hpp"

namespace plumb::physics {
namespace {

float fastestOf(const World& world) {
    float fastest = 0.0f;
    for (const BodyMotion& motion : world.bodies.motion) fastest = std::max(fastest, length(motion.velocity));
    return fastest;
}

TEST(InitialOverlaps, areSeparatedSlowly) {
    for (const float depth : {0.05f, 0.2f, 0.4f}) {
        for (const Quality quality : {Quality{0}, Quality{2}, Quality{4}}) {
            SCOPED_TRACE(testing::Message() << depth << " m, quality " << int{quality});
            Playground scene;
            scene.world.settings.gravity = {};
            scene.world.settings.quality = quality;
            const BodyId left = scene.crate({0.0, 0.0});
            const BodyId right = scene.crate({1.0 - double{depth}, 0.0});
            float fastest = 0.0f;
            for (int i = 0; i < 180; ++i) {
                scene.run(1);
                fastest = std::max(fastest, fastestOf(scene.world));
            }
            EXPECT_GT(fastest, 0.0f);
            EXPECT_LT(fastest, 1.0f);
            EXPECT_GT(scene.x(right) - scene.x(left), 1.0 - double{scene.world.settings.slop});
        }
    }
}

TEST(InitialOverlaps, keepTheirBodiesAwake) {
    Playground scene;
    scene.world.settings.sleeping = true;
    scene.floor();
    const BodyId crate = scene.crate({0.0, 0.2});
    scene.run(180);
    EXPECT_NEAR(scene.y(crate), 0.5, 0.01);
}

TEST(InitialOverlaps, doNotExistWithATrigger) {
    const auto ticksAwake = [](bool inTrigger) {
        Playground scene;
        scene.world.settings.sleeping = true;
        scene.floor();
        if (inTrigger)
            scene.shape(scene.body(BodyKind::Static, {0.0, 0.0}), box({100.0f, 100.0f}), {.isTrigger = true});
        const BodyId crate = scene.crate({0.0, 0.5});
        int ticks = 0;
        for (; ticks < 1000 && isAwake(scene.world, crate); ++ticks) scene.run(1);
        return ticks;
    };
    EXPECT_LT(ticksAwake(false), 100);
    EXPECT_EQ(ticksAwake(true), ticksAwake(false));
}

TEST(InitialOverlaps, doNotExistIfTheDepthResultsFromMotion) {
    Playground scene;
    scene.world.settings.continuous = false;
    scene.floor();
    const BodyId crate = scene.crate({0.0, 0.75});
    ASSERT_TRUE(setVelocity(scene.world, crate, {0.0f, -30.0f}).ok());
    scene.run(1);  // the crate overlaps the floor by 0.25 m after this step
    scene.run(12);
    EXPECT_NEAR(scene.y(crate), 0.5, 0.02);
}

TEST(InitialOverlaps, ofAHeavyBodyInALightOneAreSeparatedToo) {
    Playground scene;
    scene.world.settings.automaticQuality = true;
    scene.floor();
    scene.crate({0.0, 0.5});
    const BodyId heavy = scene.crate({0.0, 1.3});
    ASSERT_TRUE(setMass(scene.world, heavy, 100.0f).ok());
    scene.run(300);
    EXPECT_NEAR(scene.y(heavy), 1.5, 0.02);
}

}  // namespace
}  // namespace plumb::physics
