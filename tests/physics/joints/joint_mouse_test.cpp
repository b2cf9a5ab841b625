#include <gtest/gtest.h>

#include "tests/physics/support/joint_world.hpp"

namespace plumb::physics {
namespace {

TEST(MouseJoint, pullsToItsTargetWithoutOvershoot) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId box = scene.disc({0.0, 0.0});
    JointDefinition definition = scene.define(JointKind::Mouse, scene.ground, box, {0.0, 0.0});
    definition.target = {3.0, 1.0};
    (void)scene.join(definition);
    float furthest = 0.0f;
    for (int i = 0; i < 120; ++i) {
        scene.run(JointWorld::kDt);
        furthest = std::fmax(furthest, scene.place(box).x);
    }

    EXPECT_NEAR(scene.place(box).x, 3.0f, 0.001f);
    EXPECT_NEAR(scene.place(box).y, 1.0f, 0.001f);
    EXPECT_LT(furthest, 3.01f);
}

TEST(MouseJoint, isLimitedToItsMaximumForce) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId box = scene.disc({0.0, 0.0}, 2.0f);
    JointDefinition definition = scene.define(JointKind::Mouse, scene.ground, box, {0.0, 0.0});
    definition.target = {1000.0, 0.0};
    definition.maxForce = 6.0f;
    const JointId joint = scene.join(definition);

    scene.run(1.0f);

    EXPECT_NEAR(velocityOf(scene.world, box).x, 6.0f / 2.0f, 0.01f);  // F t / m
    EXPECT_NEAR(jointForce(scene.world, joint).x, 6.0f, 0.01f);
}

TEST(MouseJoint, doesNotAffectItsFirstBody) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId other = scene.disc({5.0, 5.0}), box = scene.disc({0.0, 0.0});
    JointDefinition definition = scene.define(JointKind::Mouse, other, box, {0.0, 0.0});
    definition.target = {1.0, 0.0};
    const JointId joint = scene.join(definition);

    scene.run(1.0f);
    (void)*setTarget(scene.world, joint, {-1.0, 0.0});
    scene.run(2.0f);

    EXPECT_EQ(scene.place(other), (Vec2{5.0f, 5.0f}));
    EXPECT_NEAR(scene.place(box).x, -1.0f, 0.001f);
}

// Regression: with unlimited force a crate was pulled through 2 m of floor at 212 m/s.
TEST(MouseJoint, ofAnyForcePullsNoBodyThroughAFloor) {
    for (const Quality quality : {Quality{0}, Quality{2}, Quality{4}}) {
        SCOPED_TRACE(int{quality});
        JointWorld scene;
        scene.world.settings.quality = quality;
        (void)*createShape(scene.world, scene.ground, box({50.0f, 1.0f}, {0.0f, -1.0f}));
        BodyDefinition definition;
        definition.position = {0.0, 0.5};
        const BodyId crate = *createBody(scene.world, definition);
        (void)*createShape(scene.world, crate, box({0.5f, 0.5f}));
        JointDefinition mouse = scene.define(JointKind::Mouse, scene.ground, crate, {0.0, 0.5});
        mouse.target = {0.0, -20.0};
        const JointId joint = scene.join(mouse);

        scene.run(5.0f);
        EXPECT_GT(scene.place(crate).y, 0.0f);
        EXPECT_LT(length(velocityOf(scene.world, crate)), 0.1f);

        (void)*setTarget(scene.world, joint, {0.0, 5.0});
        scene.run(5.0f);
        EXPECT_NEAR(scene.place(crate).y, 5.0f, 0.02f);
    }
}

// Depth grows with kMousePull: 2.8 cm at half, 5.3 at 1,000 m/s2, 11.3 at double (quality 1, this family).
TEST(MouseJoint, ofAnyForcePullsNoBodyIntoFloorOrWall) {
    constexpr float kWall = 10.0f;   // m, distance of the wall
    constexpr float kDepth = 0.06f;  // m
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        JointWorld scene;
        scene.world.settings.quality = static_cast<Quality>(1 + seed % 4);
        (void)*createShape(scene.world, scene.ground, box({50.0f, 1.0f}, {0.0f, -1.0f}));
        (void)*createShape(scene.world, scene.ground, box({1.0f, 20.0f}, {kWall + 1.0f, 0.0f}));
        const float half = random.between(0.1f, 0.8f);
        BodyDefinition definition;
        definition.position = {0.0, static_cast<double>(half)};
        const BodyId crate = *createBody(scene.world, definition);
        ShapeDefinition shape;
        shape.density = std::pow(10.0f, random.between(-1.0f, 2.0f));
        shape.friction = random.unit();
        (void)*createShape(scene.world, crate, box({half, half}), shape);
        const Vec2 grip = half * Vec2{random.between(-0.8f, 0.8f), random.between(-0.8f, 0.8f)};
        JointDefinition mouse =
            scene.define(JointKind::Mouse, scene.ground, crate, definition.position + grip);
        mouse.target = random.unit() < 0.5f
                           ? WorldPosition{random.between(-3.0f, 3.0f), -random.between(1.0f, 40.0f)}
                           : WorldPosition{random.between(11.0f, 40.0f), random.between(1.0f, 5.0f)};
        (void)scene.join(mouse);

        scene.run(3.0f);
        const Vec2 place = scene.place(crate);
        const float turn = scene.angle(crate);
        const float reach = half * (std::fabs(std::cos(turn)) + std::fabs(std::sin(turn)));
        EXPECT_GT(place.y, reach - kDepth);
        EXPECT_LT(place.x, kWall - reach + kDepth);
    }
}

}  // namespace
}  // namespace plumb::physics
