#include <span>

#include <gtest/gtest.h>

#include "tests/physics/support/joint_world.hpp"

// Springs of every kind of joint, from soft ones to ones that are too stiff for the substep, must deflect by
// their formula.

using namespace plumb;
using namespace plumb::physics;

namespace {

constexpr float kHertz[] = {0.7f, 3.0f, 10.0f, 25.0f, 60.0f};

/// Deflection of a spring of this frequency under the weight of the mass that determines its frequency, m.
float sagOf(float hertz) { return JointWorld::kGravity / (kTau * hertz * kTau * hertz); }

/// A spring joint between a disc and the ground.
struct Case {
    const char* name;
    JointDefinition joint;
    /// true if the whole joint is springy (JointDefinition::hertz) instead of only its spring
    bool whole = false;
};

const Case kHanging[] = {
    {"distance", {.kind = JointKind::Distance, .anchorA = {0.0f, 2.0f}, .length = 2.0f}},
    {"prismatic", {.kind = JointKind::Prismatic, .axis = {0.0f, 1.0f}}},
    {"prismatic with a rest",
     {.kind = JointKind::Prismatic,
      .anchorA = {0.0f, 1.5f},
      .axis = {0.0f, -1.0f},
      .spring = {.rest = 1.5f}}},
    {"wheel, whose motor drives its rotation only",
     {.kind = JointKind::Wheel, .axis = {0.0f, 1.0f}, .motor = {true, 3.0f, 5.0f}}},
    {"mouse", {.kind = JointKind::Mouse}},
    {"motor", {.kind = JointKind::Motor}, true},
    {"motor with an offset",
     {.kind = JointKind::Motor, .anchorA = {0.5f, 0.25f}, .offset = {-0.5f, -0.25f}},
     true},
    {"soft weld", {.kind = JointKind::Weld}, true},
    {"soft hinge", {.kind = JointKind::Revolute}, true},
    {"soft rod", {.kind = JointKind::Distance, .anchorA = {0.0f, 2.0f}, .length = 2.0f}, true},
};

const Case kTurning[] = {
    {"hinge", {.kind = JointKind::Revolute}},
    {"hinge with a rest", {.kind = JointKind::Revolute, .referenceAngle = -0.7f, .spring = {.rest = 0.7f}}},
    {"weld with a spring", {.kind = JointKind::Weld}},
    {"soft weld", {.kind = JointKind::Weld}, true},
    {"motor", {.kind = JointKind::Motor}, true},
};

/// Creates a disc of 3 kg at the origin, held by the given joint with this frequency and critical damping.
BodyId tieDisc(JointWorld& scene, const Case& one, float hertz) {
    scene.world.settings.quality = 3;
    JointDefinition joint = one.joint;
    joint.a = scene.ground;
    joint.b = scene.disc({}, 3.0f);
    if (one.whole) {
        joint.hertz = hertz;
        joint.dampingRatio = 1.0f;
    } else {
        joint.spring = {true, hertz, 1.0f, joint.spring.rest};
    }
    scene.join(joint);
    return joint.b;
}

}  // namespace

TEST(JointSprings, deflectByTheForceOverTheirStiffness) {
    for (const Case& one : kHanging) {
        for (const float hertz : kHertz) {
            SCOPED_TRACE(testing::Message() << one.name << ", " << hertz << " Hz");
            JointWorld scene;
            const BodyId disc = tieDisc(scene, one, hertz);
            scene.run(2.0f + 4.0f / hertz);
            EXPECT_NEAR(scene.place(disc).y, -sagOf(hertz), 0.01f * sagOf(hertz) + 2.0e-6f);
            EXPECT_NEAR(scene.place(disc).x, 0.0f, 1.0e-4f);
        }
    }
}

TEST(JointSprings, rotateByTheTorqueOverTheirStiffness) {
    constexpr float kTorque = 1.0f;  // N m
    for (const Case& one : kTurning) {
        for (const float hertz : {3.0f, 10.0f, 25.0f, 60.0f}) {
            SCOPED_TRACE(testing::Message() << one.name << ", " << hertz << " Hz");
            JointWorld scene;
            const BodyId disc = tieDisc(scene, one, hertz);
            scene.world.settings.gravity = {};
            const float wanted =
                kTorque / (massDataOf(scene.world, disc).inertia * kTau * hertz * kTau * hertz);
            for (int i = 0; i < 180; ++i) {
                ASSERT_TRUE(applyTorque(scene.world, disc, kTorque));
                step(scene.world, JointWorld::kDt);
            }
            EXPECT_NEAR(scene.angle(disc), wanted, 0.01f * wanted + 2.0e-6f);
        }
    }
}

