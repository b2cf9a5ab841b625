#include <array>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/physics/support/joint_world.hpp"

namespace plumb::physics {
namespace {

/// A joint and the load that it must carry at rest, in N and N m per 1 m/s2 of gravity.
struct Load {
    JointId joint;
    float force = 0.0f;
    float torque = 0.0f;
    BodyId body;  // the hanging body
};

struct Hanging {
    std::string_view name;
    Load (*hang)(JointWorld& scene, float breakForce, float breakTorque);
};

constexpr float kArm = 0.5f;     // distance between hinge and hanging body, m
constexpr float kHold = 1.0e6f;  // practically unlimited force or torque, N or N m

Load join(JointWorld& scene, JointDefinition definition, float breakForce, float breakTorque, Load load) {
    definition.breakForce = breakForce;
    definition.breakTorque = breakTorque;
    load.joint = scene.join(definition);
    load.body = definition.b;
    return load;
}

/// Defines a joint for a disc of 2 kg, 1 m below the origin.
JointDefinition below(JointWorld& scene, JointKind kind) {
    return scene.define(kind, scene.ground, scene.disc({0.0, -1.0}, 2.0f), {0.0, -1.0});
}

/// Defines a rod of 1 m from which the disc hangs.
JointDefinition onARod(JointWorld& scene) {
    JointDefinition definition = below(scene, JointKind::Distance);
    definition.anchorA = {};
    return definition;
}

/// Defines a joint along a vertical axis.
JointDefinition onASlide(JointWorld& scene, JointKind kind) {
    JointDefinition definition = below(scene, kind);
    definition.axis = {0.0f, 1.0f};
    return definition;
}

JointDefinition atItsEnd(JointDefinition definition) {
    definition.limit = {true, 0.0f, 1.0f};
    return definition;
}

/// Defines a joint for a disc of 2 kg beside its hinge.
JointDefinition beside(JointWorld& scene, JointKind kind) {
    const BodyId disc = scene.disc({static_cast<double>(kArm), 0.0}, 2.0f);
    return scene.define(kind, scene.ground, disc, {});
}

Load hangRod(JointWorld& scene, float breakForce, float breakTorque) {
    return join(scene, onARod(scene), breakForce, breakTorque, {.force = 2.0f});
}

Load hangRope(JointWorld& scene, float breakForce, float breakTorque) {
    return join(scene, atItsEnd(onARod(scene)), breakForce, breakTorque, {.force = 2.0f});
}

Load hangSpring(JointWorld& scene, float breakForce, float breakTorque) {
    JointDefinition definition = onARod(scene);
    definition.spring = {true, 3.0f, 1.0f, 1.0f};
    return join(scene, definition, breakForce, breakTorque, {.force = 2.0f});
}

/// A hinge whose limit carries the torque of the disc.
Load hangHinge(JointWorld& scene, float breakForce, float breakTorque) {
    return join(scene, atItsEnd(beside(scene, JointKind::Revolute)), breakForce, breakTorque,
                {.force = 2.0f, .torque = 2.0f * kArm});
}

Load hangDrivenHinge(JointWorld& scene, float breakForce, float breakTorque) {
    JointDefinition definition = beside(scene, JointKind::Revolute);
    definition.motor = {true, 0.0f, kHold};
    return join(scene, definition, breakForce, breakTorque, {.force = 2.0f, .torque = 2.0f * kArm});
}

/// A horizontal slider that carries the load perpendicular to its axis.
Load hangSlider(JointWorld& scene, float breakForce, float breakTorque) {
    return join(scene, below(scene, JointKind::Prismatic), breakForce, breakTorque, {.force = 2.0f});
}

/// A vertical slider that carries the load at its limit.
Load hangSliderAtItsEnd(JointWorld& scene, float breakForce, float breakTorque) {
    return join(scene, atItsEnd(onASlide(scene, JointKind::Prismatic)), breakForce, breakTorque,
                {.force = 2.0f});
}

Load hangDrivenSlider(JointWorld& scene, float breakForce, float breakTorque) {
    JointDefinition definition = onASlide(scene, JointKind::Prismatic);
    definition.motor = {true, 0.0f, kHold};
    return join(scene, definition, breakForce, breakTorque, {.force = 2.0f});
}

Load hangWeld(JointWorld& scene, float breakForce, float breakTorque) {
    return join(scene, beside(scene, JointKind::Weld), breakForce, breakTorque,
                {.force = 2.0f, .torque = 2.0f * kArm});
}

Load hangWheel(JointWorld& scene, float breakForce, float breakTorque) {
    JointDefinition definition = onASlide(scene, JointKind::Wheel);
    definition.spring = {true, 3.0f, 1.0f};
    return join(scene, definition, breakForce, breakTorque, {.force = 2.0f});
}

Load hangWheelAtItsEnd(JointWorld& scene, float breakForce, float breakTorque) {
    return join(scene, atItsEnd(onASlide(scene, JointKind::Wheel)), breakForce, breakTorque, {.force = 2.0f});
}

Load hangOnMouse(JointWorld& scene, float breakForce, float breakTorque) {
    JointDefinition definition = below(scene, JointKind::Mouse);
    definition.target = {0.0, -1.0};
    return join(scene, definition, breakForce, breakTorque, {.force = 2.0f});
}

Load hangOnMotor(JointWorld& scene, float breakForce, float breakTorque) {
    JointDefinition definition = below(scene, JointKind::Motor);
    definition.maxForce = definition.maxTorque = kHold;
    return join(scene, definition, breakForce, breakTorque, {.force = 2.0f});
}

/// A disc beside its hinge, whose rotation is locked by a gear of ratio 2 to a wheel that does not rotate.
Load hangOnGear(JointWorld& scene, float breakForce, float breakTorque) {
    const BodyId wheel = scene.disc({-2.0, 0.0}), disc = scene.disc({static_cast<double>(kArm), 0.0}, 2.0f);
    JointDefinition axle = scene.define(JointKind::Revolute, scene.ground, wheel, {-2.0, 0.0});
    axle.motor = {true, 0.0f, kHold};
    JointDefinition definition;
    definition.kind = JointKind::Gear;
    definition.a = wheel;
    definition.b = disc;
    definition.jointA = scene.join(axle);
    definition.jointB = scene.join(scene.define(JointKind::Revolute, scene.ground, disc, {}));
    definition.ratio = 2.0f;
    return join(scene, definition, breakForce, breakTorque, {.torque = 2.0f * kArm});
}

Load hangOnPulley(JointWorld& scene, float breakForce, float breakTorque) {
    return join(scene, scene.definePulley(2.0f), breakForce, breakTorque, {.force = 2.0f});
}

constexpr Hanging kHangings[] = {
    {"rod", hangRod},
    {"rope", hangRope},
    {"spring", hangSpring},
    {"hinge at its limit", hangHinge},
    {"hinge with a motor", hangDrivenHinge},
    {"slider", hangSlider},
    {"slider at its end", hangSliderAtItsEnd},
    {"slider with a motor", hangDrivenSlider},
    {"weld", hangWeld},
    {"wheel", hangWheel},
    {"wheel at its end", hangWheelAtItsEnd},
    {"mouse", hangOnMouse},
    {"motor", hangOnMotor},
    {"gear", hangOnGear},
    {"pulley", hangOnPulley},
};

/// Increases gravity slowly to its final value, so that nothing swings.
void pullSlowly(JointWorld& scene, float seconds) {
    const int steps = static_cast<int>(seconds / JointWorld::kDt);
    for (int i = 1; i <= steps; ++i) {
        scene.world.settings.gravity.y =
            -JointWorld::kGravity * static_cast<float>(i) / static_cast<float>(steps);
        scene.run(JointWorld::kDt);
    }
}

TEST(EachJoint, hasALoadCase) {
    std::array<bool, static_cast<std::size_t>(JointKind::Count)> hangs{};
    for (const Hanging& hanging : kHangings) {
        JointWorld scene;
        const JointId joint = hanging.hang(scene, kHold, kHold).joint;
        hangs[static_cast<std::size_t>(scene.world.joints.definition[joint.index].kind)] = true;
    }
    hangs[static_cast<std::size_t>(JointKind::Filter)] = true;  // a filter joint carries no load
    for (std::size_t kind = 0; kind < hangs.size(); ++kind) EXPECT_TRUE(hangs[kind]) << kind;
}

TEST(EachJoint, carriesAndReportsItsLoadAtRest) {
    for (const Hanging& hanging : kHangings) {
        SCOPED_TRACE(hanging.name);
        JointWorld scene;
        const Load load = hanging.hang(scene, kHold, kHold);
        pullSlowly(scene, 2.0f);
        scene.run(1.0f);
        const Vec2 before = scene.place(load.body);
        for (int i = 0; i < 600; ++i) {
            scene.run(JointWorld::kDt);
            const float force = JointWorld::kGravity * load.force,
                        torque = JointWorld::kGravity * load.torque;
            ASSERT_NEAR(length(jointForce(scene.world, load.joint)), force, 0.01f * force + 1.0e-3f) << i;
            ASSERT_NEAR(std::fabs(jointTorque(scene.world, load.joint)), torque, 0.01f * torque + 1.0e-3f)
                << i;
        }
        EXPECT_LT(length(scene.place(load.body) - before), 0.001f);
        EXPECT_LT(length(velocityOf(scene.world, load.body)), 0.001f);
    }
}

/// Increases gravity until the joint breaks. @return gravity at that time, m/s2; 0 if the joint did not break
float whereItBroke(const Hanging& hanging, float breakForce, float breakTorque) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const Load load = hanging.hang(scene, breakForce, breakTorque);
    for (int i = 1; i <= 600; ++i) {
        scene.world.settings.gravity.y = -JointWorld::kGravity * static_cast<float>(i) / 600.0f;
        scene.run(JointWorld::kDt);
        if (!alive(scene.world, load.joint)) return -scene.world.settings.gravity.y;
    }
    return 0.0f;
}

TEST(EachJoint, breaksExactlyAtItsBreakForceOrTorque) {
    const float half = 0.5f * JointWorld::kGravity;
    for (const Hanging& hanging : kHangings) {
        SCOPED_TRACE(hanging.name);
        JointWorld scene;
        const Load load = hanging.hang(scene, kHold, kHold);
        if (load.force > 0.0f) {
            EXPECT_NEAR(whereItBroke(hanging, half * load.force, kHold), half, 0.02f * half);
        }
        if (load.torque > 0.0f) {
            EXPECT_NEAR(whereItBroke(hanging, kHold, half * load.torque), half, 0.02f * half);
        }
        EXPECT_EQ(whereItBroke(hanging, kHold, kHold), 0.0f);
    }
}

TEST(EachJoint, withAMotorLiftsLoadsUpToItsForceAtItsSpeed) {
    for (const float strength : {0.9f, 1.5f}) {
        SCOPED_TRACE(strength);
        JointWorld scene;
        JointDefinition definition = below(scene, JointKind::Distance);
        definition.anchorA = {0.0f, 5.0f};
        definition.limit = {true, 0.5f, 8.0f};
        definition.motor = {true, -1.0f, strength * 2.0f * JointWorld::kGravity};  // shortens the joint
        (void)scene.join(definition);
        scene.run(2.0f);
        if (strength > 1.0f) {
            EXPECT_NEAR(velocityOf(scene.world, definition.b).y, 1.0f, 0.01f);
        } else {
            EXPECT_LT(scene.place(definition.b).y, -2.0f);
        }
        scene.run(8.0f);
        EXPECT_NEAR(scene.place(definition.b).y, strength > 1.0f ? 4.5f : -3.0f, 0.01f);
    }
}

}  // namespace
}  // namespace plumb::physics
