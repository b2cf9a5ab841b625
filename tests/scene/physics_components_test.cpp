#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/log.hpp"
#include "physics/model/bodies.hpp"
#include "scene/physics/contact_events.hpp"
#include "tests/scene/physics_scene.hpp"

namespace plumb {
namespace {

using Scene = PhysicsScene;

TEST(PhysicsComponents, aBoxOnItsEdgeTipsOntoItsSide) {
    Scene scene;
    scene.floor({-500, 100}, {1000, 20});
    Entity box = scene.at({0, 0});
    box.addComponent<RigidBody>();
    box.addComponent<BoxCollider>(40, 20).offset = {-20, -10};
    box.get<Transform>().rotation = 0.5f;
    scene.run(300);
    EXPECT_NEAR(std::abs(std::remainder(box.get<Transform>().rotation, kPi)), 0.0f, 0.01f);
    EXPECT_NEAR(Scene::place(box).y, 90.0f, 0.4f);
}

TEST(PhysicsComponents, fixedRotationKeepsTheAngleToTheBit) {
    Scene scene;
    scene.floor({-500, 100}, {1000, 20});
    Entity box = scene.at({0, 0});
    box.addComponent<RigidBody>().fixedRotation = true;
    box.addComponent<BoxCollider>(40, 20).offset = {-20, -10};
    box.get<Transform>().rotation = 0.5f;
    scene.run(300);
    EXPECT_EQ(box.get<Transform>().rotation, 0.5f);
}

TEST(PhysicsComponents, eachColliderRestsOnTheFloorAtItsSize) {
    Scene scene;
    scene.floor({-500, 100}, {2000, 20});
    std::vector<std::pair<Entity, float>> expected;  // height of the origin above the floor, px
    const auto body = [&](float x, float height) {
        Entity entity = scene.at({x, 40});
        entity.addComponent<RigidBody>().fixedRotation = true;
        expected.emplace_back(entity, height);
        return entity;
    };
    body(0, 20).addComponent<BoxCollider>(16, 20);
    body(100, 12).addComponent<CircleCollider>(12.0f);
    body(200, 30).addComponent<CapsuleCollider>(12.0f, 30.0f);
    body(300, 12).addComponent<CapsuleCollider>(30.0f, 12.0f);
    auto& arrow = body(400, 20).addComponent<PolygonCollider>();  // a concave polygon
    for (const Vec2 point : {Vec2{0, 0}, {20, 20}, {0, 10}, {-20, 20}}) arrow.points.push(point);
    auto& rounded = body(500, 24).addComponent<PolygonCollider>();
    for (const Vec2 point : {Vec2{-10, 0}, {10, 0}, {10, 20}, {-10, 20}}) rounded.points.push(point);
    rounded.rounding = 4;
    body(600, 20).addComponent<BoxCollider>(20, 20).rounding = 5;
    scene.run(240);
    for (const auto& [entity, height] : expected) {
        EXPECT_NEAR(Scene::place(entity).y, 100.0f - height, 0.4f) << Scene::place(entity).x;
        EXPECT_TRUE(entity.get<RigidBody>().grounded) << Scene::place(entity).x;
    }
}

TEST(PhysicsComponents, aChainDrawnFromLeftToRightIsAFloor) {
    Scene scene;
    Entity ground = scene.at({0, 100});
    auto& chain = ground.addComponent<ChainCollider>();
    for (const Vec2 point : {Vec2{-200, 0}, {0, 0}, {200, 0}}) chain.points.push(point);
    const Entity above = scene.ball({-50, 20});
    const Entity below = scene.ball({50, 160});
    below.get<RigidBody>().velocity = {0, -600};
    scene.run(120);
    EXPECT_NEAR(Scene::place(above).y, 92.0f, 0.4f);
    EXPECT_NEAR(Scene::place(below).y, 92.0f, 0.4f) << "passed the chain from below, then fell on it";
}

TEST(PhysicsComponents, collidersOfOneEntityAreOneBody) {
    Scene scene;
    scene.floor({-500, 100}, {1000, 20});
    Entity hammer = scene.at({0, 20});
    hammer.addComponent<RigidBody>(3.0f).fixedRotation = true;
    hammer.addComponent<BoxCollider>(4, 40).offset = {-2, 0};
    hammer.addComponent<CircleCollider>(10.0f).offset = {0, 40};
    scene.run(200);
    EXPECT_NEAR(Scene::place(hammer).y, 50.0f, 0.4f) << "the hammer rests on its circle";
    EXPECT_EQ(physics::bodyCount(scene.state().world), 2u);
    EXPECT_NEAR(physics::massOf(scene.state().world, bodyOf(scene.world, hammer.id())), 3.0f, 1e-5f);
}

TEST(PhysicsComponents, anInvalidMassIsRejectedAndReset) {
    std::vector<LogLine> lines;
    const LogSink before = setLogSink([&](const LogLine& line) { lines.push_back(line); });
    Scene scene;
    const Entity ball = scene.ball({0, 0});
    ball.get<RigidBody>().mass = 5.0f;
    scene.run(1);
    for (const float mass : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()}) {
        ball.get<RigidBody>().mass = mass;
        scene.run(1);
        EXPECT_EQ(ball.get<RigidBody>().mass, 5.0f);
    }
    const Entity born = scene.ball({100, 0});
    born.get<RigidBody>().mass = -3.0f;
    scene.run(1);
    setLogSink(before);
    EXPECT_EQ(born.get<RigidBody>().mass, 1.0f);
    EXPECT_EQ(lines.size(), 2u);
}

TEST(PhysicsComponents, aTriggerReportsBodiesMovedThroughIt) {
    Scene scene;
    Entity zone = scene.floor({100, -50}, {40, 100});
    zone.get<BoxCollider>().isTrigger = true;
    Entity platform = scene.floor({0, -5}, {10, 10});
    platform.addComponent<KinematicBody>().velocity = {120, 0};
    Entity other = scene.floor({0, -5}, {10, 10});
    other.get<BoxCollider>().isTrigger = true;
    other.addComponent<KinematicBody>().velocity = {120, 0};
    int entered = 0, left = 0;
    for (int i = 0; i < 120; ++i) {
        scene.run(1);
        for (const TriggerEntered& event : scene.world.events<TriggerEntered>())
            entered += event.trigger == zone.id() ? 1 : 0;
        for (const TriggerLeft& event : scene.world.events<TriggerLeft>())
            left += event.trigger == zone.id() ? 1 : 0;
    }
    EXPECT_EQ(entered, 2);
    EXPECT_EQ(left, 2);
}

TEST(PhysicsComponents, aCharacterWalksUpStepsPushesAndIsStoppedByWalls) {
    Scene scene;
    scene.floor({-500, 100}, {1000, 20});
    scene.floor({60, 94}, {200, 10});  // a step that can be climbed
    scene.floor({240, 0}, {20, 100});  // a wall
    Entity crate = scene.floor({120, 74}, {20, 20});
    crate.addComponent<RigidBody>();
    Entity hero = scene.at({0, 60});
    hero.addComponent<CapsuleCollider>(12.0f, 24.0f);
    auto& character = hero.addComponent<CharacterController>();
    character.stepHeight = 8;
    scene.run(60);
    EXPECT_TRUE(hero.get<CharacterController>().grounded);
    EXPECT_NEAR(Scene::place(hero).y, 76.0f, 0.2f);
    for (int i = 0; i < 300; ++i) {
        hero.get<CharacterController>().velocity.x = 90;
        scene.run(1);
    }
    EXPECT_NEAR(Scene::place(crate).x, 220.0f, 1.0f) << "the crate must be pushed to the wall";
    EXPECT_NEAR(Scene::place(hero).x, 208.0f, 1.0f);
    EXPECT_NEAR(Scene::place(hero).y, 70.0f, 0.3f);
    hero.get<CharacterController>().velocity = {0, -300};
    scene.run(10);
    EXPECT_FALSE(hero.get<CharacterController>().grounded);
    EXPECT_LT(Scene::place(hero).y, 50.0f);
}

TEST(PhysicsComponents, aPendulumSwingsAroundItsHinge) {
    Scene scene;
    const Entity bob = scene.ball({100, 0});
    auto& hinge = bob.addComponent<RevoluteJoint>();
    hinge.anchor = {-100, 0};  // so that the hinge is at the origin
    float lowest = 0.0f;
    for (int i = 0; i < 120; ++i) {
        scene.run(1);
        lowest = std::max(lowest, Scene::place(bob).y);
        EXPECT_NEAR(length(Scene::place(bob)), 100.0f, 0.5f) << i;
    }
    EXPECT_GT(lowest, 95.0f);
}

TEST(PhysicsComponents, aRopeConnectsTwoEntitiesAndBreaks) {
    Scene scene;
    Entity hook = scene.at({0, 0});
    hook.addComponent<StaticBody>();
    hook.addComponent<CircleCollider>(2.0f);
    const Entity load = scene.ball({0, 50});
    auto& rope = load.addComponent<DistanceJoint>();
    rope.other = hook;
    rope.length = 100;
    rope.rope = true;
    scene.run(180);
    EXPECT_NEAR(Scene::place(load).y, 100.0f, 1.0f);
    load.get<DistanceJoint>().breakForce = 500.0f;  // less than the weight of 980
    int broke = 0;
    for (int i = 0; i < 30; ++i) {
        scene.run(1);
        broke += static_cast<int>(scene.world.events<JointBroke>().size());
    }
    EXPECT_EQ(broke, 1);
    EXPECT_FALSE(load.hasComponent<DistanceJoint>());
    EXPECT_GT(Scene::place(load).y, 150.0f);
}

TEST(PhysicsComponents, aMotorRotatesAWheelAndItsSpeedCanChange) {
    Scene scene;
    const Entity wheel = scene.ball({0, 0}, 20);
    auto& hinge = wheel.addComponent<RevoluteJoint>();
    hinge.motor = true;
    hinge.motorSpeed = 3.0f;
    scene.run(60);
    EXPECT_NEAR(wheel.get<RigidBody>().angularVelocity, 3.0f, 0.01f);
    wheel.get<RevoluteJoint>().motorSpeed = -2.0f;
    scene.run(60);
    EXPECT_NEAR(wheel.get<RigidBody>().angularVelocity, -2.0f, 0.01f);
    EXPECT_NEAR(length(Scene::place(wheel)), 0.0f, 0.1f);
}

TEST(PhysicsComponents, fieldsActInTheirRegion) {
    Scene scene;
    Entity lift = scene.floor({-50, -500}, {100, 1000});
    lift.get<BoxCollider>().isTrigger = true;
    auto& field = lift.addComponent<GravityField>();
    field.acceleration = {0, -980};
    field.replacesGravity = true;
    const Entity inside = scene.ball({0, 0});
    const Entity outside = scene.ball({200, 0});
    scene.run(30);
    EXPECT_NEAR(inside.get<RigidBody>().velocity.y, -490.0f, 5.0f);
    EXPECT_NEAR(outside.get<RigidBody>().velocity.y, 490.0f, 5.0f);
}

TEST(PhysicsComponents, anExplosionPushesOnceAndIsRemoved) {
    Scene scene;
    scene.world.resource<PhysicsSettings>().gravity = {};
    const Entity left = scene.ball({-40, 0});
    const Entity right = scene.ball({40, 0});
    Entity bomb = scene.at({0, 0});
    bomb.addComponent<Explosion>();
    scene.run(1);
    const float speed = right.get<RigidBody>().velocity.x;
    EXPECT_GT(speed, 50.0f);
    EXPECT_NEAR(left.get<RigidBody>().velocity.x, -speed, 0.1f);
    scene.run(10);
    EXPECT_FALSE(bomb.hasComponent<Explosion>());
    EXPECT_EQ(right.get<RigidBody>().velocity.x, speed);
}

TEST(PhysicsComponents, aSceneHasItsOwnGravityAndScale) {
    for (const float pixelsPerMetre : {32.0f, 64.0f, 100.0f}) {
        Scene scene;
        scene.world.resource<PhysicsSettings>().pixelsPerMetre = pixelsPerMetre;
        Entity rules = scene.world.createEntity();
        rules.addComponent<ScenePhysics>().gravity = {0, 300};
        const Entity ball = scene.ball({0, 0});
        scene.run(60);
        EXPECT_NEAR(ball.get<RigidBody>().velocity.y, 300.0f, 0.1f) << pixelsPerMetre;
        EXPECT_NEAR(Scene::place(ball).y, 150.0f, 2.0f) << pixelsPerMetre;
    }
}

TEST(PhysicsComponents, surfacesChangeWithoutEndingContacts) {
    Scene scene;
    scene.world.resource<PhysicsSettings>().stayEvents = false;
    Entity belt = scene.floor({-500, 100}, {1000, 20});
    Entity crate = scene.at({0, 84});
    crate.addComponent<RigidBody>().friction = 0.5f;
    crate.addComponent<BoxCollider>(16, 16);
    scene.run(30);
    belt.get<BoxCollider>().surfaceSpeed = 50.0f;
    int events = 0;
    for (int i = 0; i < 60; ++i) {
        scene.run(1);
        events += static_cast<int>(scene.world.events<ContactBegan>().size() +
                                   scene.world.events<ContactEnded>().size());
    }
    EXPECT_EQ(events, 0);
    EXPECT_NEAR(std::abs(crate.get<RigidBody>().velocity.x), 50.0f, 1.0f);
}

}  // namespace
}  // namespace plumb
