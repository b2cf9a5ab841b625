#include <gtest/gtest.h>

#include "tests/physics/support/world_of_bodies.hpp"

namespace plumb::physics {
namespace {

/// A thin kinematic wall, so fast that it could pass through the body in front of it within one step.
struct FastWall : Playground {
    BodyId wall;
    BodyId ball;
    float speed;

    FastWall(float thickness, float metersPerSecond, float radius, double gap) : speed{metersPerSecond} {
        ball = this->Playground::ball({0.0, static_cast<double>(radius)}, radius);
        wall = body(BodyKind::Kinematic, {-gap - static_cast<double>(radius + 0.5f * thickness), 1.0});
        shape(wall, box({0.5f * thickness, 1.0f}));
        EXPECT_TRUE(setVelocity(world, wall, {speed, 0.0f}).ok());
    }
    [[nodiscard]] bool isBehind() const { return x(ball) < positionOf(world, wall).x; }
};

constexpr struct {
    float thickness, speed;
} kWalls[] = {{0.2f, 20.0f}, {0.05f, 10.0f}, {0.5f, 40.0f}, {0.02f, 100.0f}};

template <class Prepare>
void expectPushing(Prepare&& prepare) {
    for (const auto& [thickness, speed] : kWalls) {
        for (int phase = 0; phase < 20; ++phase) {
            const double gap = 0.5 + static_cast<double>(speed * kTick) * phase / 20.0;
            FastWall scene{thickness, speed, 0.1f, gap};
            prepare(scene);
            for (int i = 0; i < 60; ++i) {
                scene.run(1);
                ASSERT_FALSE(scene.isBehind()) << thickness << " m at " << speed << " m/s, phase " << phase;
            }
        }
    }
}

TEST(KinematicSweep, pushesFloatingBodies) {
    expectPushing([](FastWall& scene) { scene.world.settings.gravity = {}; });
}

TEST(KinematicSweep, pushesBodiesThatRestOnAFloor) {
    expectPushing([](FastWall& scene) { scene.floor({}, 500.0f); });
}

TEST(KinematicSweep, wakesAndPushesSleepers) {
    expectPushing([](FastWall& scene) {
        scene.world.settings.sleeping = true;
        scene.floor({}, 500.0f);
        ASSERT_TRUE(setVelocity(scene.world, scene.wall, {}).ok());
        scene.run(120);
        ASSERT_FALSE(isAwake(scene.world, scene.ball));
        ASSERT_TRUE(setVelocity(scene.world, scene.wall, {scene.speed, 0.0f}).ok());
    });
}

TEST(OneWay, holdsBodiesThatPassedItFromBelow) {
    for (const float half : {0.1f, 0.3f, 0.6f}) {
        for (const float angle : {0.0f, 0.2f}) {
            SCOPED_TRACE(testing::Message() << half << " m, " << angle << " rad");
            Playground scene;
            const BodyId platform = scene.body(BodyKind::Static, {0.0, 2.0});
            scene.shape(platform, box({3.0f, 0.05f}), {.oneWay = true, .oneWayDirection = {0.0f, 1.0f}});
            scene.floor();
            const BodyId crate = scene.body(BodyKind::Dynamic, {0.0, 0.7}, angle);
            scene.shape(crate, box({half, half}));
            ASSERT_TRUE(setVelocity(scene.world, crate, {0.0f, 9.0f}).ok());
            scene.run(300);
            EXPECT_NEAR(scene.y(crate), 2.05 + static_cast<double>(half), 0.01);
        }
    }
}

}  // namespace
}  // namespace plumb::physics
