#include <cmath>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "reflect/type_registry.hpp"
#include "scene/files/scene_file.hpp"
#include "scene/physics/contact_events.hpp"
#include "scene/register_components.hpp"
#include "tests/scene/physics_scene.hpp"
#include "tests/support/allocations.hpp"

namespace plumb {
namespace {

using Scene = PhysicsScene;

TEST(PhysicsChanges, aColliderThatGrowsPushesItsBodyUp) {
    Scene scene;
    scene.floor({-500, 100}, {1000, 20});
    const Entity ball = scene.ball({0, 80});
    scene.run(120);
    EXPECT_NEAR(Scene::place(ball).y, 92.0f, 0.4f);
    ball.get<CircleCollider>().radius = 20.0f;
    scene.run(120);
    EXPECT_NEAR(Scene::place(ball).y, 80.0f, 0.4f) << "a sleeping ball that grows is pushed up too";
    ball.get<Transform>().scale = {2.0f, 2.0f};
    scene.run(120);
    EXPECT_NEAR(Scene::place(ball).y, 60.0f, 0.4f);
}

TEST(PhysicsChanges, bodiesCanChangeTheirKindAtRunTime) {
    Scene scene;
    scene.floor({-500, 100}, {1000, 20});
    Entity crate = scene.crate({0, 0});
    scene.run(5);
    const float fallen = Scene::place(crate).y;
    EXPECT_GT(fallen, 1.0f);
    crate.removeComponent<RigidBody>();  // now a static body
    scene.run(60);
    EXPECT_EQ(Scene::place(crate).y, fallen);
    crate.addComponent<KinematicBody>().velocity = {60, 0};
    scene.run(60);
    EXPECT_NEAR(Scene::place(crate).x, 60.0f, 0.1f);
    EXPECT_EQ(Scene::place(crate).y, fallen);
    crate.removeComponent<KinematicBody>();
    crate.addComponent<RigidBody>();
    scene.run(120);
    EXPECT_NEAR(Scene::place(crate).y, 84.0f, 0.4f);
    crate.get<BoxCollider>().isTrigger = true;
    scene.run(60);
    EXPECT_GT(Scene::place(crate).y, 150.0f) << "a trigger falls through the floor";
}

TEST(PhysicsChanges, touchedEntitiesMayBeDestroyedInsideTheLoopOverContacts) {
    Scene scene;
    scene.floor({-500, 100}, {1000, 20});
    std::vector<Entity> balls;
    for (int i = 0; i < 40; ++i)
        balls.push_back(scene.ball({-200.0f + 10.0f * static_cast<float>(i), 50.0f - static_cast<float>(i)}));
    for (int i = 0; i < 120; ++i) {
        scene.run(1);
        for (const ContactBegan& contact : scene.world.events<ContactBegan>()) {
            for (const EntityId id : {contact.a, contact.b}) {
                if (scene.world.alive(id) && scene.world.has<CircleCollider>(id))
                    scene.world.entity(id).destroy();
            }
        }
    }
    EXPECT_EQ(physics::bodyCount(scene.state().world), 1u);
    EXPECT_EQ(scene.world.count<CircleCollider>(), 0u);
}

TEST(PhysicsChanges, layersCanChangeAtRunTime) {
    Scene scene;
    const Entity floor = scene.floor({-500, 100}, {1000, 20});
    const Entity crate = scene.crate({0, 60});
    scene.run(120);
    EXPECT_NEAR(Scene::place(crate).y, 84.0f, 0.4f);
    floor.get<BoxCollider>().layers = 2;
    crate.get<BoxCollider>().mask = 1;
    scene.run(60);
    EXPECT_GT(Scene::place(crate).y, 200.0f);
}

TEST(PhysicsChanges, aHingeKeepsItsAnglesWhenItsLimitsChange) {
    Scene scene;
    scene.world.resource<PhysicsSettings>().gravity = {};
    const Entity arm = scene.ball({0, 0});
    auto& hinge = arm.addComponent<RevoluteJoint>();
    hinge.limited = true;
    hinge.lower = -1.0f;
    hinge.upper = 1.0f;
    const auto endOfTurn = [&](float speed) {
        arm.get<RigidBody>().angularVelocity = speed;
        scene.run(60);
        return arm.get<Transform>().rotation;
    };
    EXPECT_NEAR(endOfTurn(4.0f), 1.0f, 0.02f);
    arm.get<RevoluteJoint>().upper = 2.0f;
    EXPECT_NEAR(endOfTurn(4.0f), 2.0f, 0.02f) << "angles are measured from the initial one";
    EXPECT_NEAR(endOfTurn(-4.0f), -1.0f, 0.02f);
}

TEST(PhysicsChanges, aSpringKeepsItsLengthWhenItGetsStiffer) {
    Scene scene;
    scene.world.resource<PhysicsSettings>().gravity = {};
    const Entity load = scene.ball({0, 100});
    auto& spring = load.addComponent<DistanceJoint>();
    spring.hertz = 2.0f;
    spring.dampingRatio = 1.0f;
    scene.run(10);
    load.get<Transform>().position = {0, 150};
    scene.run(1);
    load.get<DistanceJoint>().hertz = 4.0f;
    scene.run(240);
    EXPECT_NEAR(Scene::place(load).y, 100.0f, 1.0f);
}

TEST(PhysicsChanges, ropesAreRemovedAndRestoredWithTheirEnds) {
    Scene scene;
    Entity hook = scene.floor({-2, -2}, {4, 4});
    const Entity load = scene.ball({0, 50});
    auto& rope = load.addComponent<DistanceJoint>();
    rope.other = hook;
    rope.rope = true;
    rope.length = 60.0f;
    scene.run(120);
    EXPECT_LT(Scene::place(load).y, 62.0f);
    hook.destroy();
    scene.run(30);
    EXPECT_GT(Scene::place(load).y, 100.0f) << "without its hook the load falls";
    hook = scene.floor(Scene::place(load), {4, 4});
    load.get<DistanceJoint>().other = hook;
    scene.run(240);
    EXPECT_NEAR(length(Scene::place(load) - Scene::place(hook)), 60.0f, 2.0f);
}

TEST(PhysicsChanges, qualityIsSetByTheSceneTheBodyOrTheJoint) {
    Scene scene;
    auto& rules = scene.world.createEntity().addComponent<ScenePhysics>();
    rules.quality = 4;
    const Entity ball = scene.ball({0, 0});
    const Entity other = scene.ball({100, 0});
    other.addComponent<RevoluteJoint>();
    scene.run(1);
    EXPECT_EQ(scene.state().world.settings.quality, 4);
    ball.get<RigidBody>().quality = 6;
    other.get<RevoluteJoint>().quality = 3;
    scene.run(1);
    EXPECT_EQ(scene.state().world.bodies.info[bodyOf(scene.world, ball.id()).index].quality, 6);
    EXPECT_EQ(scene.state().world.joints.definition[scene.state().joints[0].joint.index].quality, 3);
    EXPECT_EQ(scene.state().world.qualityCallers, 2u);
}

TEST(PhysicsChanges, unusedEffectsDoNotRun) {
    Scene scene;
    scene.floor({-500, 100}, {1000, 20});
    Entity crate = scene.crate({0, 60});
    scene.run(2);
    const physics::Manifest& manifest = scene.state().world.manifest;
    EXPECT_TRUE(manifest.runs(physics::Effect::Contacts));
    EXPECT_FALSE(manifest.runs(physics::Effect::Joints));
    EXPECT_FALSE(manifest.runs(physics::Effect::Triggers));
    EXPECT_FALSE(manifest.runs(physics::Effect::AreaGravity));
    crate.addComponent<RevoluteJoint>();
    crate.addComponent<GravityField>();
    scene.run(1);
    EXPECT_TRUE(manifest.runs(physics::Effect::Joints));
    EXPECT_TRUE(manifest.runs(physics::Effect::AreaGravity));
    crate.removeComponent<RevoluteJoint>();
    crate.removeComponent<GravityField>();
    scene.run(1);
    EXPECT_FALSE(manifest.runs(physics::Effect::Joints));
    EXPECT_FALSE(manifest.runs(physics::Effect::AreaGravity));
}

/// Adds a hanging mobile, a wheel on a spring and a magnet: all components that reference another entity.
void hang(Scene& scene) {
    const Entity hook = scene.floor({-2, -2}, {4, 4});
    Entity first = scene.ball({0, 50});
    first.addComponent<DistanceJoint>().other = hook;
    Entity second = scene.crate({30, 50});
    second.addComponent<RevoluteJoint>().other = first;
    Entity wheel = scene.ball({38, 90});
    wheel.addComponent<WheelJoint>().other = second;
    scene.at({200, 0}).addComponent<Attractor>().distance = 100.0f;
}

TEST(PhysicsChanges, jointsReferenceTheSameBodiesAfterSavingAndLoading) {
    TypeRegistry types;
    registerSceneComponents(types);
    const SceneContext context{types, nullptr};
    Scene played;
    hang(played);
    const SceneId scene = addScene(played.world, "scenes/mobile.scene.json");
    int order = 0;
    for (auto [entity, transform] : played.world.query<const Transform>()) {
        ++order;
        entity.addComponent<SceneEntity>(SceneEntity{static_cast<std::uint64_t>(order), order, scene});
    }
    const std::string text = sceneToJson(played.world, context, scene);
    Scene loaded;
    const auto report = loadScene(loaded.world, context, "scenes/mobile.scene.json", text);
    ASSERT_TRUE(report) << report.error().text();
    ASSERT_TRUE(report->problems.empty()) << report->problems.front().text();
    played.run(120);
    loaded.run(120);
    ASSERT_EQ(loaded.state().joints.size(), 3u);
    for (const JointLinkage& linkage : loaded.state().joints)
        EXPECT_TRUE(physics::alive(loaded.state().world, linkage.joint));
    std::vector<Vec2> before, after;
    for (auto [entity, transform] : played.world.query<const Transform>())
        before.push_back(transform.position);
    for (auto [entity, transform] : loaded.world.query<const Transform>())
        after.push_back(transform.position);
    EXPECT_EQ(before, after);
}

TEST(PhysicsChanges, aSteadyTickAllocatesNothing) {
    Scene scene;
    hang(scene);
    scene.floor({-500, 300}, {1000, 20});
    Random random = Random::seeded(5);
    for (int i = 0; i < 200; ++i) {
        const Entity crate = scene.crate({random.between(-300.0f, 300.0f), random.between(-200.0f, 250.0f)});
        crate.get<RigidBody>().canSleep = i % 2 == 0;
    }
    Entity hero = scene.at({-350, 200});
    hero.addComponent<CapsuleCollider>(12.0f, 24.0f);
    hero.addComponent<CharacterController>();
    Entity lift = scene.floor({-450, 280}, {40, 10});
    lift.addComponent<KinematicBody>();
    const auto play = [&](int ticks) {
        for (int i = 0; i < ticks; ++i) {
            hero.get<CharacterController>().velocity.x = i / 60 % 2 == 0 ? 90.0f : -90.0f;
            lift.get<Transform>().position.y = 280.0f - static_cast<float>(i % 120);
            scene.run(1);
        }
    };
    play(1800);  // until all buffers have reached the size that this scene needs
    const std::size_t before = test::allocations().made;
    play(240);
    EXPECT_EQ(test::allocations().made, before);
}

TEST(PhysicsChanges, unchangedComponentsAreNotVisited) {
    Scene scene;
    scene.floor({-500, 100}, {1000, 20});
    for (int i = 0; i < 20; ++i) scene.crate({20.0f * static_cast<float>(i), 50});
    scene.run(10);
    const std::uint64_t mark = scene.state().mark;
    scene.world.beginTick();
    EXPECT_FALSE(scene.world.changedSince<Transform>(mark)) << "the bridge's own writes are no changes";
    EXPECT_FALSE(scene.world.changedSince<RigidBody>(mark));
}

}  // namespace
}  // namespace plumb
