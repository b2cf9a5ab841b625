#include "physics/model/fields.hpp"
#include "tests/physics_reference/solved.hpp"

namespace plumb::reference {
namespace {

using physics::JointKind;

/// Returns the error text for a world that the reference solver rejects.
std::string refusal(const physics::World& world, double seconds = 1.0, const Options& options = {}) {
    const auto answer = solveReference(world, seconds, options);
    EXPECT_FALSE(answer.ok());
    return answer.ok() ? "" : answer.error().text();
}

void expectSays(const std::string& text, std::string_view part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(ReferenceRefusals, featuresThatAreNotModelledAreNamed) {
    {
        Playground scene;
        ASSERT_TRUE(physics::createField(scene.world, {.acceleration = {1.0f, 0.0f}}).ok());
        expectSays(refusal(scene.world), "field 0");
    }
    {
        Playground scene;
        scene.ball({}, 0.5f, {.rollingResistance = 0.1f});
        expectSays(refusal(scene.world), "rolling resistance");
    }
    {
        Playground scene;
        scene.floor({.oneWay = true});
        expectSays(refusal(scene.world), "one-way");
    }
    {
        Playground scene;
        const BodyId wall = scene.body(BodyKind::Static, {}), ball = scene.ball({});
        ASSERT_TRUE(physics::createJoint(scene.world, {.a = wall, .b = ball, .breakForce = 10.0f}).ok());
        expectSays(refusal(scene.world), "breakable joints");
    }
    {
        Playground scene;
        const BodyId ball = scene.ball({});
        ASSERT_TRUE(physics::applyForce(scene.world, ball, {1.0f, 0.0f}).ok());
        expectSays(refusal(scene.world), "pending force");
    }
    {
        Playground scene;
        const BodyId wall = scene.body(BodyKind::Static, {}), ball = scene.ball({});
        ASSERT_TRUE(physics::createJoint(scene.world,
                                         {.kind = JointKind::Motor, .a = wall, .b = ball, .maxForce = 1.0f})
                        .ok());
        expectSays(refusal(scene.world), "joint 0 reaches its maximum force");
    }
    expectSays(refusal({}, -1.0), "time and step must be positive");
}

TEST(ReferenceRefusals, overlapsWithoutFreeSpaceAreRejected) {
    Playground scene;
    for (const double x : {-0.75, 0.75})
        scene.shape(scene.body(BodyKind::Static, {x, 0.0}), physics::box({0.5f, 10.0f}));
    scene.crate({});
    expectSays(refusal(scene.world), "cannot be separated");
}

TEST(ReferenceRefusals, aChaoticSceneIsReported) {
    Playground scene;
    const BodyId pin = scene.body(BodyKind::Static, {});
    const BodyId upper = scene.ball({0.25, 1.0}, 0.125f, {.group = -1});
    const BodyId lower = scene.ball({0.0, 2.0}, 0.125f, {.group = -1});
    ASSERT_TRUE(physics::createJoint(scene.world, {.a = pin, .b = upper, .anchorB = {-0.25f, -1.0f}}).ok());
    ASSERT_TRUE(physics::createJoint(scene.world, {.a = upper, .b = lower, .anchorB = {0.25f, -1.0f}}).ok());
    expectSays(refusal(scene.world, 30.0, {.mostRuns = 3}), "do not converge");
    const Answer soon = solved(scene.world, 0.5);
    EXPECT_LT(soon.error, 1.0e-4);
}

TEST(ReferenceRefusals, tooLongComputationsAreAborted) {
    Playground scene;
    scene.ball({0.0, 10.0});
    expectSays(refusal(scene.world, 10.0, {.patience = 0.0}), "time limit was reached after 0 of 2400 steps");
}

TEST(ReferenceRefusals, aWorldIsComparedWithAnAnswer) {
    Playground scene;
    const BodyId ball = scene.ball({0.0, 10.0});
    const Answer answer = solved(scene.world, 1.0);
    scene.run(60);
    EXPECT_LT(compare(scene.world, answer).position, 1.0e-5);
    ASSERT_TRUE(physics::setPosition(scene.world, ball, {3.0, 1.0}, 0.5f).ok());
    const Difference difference = compare(scene.world, answer);
    EXPECT_NEAR(difference.position, 5.0, 1.0e-5);
    EXPECT_NEAR(difference.angle, 0.5, 1.0e-6);
    EXPECT_EQ(difference.body, ball);
    EXPECT_TRUE(answer.canJudge(1.0e-6));
    EXPECT_FALSE(answer.canJudge(answer.error));
}

}  // namespace
}  // namespace plumb::reference
