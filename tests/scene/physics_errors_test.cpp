#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/log.hpp"
#include "scene/physics/game_errors.hpp"
#include "tests/scene/physics_scene.hpp"

// Errors of the physics reach the author of a game in px, with the entity, the field and the remedy.

namespace plumb {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

class PhysicsErrors : public testing::Test {
protected:
    PhysicsErrors() : before_{setLogSink([this](const LogLine& line) { lines.push_back(line.text); })} {}
    ~PhysicsErrors() override { setLogSink(before_); }

    Entity named(Entity entity, const char* name) {
        entity.addComponent<Name>(scene.world.texts().add(name));
        return entity;
    }
    /// The only line that was logged, of which this is the beginning.
    void expectLine(const std::string& begin, const char* remedy) {
        scene.run(2);
        ASSERT_EQ(lines.size(), 1u) << testing::PrintToString(lines);
        EXPECT_EQ(lines[0].substr(0, begin.size()), begin);
        EXPECT_NE(lines[0].find(remedy), std::string::npos) << lines[0];
        EXPECT_EQ(lines[0].find("metre"), std::string::npos) << lines[0];
        EXPECT_EQ(lines[0].find(" m "), std::string::npos) << lines[0];
    }

    PhysicsScene scene;
    std::vector<std::string> lines;

private:
    LogSink before_;
};

TEST_F(PhysicsErrors, sizesOfCollidersAreInPixels) {
    const Entity crate = named(scene.crate({0, 0}), "Crate");
    crate.get<BoxCollider>().width = -5.0f;
    expectLine("Crate (entity 1): BoxCollider.width (px): expected ", "px, found -5; use a size");
}

TEST_F(PhysicsErrors, theRadiusOfACircleIsInPixels) {
    scene.ball({0, 0}, -3.0f);
    expectLine("entity 1: CircleCollider.radius (px): expected ", "found -3;");
}

TEST_F(PhysicsErrors, surfacesNameTheirCollider) {
    scene.ball({0, 0}).get<CircleCollider>().friction = kNan;
    expectLine("entity 1: CircleCollider.friction: expected a number from 0 to 100, found nan", "check");
}

TEST_F(PhysicsErrors, outlinesAreInPixels) {
    const Entity entity = scene.at({0, 0});
    entity.addComponent<RigidBody>();
    PolygonCollider& polygon = entity.addComponent<PolygonCollider>();
    for (const Vec2 point : {Vec2{0, 0}, Vec2{1e9f, 0}, Vec2{0, 10}}) polygon.points.push(point);
    expectLine("entity 1: PolygonCollider.points: the point ", "further than 6.4e+07 px");
}

TEST_F(PhysicsErrors, velocitiesThatAreNoNumbers) {
    const Entity ball = named(scene.ball({0, 0}), "Ball");
    scene.run(1);
    ball.get<RigidBody>().velocity.x = kNan;
    expectLine("Ball (entity 1): velocity (px/s): expected a number from -6.4e+07 to 6.4e+07, found nan",
               "check the computation");
}

TEST_F(PhysicsErrors, positionsBeyondTheRangeOfTheWorld) {
    const Entity ball = scene.ball({0, 0});
    scene.run(1);
    ball.get<Transform>().position.x = 1e11f;
    expectLine("entity 1: Transform.position (px): expected a number from -6.4e+10 to 6.4e+10, found 1e+11",
               "move it back");
}

TEST_F(PhysicsErrors, jointsWhoseBodiesAreMissing) {
    const Entity post = named(scene.at({0, 0}), "Post");
    named(scene.ball({0, 0}), "Ball").addComponent<RevoluteJoint>().other = post.id();
    expectLine("Ball (entity 2): RevoluteJoint.other: Post (entity 1) has no body to join;", "RigidBody");
    post.addComponent<StaticBody>();
    post.addComponent<CircleCollider>(4.0f);
    scene.run(1);
    EXPECT_EQ(lines.size(), 1u);
}

TEST_F(PhysicsErrors, aJointWhoseOtherEntityWasDestroyedIsNoMistake) {
    const Entity post = scene.ball({0, 0});
    scene.ball({50, 0}).addComponent<RevoluteJoint>().other = post.id();
    scene.run(2);
    post.destroy();
    scene.run(2);
    EXPECT_TRUE(lines.empty()) << lines[0];
}

TEST_F(PhysicsErrors, bodiesWithoutATransform) {
    const Entity crate = named(scene.world.createEntity(), "Crate");
    crate.addComponent<RigidBody>();
    expectLine("Crate (entity 1): RigidBody: the entity has no Transform, so it has no body;", "add a Tr");
}

TEST_F(PhysicsErrors, bodiesOfTwoKinds) {
    scene.ball({0, 0}).addComponent<StaticBody>();
    expectLine("entity 1: StaticBody: it has no effect, as the entity has a RigidBody, too;", "remove");
    const Entity platform = scene.at({50, 0});
    platform.addComponent<KinematicBody>();
    scene.run(1);
    EXPECT_EQ(lines.size(), 1u) << "one kind is no mistake";
    platform.addComponent<StaticBody>();
    scene.run(2);
    ASSERT_EQ(lines.size(), 2u) << "also if it is added later";
    EXPECT_NE(lines[1].find("as the entity has a KinematicBody"), std::string::npos) << lines[1];
}

TEST_F(PhysicsErrors, bodiesThatAreMadeWithoutMass) {
    const Entity ball = scene.ball({0, 0});
    ball.get<RigidBody>().mass = 0.0f;
    expectLine("entity 1: RigidBody.mass: expected a mass above 0, found 0;", "StaticBody");
    EXPECT_EQ(ball.get<RigidBody>().mass, 1.0f);
}

TEST_F(PhysicsErrors, aFaultOfOneKindDoesNotHideAnother) {
    const Entity crate = named(scene.world.createEntity(), "Crate");
    crate.addComponent<RigidBody>().mass = -2.0f;
    scene.run(2);
    crate.addComponent<Transform>(0.0f, 0.0f);
    crate.addComponent<BoxCollider>(16.0f, 16.0f);
    scene.run(2);
    ASSERT_EQ(lines.size(), 2u) << testing::PrintToString(lines);
    EXPECT_NE(lines[0].find("has no Transform"), std::string::npos) << lines[0];
    EXPECT_NE(lines[1].find("RigidBody.mass: expected a mass above 0, found -2"), std::string::npos)
        << lines[1];
}

TEST_F(PhysicsErrors, faultyEntitiesThatComeAndGoAreReportedOnce) {
    for (int tick = 0; tick < 100; ++tick) {
        const Entity bullet = scene.ball({0, 0});
        bullet.addComponent<StaticBody>();
        bullet.get<RigidBody>().mass = 0.0f;
        scene.run(1);
        bullet.destroy();
    }
    EXPECT_EQ(lines.size(), 2u) << testing::PrintToString(lines);
    EXPECT_EQ(scene.world.reports().count(), 2u);
}

TEST_F(PhysicsErrors, aTransformThatIsLostOrAKindThatIsAddedIsReported) {
    const Entity ball = scene.ball({0, 0});
    scene.floor({100, 0}, {10, 10}).addComponent<StaticBody>();
    scene.run(10);
    EXPECT_TRUE(lines.empty());
    ball.removeComponent<Transform>();
    scene.world.first<StaticBody>().addComponent<RigidBody>();
    scene.run(2);
    ASSERT_EQ(lines.size(), 2u) << testing::PrintToString(lines);
    const std::string both = lines[0] + lines[1];
    EXPECT_NE(both.find("RigidBody: the entity has no Transform"), std::string::npos) << both;
    EXPECT_NE(both.find("StaticBody: it has no effect"), std::string::npos) << both;
}

TEST_F(PhysicsErrors, limitsOfJointsAreAnglesOrLengths) {
    const Error error{"JointDefinition.limit.upper", "expected a number from 1 to 1000000, found 0.5", "r"};
    const PixelScale scale{64.0f, 1.0f / 64.0f};
    EXPECT_EQ(gameError(error, "RevoluteJoint", scale).text(),
              "RevoluteJoint.upper (rad): expected a number from 1 to 1000000, found 0.5; r");
    EXPECT_EQ(gameError(error, "PrismaticJoint", scale).text(),
              "PrismaticJoint.upper (px): expected a number from 64 to 6.4e+07, found 32; r");
}

TEST_F(PhysicsErrors, numbersOfPointsAreNoLengths) {
    const Error error{"decompose", "found 70 points, expected at most 64", "remove some"};
    EXPECT_EQ(gameError(error, "PolygonCollider", {}).text(),
              "PolygonCollider.points: found 70 points, expected at most 64; remove some");
}

TEST_F(PhysicsErrors, whatIsConvertedStays) {
    const PixelScale scale{64.0f, 1.0f / 64.0f};
    const Error error{"box.b.x", "expected 0.5 to 2 m, found 1e-05", "use metres"};
    const Error once = gameError(error, "BoxCollider", scale);
    EXPECT_EQ(once.where, "BoxCollider.width (px)");
    EXPECT_EQ(once.what, "expected 64 to 256 px, found 0.00128");
    EXPECT_EQ(gameError(once, {}, scale).text(), once.text());
}

}  // namespace
}  // namespace plumb
