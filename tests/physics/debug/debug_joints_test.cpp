#include <algorithm>

#include <gtest/gtest.h>

#include "physics/model/joints.hpp"
#include "physics/model/shapes.hpp"
#include "tests/physics/support/recording_canvas.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

using namespace plumb;
using namespace plumb::physics;

namespace {

/// A box of 1 kg and 1 m that hangs from a joint at its center.
struct Hung {
    World world;
    BodyId ground;
    BodyId body;

    explicit Hung(JointDefinition joint, float density = 1.0f) {
        world.settings.gravity = {0.0f, 10.0f};
        world.settings.sleeping = false;
        ground = addBody(world, BodyKind::Static, {});
        body = addBody(world, BodyKind::Dynamic, {2.0, 0.0});
        static_cast<void>(createShape(world, body, box({0.5f, 0.5f}), {.density = density}));
        joint.a = ground;
        joint.b = body;
        EXPECT_TRUE(createJoint(world, joint));
    }
};

}  // namespace

TEST(DebugDraw, theArrowOfAJointIsItsLoad) {
    // Twice the density doubles mass and force, but not the acceleration: 10 m/s2 upwards is drawn as 0.2 m.
    for (const float density : {1.0f, 2.0f}) {
        Hung hung{{.kind = JointKind::Weld, .anchorA = {2.0f, 0.0f}}, density};
        for (int i = 0; i < 120; ++i) step(hung.world, 1.0f / 60.0f);
        const auto arrows = strokesOf(drawn(hung.world, kDrawJointForces), DebugRole::JointForce);
        ASSERT_EQ(arrows.size(), 1u);
        EXPECT_NEAR(arrows[0].points[0].x, 2.0f, 1e-2f);
        const Vec2 way = arrows[0].points[1] - arrows[0].points[0];
        EXPECT_NEAR(way.x, 0.0f, 1e-3f);
        EXPECT_NEAR(way.y, -0.2f, 2e-3f);
    }
}

TEST(DebugDraw, aSliderShowsItsRangeFromLimitToLimit) {
    Hung hung{{.kind = JointKind::Prismatic,
               .anchorA = {2.0f, 0.0f},
               .axis = {0.0f, 1.0f},
               .limit = {true, -0.5f, 1.5f}}};
    const auto lines = strokesOf(drawn(hung.world, kDrawJoints), DebugRole::JointLimit);
    ASSERT_EQ(lines.size(), 3u);  // a line along the range, and a short stroke across each end
    EXPECT_EQ(lines[0].points, (std::vector<Vec2>{{2.0f, -0.5f}, {2.0f, 1.5f}}));
    EXPECT_EQ((lines[1].points[0] + lines[1].points[1]) * 0.5f, (Vec2{2.0f, -0.5f}));
    EXPECT_EQ((lines[2].points[0] + lines[2].points[1]) * 0.5f, (Vec2{2.0f, 1.5f}));
}

TEST(DebugDraw, aHingeShowsItsAllowedAngles) {
    // The arm points along x from (1, 0); limits of a quarter turn point straight up and down.
    const float quarter = 1.5707964f;
    Hung hung{{.anchorA = {1.0f, 0.0f}, .anchorB = {-1.0f, 0.0f}, .limit = {true, -quarter, quarter}}};
    const auto lines = strokesOf(drawn(hung.world, kDrawJoints), DebugRole::JointLimit);
    ASSERT_GE(lines.size(), 10u);
    float up = 0.0f, down = 0.0f;
    for (const Stroke& line : lines) {
        for (const Vec2 point : line.points) {
            EXPECT_GE(point.x, 1.0f - 1e-4f);
            up = std::min(up, point.y);
            down = std::max(down, point.y);
        }
    }
    EXPECT_NEAR(up, -down, 1e-4f);
    EXPECT_GT(down, 0.1f);
}

TEST(DebugDraw, everyKindOfJointIsDrawnWithFiniteNumbers) {
    for (std::uint8_t kind = 0; kind < static_cast<std::uint8_t>(JointKind::Count); ++kind) {
        SCOPED_TRACE(int{kind});
        World world;
        const BodyId ground = addBody(world, BodyKind::Static, {});
        const BodyId a = addBody(world, BodyKind::Dynamic, {1.0, 0.0}),
                     b = addBody(world, BodyKind::Dynamic, {2.0, 0.0});
        for (const BodyId body : {a, b}) static_cast<void>(createShape(world, body, circle(0.3f)));
        JointDefinition joint{.kind = static_cast<JointKind>(kind), .a = a, .b = b};
        joint.limit = {true, 0.0f, 1.0f};
        joint.length = 2.0f;
        if (joint.kind == JointKind::Gear) {
            joint.jointA = *createJoint(world, {.a = ground, .b = a});
            joint.jointB = *createJoint(world, {.a = ground, .b = b});
        }
        ASSERT_TRUE(createJoint(world, joint));
        for (int i = 0; i < 10; ++i) step(world, 1.0f / 60.0f);
        const Recording picture = drawn(world, kDrawJoints | kDrawJointForces);
        EXPECT_GE(picture.count(DebugRole::Joint, 'l'), 1u);
        EXPECT_EQ(picture.count(DebugRole::Joint, 'c'), world.joints.size());
    }
}