// Joints are solved in blocks of eight; here the last block is incomplete.
TEST(JointSprings, inBlocksBehaveLikeSingleOnes) {
    constexpr int kDiscs = 19;
    const auto push = [](World& world, BodyId disc, int i) {
        const float speed = 0.1f * static_cast<float>(i);
        ASSERT_TRUE(setVelocity(world, disc, {2.0f * speed, -speed}).ok());
        ASSERT_TRUE(setAngularVelocity(world, disc, 3.0f * speed).ok());
    };
    for (const std::span<const Case> cases :
         {std::span<const Case>{kHanging}, std::span<const Case>{kTurning}}) {
        for (const Case& one : cases) {
            SCOPED_TRACE(one.name);
            JointWorld crowd;
            std::vector<BodyId> discs;
            for (int i = 0; i < kDiscs; ++i) {
                discs.push_back(tieDisc(crowd, one, 3.0f));
                push(crowd.world, discs.back(), i);
            }
            crowd.run(0.5f);
            for (int i = 0; i < kDiscs; ++i) {
                JointWorld alone;
                const BodyId disc = tieDisc(alone, one, 3.0f);
                push(alone.world, disc, i);
                alone.run(0.5f);
                const BodyId same = discs[static_cast<std::size_t>(i)];
                EXPECT_EQ(positionOf(crowd.world, same), positionOf(alone.world, disc)) << i;
                EXPECT_EQ(velocityOf(crowd.world, same), velocityOf(alone.world, disc)) << i;
                EXPECT_EQ(crowd.angle(same), alone.angle(disc)) << i;
            }
        }
    }
}

TEST(JointSprings, oscillateWithTheirFrequencyAndDamping) {
    // x = exp(-z w t) cos(w sqrt(1 - z2) t) with damping ratio z: successive peaks differ by the factor
    // exp(-2 pi z / sqrt(1 - z2)).
    for (const float hertz : {1.0f, 2.5f}) {
        for (const float damping : {0.0f, 0.1f, 0.3f}) {
            for (const JointKind kind : {JointKind::Prismatic, JointKind::Wheel, JointKind::Mouse}) {
                SCOPED_TRACE(testing::Message() << hertz << " Hz, " << damping << ", " << int(kind));
                JointWorld scene;
                scene.world.settings.gravity = {};
                scene.world.settings.quality = 4;
                const BodyId disc = scene.disc({});
                scene.join({.kind = kind,
                            .a = scene.ground,
                            .b = disc,
                            .axis = {1.0f, 0.0f},
                            .spring = {true, hertz, damping}});
                ASSERT_TRUE(setPosition(scene.world, disc, {1.0, 0.0}, 0.0f));
                const float root = std::sqrt(1.0f - damping * damping);
                const auto period = static_cast<int>(std::lround(60.0f / (hertz * root)));
                float peak = -1.0f;
                int at = 0;
                for (int i = 1; i <= period + 5; ++i) {
                    step(scene.world, JointWorld::kDt);
                    if (i > period / 2 && scene.place(disc).x > peak) peak = scene.place(disc).x, at = i;
                }
                EXPECT_NEAR(at, period, 1);
                EXPECT_NEAR(peak, std::exp(-kTau * damping / root), 0.03f);
            }
        }
    }
}

TEST(JointSprings, theMotorOfAWheelRotatesItWithoutMovingIt) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId disc = scene.disc({1.0, 2.0});
    JointDefinition wheel = scene.define(JointKind::Wheel, scene.ground, disc, {1.0, 2.0});
    wheel.motor = {true, 4.0f, 1000.0f};
    const JointId joint = scene.join(wheel);
    for (int i = 0; i < 60; ++i) {
        step(scene.world, JointWorld::kDt);
        EXPECT_NEAR(length(scene.place(disc) - Vec2{1.0f, 2.0f}), 0.0f, 1.0e-5f);
        EXPECT_NEAR(angularVelocityOf(scene.world, disc), 4.0f, 1.0e-4f);
    }
    EXPECT_NEAR(readingOf(scene.world, joint).value, 0.0f, 1.0e-5f);
}

TEST(JointSprings, aMotorJointDrivesAtItsVelocityInTheFrameOfA) {
    for (const float angle : {0.0f, 0.8f, -2.0f}) {
        JointWorld scene;
        scene.world.settings.gravity = {};
        ASSERT_TRUE(setPosition(scene.world, scene.ground, {}, angle));
        const BodyId disc = scene.disc({});
        JointDefinition drive{.kind = JointKind::Motor, .a = scene.ground, .b = disc};
        drive.velocity = {2.0f, -0.5f};
        drive.motor = {true, 1.5f, 0.0f};
        drive.maxForce = 6.0f;
        drive.maxTorque = 0.5f;
        scene.join(drive);
        const Vec2 wanted = rotate(rotFromAngle(angle), drive.velocity);
        scene.run(0.1f);  // up to 6 N and 0.5 N m act on 1 kg and 1/8 kg m2
        const Vec2 early = velocityOf(scene.world, disc);
        EXPECT_NEAR(length(early), 0.6f, 0.01f);
        EXPECT_NEAR(dot(normalized(early), normalized(wanted)), 1.0f, 1.0e-4f);
        EXPECT_NEAR(angularVelocityOf(scene.world, disc), 0.4f, 0.01f);
        scene.run(1.0f);
        EXPECT_NEAR(length(velocityOf(scene.world, disc) - wanted), 0.0f, 0.01f);
        EXPECT_NEAR(angularVelocityOf(scene.world, disc), 1.5f, 0.01f);
    }
}
