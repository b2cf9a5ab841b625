#include <gtest/gtest.h>

#include "tests/physics/support/world_of_bodies.hpp"

namespace plumb::physics {
namespace {

constexpr ShapeDefinition kElastic{.friction = 0.0f, .bounciness = 1.0f};

/// A row of balls 1 m apart, of which the first `moving` arrive from the left at 4 m/s.
struct Row {
    Playground scene;
    std::vector<BodyId> balls;

    Row(int count, int moving) {
        scene.world.settings.gravity = {};
        for (int i = 0; i < count; ++i) {
            balls.push_back(
                scene.ball({static_cast<double>(i) - (i < moving ? 1.0 : 0.0), 0.0}, 0.5f, kElastic));
            if (i >= moving) continue;
            EXPECT_TRUE(setVelocity(scene.world, balls.back(), {4.0f, 0.0f}).ok());
        }
    }
    [[nodiscard]] float speed(int i) const { return scene.velocity(balls[static_cast<std::size_t>(i)]).x; }
};

TEST(ImpactChains, asManyBallsLeaveARowAsArrive) {
    for (int count = 2; count <= 9; ++count) {
        for (int moving = 1; moving < count; ++moving) {
            SCOPED_TRACE(testing::Message() << moving << " against " << count - moving);
            Row row{count, moving};
            row.scene.run(60);
            for (int i = 0; i < count; ++i)
                EXPECT_NEAR(row.speed(i), i < count - moving ? 0.0f : 4.0f, 0.02f);
        }
    }
}

TEST(ImpactChains, aRowInFrontOfAWallReflectsTheFirstBall) {
    Row row{5, 1};
    const BodyId wall = row.scene.body(BodyKind::Static, {5.5, 0.0});
    row.scene.shape(wall, box({1.0f, 5.0f}), kElastic);
    row.scene.run(60);
    EXPECT_NEAR(row.speed(0), -4.0f, 0.02f);
    for (int i = 1; i < 5; ++i) EXPECT_NEAR(row.speed(i), 0.0f, 0.02f);
}

TEST(ImpactChains, ofUnequalBallsKeepMomentumAndEnergy) {
    Row row{4, 1};
    const float masses[] = {1.0f, 3.0f, 0.5f, 2.0f};
    for (std::size_t i = 0; i < 4; ++i) ASSERT_TRUE(setMass(row.scene.world, row.balls[i], masses[i]).ok());
    row.scene.run(60);
    float momentum = 0.0f, energy = 0.0f;
    for (int i = 0; i < 4; ++i) {
        momentum += masses[i] * row.speed(i);
        energy += 0.5f * masses[i] * row.speed(i) * row.speed(i);
    }
    EXPECT_NEAR(momentum, 4.0f, 0.01f);
    EXPECT_NEAR(energy, 8.0f, 0.1f);
}

TEST(ImpactChains, anImpactOnARowUnderLoadIsComplete) {
    Playground scene;
    scene.floor(kElastic);
    std::vector<BodyId> column;
    for (int i = 0; i < 4; ++i) column.push_back(scene.ball({0.0, 0.5 + i}, 0.5f, kElastic));
    scene.run(30);
    const BodyId falling = scene.ball({0.0, 6.0}, 0.5f, kElastic);
    float highest = 0.0f;
    for (int i = 0; i < 120; ++i) {
        scene.run(1);
        highest = std::max(highest, static_cast<float>(scene.y(falling)));
    }
    EXPECT_NEAR(highest, 6.0f, 0.15f);  // a tenth of the height of its fall
}

}  // namespace
}  // namespace plumb::physics
