#include <cmath>
#include <limits>

#include "core/profile.hpp"
#include "tests/box_physics/scene_of_bodies.hpp"

namespace plumb::box_physics {
namespace {

TEST(Motion, aFreeFallFollowsTheFormula) {
    Stage60 s;
    const BodyId ball = s.ball({0, 0}, 0.1f, {3.0f, -4.0f});
    for (int i = 1; i <= 120; ++i) {
        s.run(1);
        const float t = static_cast<float>(i) * kTick;
        EXPECT_NEAR(s.position(ball).x, 3.0f * t, 2e-4f);
        EXPECT_NEAR(s.position(ball).y, -4.0f * t + 0.5f * 9.81f * t * t, 2e-4f);
    }
}

TEST(Motion, gravityIsOnlyThereWhenCalledFor) {
    Stage60 s;
    const BodyId ball = s.ball({0, 0}, 0.1f, {1, 0});
    for (int i = 0; i < 60; ++i) step(s.world, s.settings, kTick, kMotion);
    EXPECT_NEAR(s.position(ball).x, 1.0f, 1e-5f);
    EXPECT_EQ(s.position(ball).y, 0.0f);
    for (int i = 0; i < 60; ++i) step(s.world, s.settings, kTick, kGravity);
    EXPECT_NEAR(s.velocity(ball).y, 9.81f, 1e-4f);
    EXPECT_EQ(s.position(ball).y, 0.0f);
}

TEST(Motion, aWorldWithoutContactsPaysNothingForThem) {
    Stage60 s;
    s.ball({0, 0}, 0.1f);
    Profile profile;
    step(s.world, s.settings, kTick, kGravity | kMotion, &profile);
    for (const Profile::Zone& zone : profile.zones()) {
        EXPECT_NE(zone.name, "broad phase");
        EXPECT_NE(zone.name, "narrow phase");
    }
    EXPECT_TRUE(s.world.work.pairs.empty());
}

TEST(Motion, aKinematicBodyArrivesExactlyWhereItIsMoved) {
    Stage60 s;
    const BodyId platform = s.box(BodyKind::Kinematic, {0.1f, 0.3f}, {1, 0.1f});
    ASSERT_TRUE(moveTo(s.world, platform, {0.7f, -0.2f}).ok());
    s.run(1);
    EXPECT_EQ(s.position(platform), (Vec2{0.7f, -0.2f}));
    s.run(1);
    EXPECT_NE(s.position(platform), (Vec2{0.7f, -0.2f}))
        << "it keeps its velocity until it is told otherwise";
}

TEST(Motion, whatIsNotANumberIsRefusedWithAMessage) {
    const float inf = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Stage60 s;
    const BodyId ball = s.ball({1, 2}, 0.1f);
    for (const float bad : {nan, inf, -inf, 1e30f}) {
        EXPECT_FALSE(setPosition(s.world, ball, {bad, 0}).ok());
        EXPECT_FALSE(setVelocity(s.world, ball, {0, bad}).ok());
        EXPECT_FALSE(setAcceleration(s.world, ball, {bad, bad}).ok());
        EXPECT_FALSE(setMass(s.world, ball, bad).ok());
        EXPECT_FALSE(setShape(s.world, ball, Shape::circle(bad)).ok());
        EXPECT_FALSE(setSurface(s.world, ball, bad, 0, 1).ok());
        BodyDefinition d;
        d.position.x = bad;
        const Result<BodyId> body = createBody(s.world, d);
        ASSERT_FALSE(body.ok());
        EXPECT_FALSE(body.error().what.empty());
        EXPECT_FALSE(body.error().remedy.empty());
    }
    EXPECT_FALSE(setMass(s.world, ball, 0.0f).ok());
    EXPECT_FALSE(setShape(s.world, ball, Shape::box({0, 1})).ok());
    EXPECT_EQ(s.position(ball), (Vec2{1, 2}));
    EXPECT_EQ(bodyCount(s.world), 1u);
}

TEST(Motion, aStaleIdNeverMeansANewBody) {
    Stage60 s;
    const BodyId old = s.ball({0, 0}, 1);
    destroyBody(s.world, old);
    const BodyId fresh = s.ball({5, 0}, 1);
    EXPECT_EQ(old.index, fresh.index);
    EXPECT_FALSE(alive(s.world, old));
    destroyBody(s.world, old);
    EXPECT_TRUE(alive(s.world, fresh));
    EXPECT_FALSE(alive(s.world, BodyId{}));
}

}  // namespace
}  // namespace plumb::box_physics
