#include <algorithm>

#include <gtest/gtest.h>

#include "tests/physics/support/joint_world.hpp"

// Joints that are created with anchors apart, or whose bodies are moved apart, close completely: within the
// speed limit, and without a remaining velocity.

namespace plumb::physics {
namespace {

constexpr float kTimes = 10.0f;  // closing speed, as a multiple of Settings::pushSpeed

/// A disc of 1 kg at rest, joined at its center to a point of the ground that is `gap` away along x.
struct Open {
    JointWorld scene;
    BodyId disc;
    JointId joint;

    Open(JointKind kind, float gap) {
        disc = scene.disc({static_cast<double>(gap), 0.0});
        joint = scene.join({.kind = kind, .a = scene.ground, .b = disc, .axis = {0.0f, 1.0f}});
    }
};

float fastestIn(JointWorld& scene, BodyId body, int steps) {
    float fastest = 0.0f;
    for (int i = 0; i < steps; ++i) {
        step(scene.world, JointWorld::kDt);
        fastest = std::max(fastest, length(velocityOf(scene.world, body)));
    }
    return fastest;
}

TEST(JointClosing, isCompleteBeforeItSleeps) {
    for (const bool direct : {true, false}) {
        for (const JointKind kind : {JointKind::Revolute, JointKind::Weld, JointKind::Prismatic}) {
            for (const float gap : {0.5f, 5.0f, 40.0f}) {
                SCOPED_TRACE(testing::Message() << direct << static_cast<int>(kind) << " " << gap);
                Open open{kind, gap};
                World& world = open.scene.world;
                world.settings.gravity = {};
                world.settings.sleeping = true;
                world.settings.directJoints = direct;
                // Maximum correction per step, m.
                const float most = kTimes * world.settings.pushSpeed * JointWorld::kDt;
                int steps = 0;
                for (float left = gap; left > world.settings.slop && steps < 600; ++steps) {
                    step(world, JointWorld::kDt);
                    const float now = length(open.scene.gapOf(open.joint));
                    ASSERT_LE(left - now, 1.01f * most) << steps;
                    left = now;
                }
                EXPECT_LE(steps, static_cast<int>(gap / most) + 30);
                open.scene.run(2.0f);
                EXPECT_FALSE(isAwake(world, open.disc));
            }
        }
    }
}

TEST(JointClosing, endsIfJointsContradictEachOther) {
    Open open{JointKind::Revolute, 2.0f};
    open.scene.world.settings.sleeping = true;
    (void)open.scene.join(
        {.kind = JointKind::Revolute, .a = open.scene.ground, .b = open.disc, .anchorA = {4.0f, 0.0f}});
    open.scene.run(5.0f);
    EXPECT_FALSE(isAwake(open.scene.world, open.disc));
    EXPECT_GT(length(open.scene.gapOf(open.joint)), 1.0f);
}

TEST(JointClosing, leavesASliderToGravityAlongItsAxis) {
    for (const bool direct : {true, false}) {
        SCOPED_TRACE(direct);
        Open open{JointKind::Prismatic, 12.0f};
        open.scene.world.settings.directJoints = direct;
        open.scene.run(0.5f);
        const float speed = 0.5f * JointWorld::kGravity;
        EXPECT_NEAR(velocityOf(open.scene.world, open.disc).y, -speed, 0.01f * speed);
        EXPECT_NEAR(open.scene.place(open.disc).y, -0.25f * speed, 0.02f * 0.25f * speed);
    }
}

// Regression: bodies had 537 m/s after the break.
TEST(JointClosing, leavesNoVelocityWhenTheJointBreaks) {
    for (const float gap : {5.0f, 15.0f, 40.0f}) {
        SCOPED_TRACE(gap);
        JointWorld scene;
        (void)*createShape(scene.world, scene.ground, box({0.35f, 0.21f}, {}, rotFromAngle(2.3f)));
        const BodyId a =
            *createBody(scene.world, {.position = {1.0, 0.9}, .angle = 0.58f, .velocity = {2.0f, -7.0f}});
        (void)*createShape(scene.world, a, segment({-0.55f, 0.0f}, {0.87f, 0.06f}));
        const WorldPosition far = WorldPosition{1.0, 0.9} + gap * Vec2{-0.7f, -0.7f};
        const BodyId b =
            *createBody(scene.world, {.position = far, .velocity = {-4.0f, -8.0f}, .angularVelocity = 4.0f});
        (void)*createShape(scene.world, b, circle(0.5f));
        (void)scene.join({.kind = JointKind::Weld, .a = a, .b = b, .breakForce = 30.0f});
        step(scene.world, JointWorld::kDt);
        EXPECT_EQ(scene.world.brokenJoints.size(), 1u);
        const float most = std::sqrt(4.0f * 4.0f + 8.0f * 8.0f) + JointWorld::kGravity * JointWorld::kDt;
        for (const BodyId body : {a, b}) EXPECT_LT(length(velocityOf(scene.world, body)), 1.5f * most);
    }
}

// Regression: bodies reached 124 m/s at quality 2 and 662 m/s at quality 3.
TEST(JointClosing, ofAPulleyEjectsNoBodyAtAnObstacle) {
    for (const int quality : {2, 3}) {
        SCOPED_TRACE(quality);
        JointWorld scene;
        World& world = scene.world;
        world.settings.gravity = {2.97572f, -7.41234f};
        world.settings.quality = static_cast<Quality>(quality);
        const BodyId a = *createBody(world, {.position = {-6.95889162, 12.4215624}, .angle = -2.69334698f});
        (void)*createShape(world, a,
                           box({0.384782f, 0.151097f}, {0.125299f, 0.0f}, {0.384316f, 0.923202f}, 0.0486073f),
                           {.density = 2.22407f});
        const BodyId b = *createBody(world, {.kind = BodyKind::Kinematic,
                                             .position = {13.1135343, 9.25147741},
                                             .angle = 1.2f,
                                             .velocity = {3.6f, 1.1f}});
        const BodyId below = *createBody(
            world, {.kind = BodyKind::Static, .position = {-6.59340715, 11.619133}, .angle = 2.8480444f});
        (void)*createShape(world, below, capsule({-0.229806f, 0.0f}, {0.339239f, 0.0f}, 0.223849f));
        (void)scene.join({.kind = JointKind::Pulley,
                          .a = a,
                          .b = b,
                          .anchorA = {-0.463576f, -0.195048f},
                          .anchorB = {-0.320562f, 0.272617f},
                          .length = 6.0f,
                          .groundA = {-3.39886f, 8.0f},
                          .groundB = {1.01241f, 8.0f},
                          .collideConnected = true});
        EXPECT_LT(fastestIn(scene, a, 120), kTimes * world.settings.pushSpeed);
    }
}

TEST(JointClosing, ofAMotorJointHasTheSameSpeedUnlessAFrequencyIsSet) {
    for (const float hertz : {0.0f, 5.0f}) {
        SCOPED_TRACE(hertz);
        Open open{JointKind::Motor, 40.0f};
        World& world = open.scene.world;
        world.settings.gravity = {};
        EXPECT_TRUE(change(world, open.joint, [&](JointDefinition& d) {
                        d.hertz = hertz, d.dampingRatio = 1.0f;
                    }).ok());
        EXPECT_NEAR(readingOf(world, open.joint).separation, 40.0f, 1.0e-3f);
        const float fastest = fastestIn(open.scene, open.disc, 180), most = kTimes * world.settings.pushSpeed;
        EXPECT_EQ(fastest <= most, hertz == 0.0f) << fastest;
        EXPECT_LT(readingOf(world, open.joint).separation, 0.01f);
    }
}

}  // namespace
}  // namespace plumb::physics
