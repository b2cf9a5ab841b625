#include <functional>

#include <gtest/gtest.h>

#include "joint_world.hpp"

// Springs of every kind of joint, from soft ones to ones too stiff for the substep, give way by their
// formula.

using namespace plumb;
using namespace plumb::physics;

namespace {

constexpr float kHertz[] = {0.7f, 3.0f, 10.0f, 25.0f, 60.0f};

/// m: how far a spring of this frequency sags under the weight of what gives it that frequency.
float sagOf(float hertz) { return JointWorld::kGravity / (kTau * hertz * kTau * hertz); }

struct Case {
    const char* name;
    std::function<void(JointDefinition&, float hertz)> make;
};

const Case kHanging[] = {
    {"distance",
     [](JointDefinition& d, float hertz) {
         d.kind = JointKind::Distance;
         d.anchorA = {0.0f, 2.0f};
         d.length = 2.0f;
         d.spring = {true, hertz, 1.0f};
     }},
    {"prismatic",
     [](JointDefinition& d, float hertz) {
         d.kind = JointKind::Prismatic;
         d.axis = {0.0f, 1.0f};
         d.spring = {true, hertz, 1.0f};
     }},
    {"prismatic with a rest",
     [](JointDefinition& d, float hertz) {
         d.kind = JointKind::Prismatic;
         d.anchorA = {0.0f, 1.5f};
         d.axis = {0.0f, -1.0f};
         d.spring = {true, hertz, 1.0f, 1.5f};
     }},
    {"wheel",
     [](JointDefinition& d, float hertz) {
         d.kind = JointKind::Wheel;
         d.axis = {0.0f, 1.0f};
         d.spring = {true, hertz, 1.0f};
         d.motor = {true, 3.0f, 5.0f};  // of its rotation only
     }},
    {"mouse",
     [](JointDefinition& d, float hertz) {
         d.kind = JointKind::Mouse;
         d.spring = {true, hertz, 1.0f};
     }},
    {"motor",
     [](JointDefinition& d, float hertz) {
         d.kind = JointKind::Motor;
         d.hertz = hertz;
         d.dampingRatio = 1.0f;
     }},
    {"motor with an offset",
     [](JointDefinition& d, float hertz) {
         d.kind = JointKind::Motor;
         d.anchorA = {0.5f, 0.25f};
         d.offset = {-0.5f, -0.25f};
         d.hertz = hertz;
         d.dampingRatio = 1.0f;
     }},
    {"soft weld",
     [](JointDefinition& d, float hertz) {
         d.kind = JointKind::Weld;
         d.hertz = hertz;
         d.dampingRatio = 1.0f;
     }},
    {"soft hinge",
     [](JointDefinition& d, float hertz) {
         d.kind = JointKind::Revolute;
         d.hertz = hertz;
         d.dampingRatio = 1.0f;
     }},
    {"soft rod",
     [](JointDefinition& d, float hertz) {
         d.kind = JointKind::Distance;
         d.anchorA = {0.0f, 2.0f};
         d.length = 2.0f;
         d.hertz = hertz;
         d.dampingRatio = 1.0f;
     }},
};

const Case kTurning[] = {
    {"hinge",
     [](JointDefinition& d, float hertz) {
         d.kind = JointKind::Revolute;
         d.spring = {true, hertz, 1.0f};
     }},
    {"hinge with a rest",
     [](JointDefinition& d, float hertz) {
         d.kind = JointKind::Revolute;
         d.referenceAngle = -0.7f;
         d.spring = {true, hertz, 1.0f, 0.7f};
     }},
    {"weld with a spring",
     [](JointDefinition& d, float hertz) {
         d.kind = JointKind::Weld;
         d.spring = {true, hertz, 1.0f};
     }},
    {"soft weld",
     [](JointDefinition& d, float hertz) {
         d.kind = JointKind::Weld;
         d.hertz = hertz;
         d.dampingRatio = 1.0f;
     }},
    {"motor",
     [](JointDefinition& d, float hertz) {
         d.kind = JointKind::Motor;
         d.hertz = hertz;
         d.dampingRatio = 1.0f;
     }},
};

}  // namespace

TEST(JointSprings, sagByTheLoadOverTheirStiffness) {
    for (const Case& one : kHanging) {
        SCOPED_TRACE(one.name);
        for (const float hertz : kHertz) {
            SCOPED_TRACE(hertz);
            JointWorld scene;
            scene.world.settings.quality = 3;
            const BodyId disc = scene.disc({}, 3.0f);
            JointDefinition definition{.a = scene.ground, .b = disc};
            one.make(definition, hertz);
            scene.join(definition);
            scene.run(2.0f + 4.0f / hertz);
            EXPECT_NEAR(scene.place(disc).y, -sagOf(hertz), 0.01f * sagOf(hertz) + 2.0e-6f);
            EXPECT_NEAR(scene.place(disc).x, 0.0f, 1.0e-4f);
        }
    }
}

TEST(JointSprings, turnByTheTorqueOverTheirStiffness) {
    constexpr float kTorque = 1.0f;  // N m
    for (const Case& one : kTurning) {
        SCOPED_TRACE(one.name);
        for (const float hertz : {3.0f, 10.0f, 25.0f, 60.0f}) {
            SCOPED_TRACE(hertz);
            JointWorld scene;
            scene.world.settings.quality = 3;
            scene.world.settings.gravity = {};
            const BodyId disc = scene.disc({}, 3.0f);
            JointDefinition definition{.a = scene.ground, .b = disc};
            one.make(definition, hertz);
            scene.join(definition);
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

TEST(JointSprings, swingWithTheirFrequencyAndDamping) {
    // x = exp(-z w t) cos(w sqrt(1 - z2) t): the next peak is at exp(-2 pi z / sqrt(1 - z2)).
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

TEST(JointSprings, theMotorOfAWheelTurnsItAndLeavesItInItsPlace) {
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
        scene.run(0.1f);  // 6 N and 0.5 N m on 1 kg and 1/8 kg m2
        const Vec2 early = velocityOf(scene.world, disc);
        EXPECT_NEAR(length(early), 0.6f, 0.01f);
        EXPECT_NEAR(dot(normalized(early), normalized(wanted)), 1.0f, 1.0e-4f);
        EXPECT_NEAR(angularVelocityOf(scene.world, disc), 0.4f, 0.01f);
        scene.run(1.0f);
        EXPECT_NEAR(length(velocityOf(scene.world, disc) - wanted), 0.0f, 0.01f);
        EXPECT_NEAR(angularVelocityOf(scene.world, disc), 1.5f, 0.01f);
    }
}
