#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "tests/physics/support/joint_world.hpp"

namespace plumb::physics {
namespace {

// Linkages that are closed through the ground and driven by a motor. Kinematics determines their motion
// exactly: the angle of the crank is speed times time, and every joint stays closed.

constexpr float kTorque = 500.0f;  ///< N m, far more than any linkage needs

struct Linkage : JointWorld {
    std::vector<JointId> joints;
    BodyId crank;

    explicit Linkage(bool direct) { world.settings.directJoints = direct; }

    /// Creates a rod of 1 kg/m between two points; it collides with nothing.
    BodyId rod(WorldPosition from, WorldPosition to) {
        const Vec2 span = to - from;
        const BodyId body =
            *createBody(world, {.position = from + 0.5f * span, .angle = arcTangent(span.y, span.x)});
        ShapeDefinition shape;
        shape.mask = 0;
        shape.density = 10.0f;
        (void)*createShape(world, body, box({0.5f * length(span), 0.05f}), shape);
        return body;
    }

    void hinge(BodyId a, BodyId b, WorldPosition at, float speed = 0.0f) {
        JointDefinition definition;
        definition.a = a;
        definition.b = b;
        definition.anchorA = unrotate(rotationOf(world, a), at - positionOf(world, a));
        definition.anchorB = unrotate(rotationOf(world, b), at - positionOf(world, b));
        definition.motor = {speed != 0.0f, speed, kTorque};
        joints.push_back(join(definition));
    }

    /// Adds a slider that moves along x at the height of the ground's origin.
    void slider(BodyId body, WorldPosition at) {
        JointDefinition definition = define(JointKind::Prismatic, ground, body, at);
        joints.push_back(join(definition));
    }

    /// Builds a four-bar linkage with ground hinges at both ends. The first rod is driven, the last one too
    /// if `rockerSpeed` is not 0.
    void fourBar(WorldPosition base, std::array<WorldPosition, 2> knees, WorldPosition end, float speed,
                 float rockerSpeed = 0.0f) {
        crank = rod(base, knees[0]);
        const BodyId coupler = rod(knees[0], knees[1]), rocker = rod(knees[1], end);
        hinge(ground, crank, base, speed);
        hinge(crank, coupler, knees[0]);
        hinge(coupler, rocker, knees[1]);
        hinge(ground, rocker, end, rockerSpeed);
    }

    /// Runs for `seconds` and adds the rotation of the crank to `turned`, rad. @return maximum gap of a
    /// joint, m
    float turn(float seconds, double& turned) {
        float widest = 0.0f;
        for (int i = 0; i < static_cast<int>(seconds / kDt); ++i) {
            const Rot before = rotationOf(world, crank);
            step(world, kDt, options);
            turned += static_cast<double>(angleOf(between(before, rotationOf(world, crank))));
            for (const JointId joint : joints) {
                const bool slides = world.joints.definition[joint.index].kind == JointKind::Prismatic;
                const Vec2 gap = gapOf(joint);
                widest = std::max(widest, slides ? std::fabs(gap.y) : length(gap));
            }
        }
        return widest;
    }

    void expectTurning(float speed) {
        constexpr float kSeconds = 30.0f;
        double turned = 0.0;
        const float widest = turn(kSeconds, turned);
        EXPECT_NEAR(turned / static_cast<double>(speed * kSeconds), 1.0, 0.01);
        EXPECT_LT(widest, 0.03f) << "m: a joint opened";
    }
};

class Linkages : public testing::TestWithParam<bool> {};

TEST_P(Linkages, aFourBarFollowsItsMotor) {
    Linkage scene{GetParam()};
    // Crank 1 m, coupler 3.16 m, rocker 2 m, ground 3 m: by Grashof's law the crank can rotate fully.
    scene.fourBar({0.0, 0.0}, {WorldPosition{0.0, 1.0}, WorldPosition{3.0, 2.0}}, {3.0, 0.0}, 2.0f);
    scene.expectTurning(2.0f);
}

TEST_P(Linkages, aSliderCrankFollowsItsMotor) {
    Linkage scene{GetParam()};
    scene.crank = scene.rod({0.0, 0.0}, {0.0, 1.0});
    const BodyId link = scene.rod({0.0, 1.0}, {std::sqrt(8.0), 0.0});  // 3 m long
    const BodyId piston = scene.disc({std::sqrt(8.0), 0.0});
    scene.hinge(scene.ground, scene.crank, {0.0, 0.0}, 4.0f);
    scene.hinge(scene.crank, link, {0.0, 1.0});
    scene.hinge(link, piston, {std::sqrt(8.0), 0.0});
    scene.slider(piston, {std::sqrt(8.0), 0.0});
    scene.expectTurning(4.0f);
}

TEST_P(Linkages, aParallelogramFollowsItsMotors) {
    // When all rods are in line, a parallelogram may change to its crossed form. Driving it at both ends
    // prevents this, but its equations are singular in that position and the joints are redundant.
    Linkage scene{GetParam()};
    scene.fourBar({0.0, 0.0}, {WorldPosition{0.0, 1.0}, WorldPosition{3.0, 1.0}}, {3.0, 0.0}, 1.0f, 1.0f);
    scene.expectTurning(1.0f);
}

TEST_P(Linkages, aRopeHungAtBothEndsHoldsItsMotor) {
    // The driven rod cannot rotate fully: its neighbors hold it, and everything comes to rest.
    Linkage scene{GetParam()};
    WorldPosition at{0.0, 0.0};
    BodyId before = scene.ground;
    for (int i = 0; i < 10; ++i) {
        const WorldPosition next{at.x + 0.45, 0.0};
        const BodyId rod = scene.rod(at, next);
        scene.hinge(before, rod, at, i == 5 ? 2.0f : 0.0f);
        before = rod;
        at = next;
    }
    scene.hinge(before, scene.ground, at);
    double turned = 0.0;
    scene.crank = before;
    scene.turn(10.0f, turned);
    float fastest = 0.0f;
    for (std::size_t i = 0; i < scene.world.bodies.size(); ++i)
        fastest = std::max(fastest, length(scene.world.bodies.motion[i].velocity));
    EXPECT_LT(fastest, 5.0f) << "m/s: faster than the motor drives it";
    EXPECT_LT(scene.turn(1.0f, turned), 0.2f) << "m: a joint opened";
}

INSTANTIATE_TEST_SUITE_P(BothWays, Linkages, testing::Bool(),
                         [](const auto& param) { return param.param ? "Direct" : "ByTurns"; });

}  // namespace
}  // namespace plumb::physics
