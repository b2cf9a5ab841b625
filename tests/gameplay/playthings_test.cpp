#include <gtest/gtest.h>

#include "ecs/hierarchy.hpp"
#include "gameplay/components.hpp"
#include "gameplay/systems.hpp"
#include "input/input.hpp"
#include "physics/soft/softbody.hpp"
#include "scene/components.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/scene_requests.hpp"
#include "scene/systems/camera_system.hpp"
#include "scene/systems/physics_system.hpp"
#include "scene/world_transform.hpp"

namespace plumb {
namespace {

/// An empty world with all systems that let the player act on bodies.
struct Playroom {
    World world;
    InputFrame frame;

    Playroom() {
        world.resource<PictureSize>().size = {320.0f, 180.0f};
        world.addSystem<PushControlSystem>();
        world.addSystem<MouseDragSystem>();
        world.addSystem<DetonatorSystem>();
        world.addSystem<PhysicsSystem>();
        world.addSystem<PortalSystem>();
        world.addSystem<TouchColorSystem>();
        world.addSystem<ShortcutSystem>();
    }
    void run(int ticks = 1) {
        for (int i = 0; i < ticks; ++i) {
            world.beginTick();
            storePreviousTransforms(world);
            world.resource<Input>().advance(frame);
            world.update(1.0f / 60.0f);
        }
    }
    Entity at(Vec2 place) {
        Entity entity = world.createEntity();
        entity.addComponent<Transform>(place.x, place.y);
        return entity;
    }
    /// Adds a ball without gravity.
    Entity ball(Vec2 place, float kilograms = 1.0f) {
        Entity entity = at(place);
        entity.addComponent<RigidBody>(kilograms).gravityScale = 0.0f;
        entity.addComponent<CircleCollider>(8.0f);
        return entity;
    }
    Entity trigger(Vec2 place) {
        Entity entity = at(place);
        entity.addComponent<StaticBody>();
        entity.addComponent<CircleCollider>(10.0f).isTrigger = true;
        return entity;
    }
    void press(Key key) {
        frame.set(key, true);
        run();
        frame.set(key, false);
        run();
    }
    TextId named(std::string_view text) { return world.texts().add(text); }
};

TEST(PushControl, pushesUpToItsSpeedAndJumpsOnlyFromTheGround) {
    Playroom room;
    Entity floor = room.at({-500, 100});
    floor.addComponent<BoxCollider>(1000, 20);
    Entity ball = room.ball({0, 92});
    ball.get<RigidBody>().gravityScale = 1.0f;
    ball.get<RigidBody>().friction = 0.0f;
    ball.addComponent<PushControl>();
    room.run(10);
    room.frame.set(Key::Right, true);
    room.run(120);
    EXPECT_NEAR(ball.get<RigidBody>().velocity.x, 260.0f, 16.0f);
    room.frame.set(Key::Right, false);
    room.press(Key::Space);
    EXPECT_LT(ball.get<RigidBody>().velocity.y, -380.0f);
    room.run(5);
    const float rising = ball.get<RigidBody>().velocity.y;
    room.press(Key::Space);
    EXPECT_GT(ball.get<RigidBody>().velocity.y, rising) << "the ball must not jump in the air";
}

TEST(MouseDrag, grabsHoldsAndReleasesTheBodyUnderTheMouse) {
    Playroom room;
    Entity near = room.ball({100, 100});
    Entity far = room.ball({200, 100});
    Entity hand = room.at({0, 0});
    hand.addComponent<MouseDrag>();
    room.run(2);
    EXPECT_TRUE(hand.hasComponent<Hidden>());
    room.frame.mouseX = 104;
    room.frame.mouseY = 100;
    room.frame.mouseButtons = 1;
    room.run();
    EXPECT_TRUE(near.hasComponent<MouseJoint>());
    EXPECT_FALSE(far.hasComponent<MouseJoint>());
    EXPECT_FALSE(hand.hasComponent<Hidden>());
    room.frame.mouseY = 60;
    room.run(120);
    EXPECT_NEAR(length(near.get<Transform>().position - Vec2{104, 60}), 4.0f, 1.0f);
    room.frame.mouseButtons = 0;
    room.run();
    EXPECT_FALSE(near.hasComponent<MouseJoint>());
    EXPECT_TRUE(hand.hasComponent<Hidden>());
}

TEST(MouseDrag, itsLineConnectsTheHeldBodyWithTheMouse) {
    Playroom room;
    Entity ball = room.ball({100, 100});
    Entity line = room.at({0, 0});
    line.addComponent<Sprite>().width = 8;
    Entity hand = room.at({0, 0});
    hand.addComponent<MouseDrag>();
    setParent(room.world, line, hand);
    room.frame.setMouse({100, 100});
    room.run(2);
    EXPECT_EQ(line.get<Transform>().scale.x, 0.0f) << "no line while no body is held";
    room.frame.mouseButtons = 1;
    room.run();
    room.frame.setMouse({100, 180});
    room.run();
    const Pose drawn = worldPose(room.world, line);
    EXPECT_LT(length(drawn.position - ball.get<Transform>().position), 20.0f);
    const Vec2 end = drawn.position + rotated(Vec2{8.0f * drawn.scale.x, 0.0f}, drawn.rotation);
    EXPECT_LT(length(end - Vec2{100, 180}), 0.01f);
    room.frame.mouseButtons = 0;
    room.run();
    EXPECT_EQ(line.get<Transform>().scale.x, 0.0f);
}

TEST(MouseDrag, releasesDestroyedBodiesAndIgnoresBodiesThatCannotBeDragged) {
    Playroom room;
    Entity ball = room.ball({100, 100});
    Entity hand = room.at({0, 0});
    hand.addComponent<MouseDrag>();
    room.run();
    room.frame.mouseX = room.frame.mouseY = 100;
    room.frame.mouseButtons = 1;
    room.run(3);
    room.world.destroy(ball.id());
    room.run(3);
    EXPECT_TRUE(hand.hasComponent<Hidden>());
    room.frame.mouseButtons = 0;
    Entity other = room.ball({100, 100});
    hand.get<MouseDrag>().mask = 2;
    room.run(2);
    room.frame.mouseButtons = 1;
    room.run(2);
    EXPECT_FALSE(other.hasComponent<MouseJoint>());
}

/// Positions of the particles of a soft body, px.
std::vector<Vec2> particlesOf(Playroom& room, Entity entity) {
    PhysicsState& state = room.world.resource<PhysicsState>();
    std::vector<Vec2> places;
    for (const SoftLinkage& linkage : state.softBodies) {
        if (!(linkage.entity == entity.id())) continue;
        for (const auto& particle : physics::particlesOf(state.world, linkage.body))
            places.push_back(positionInPixels(particle.place, state.scale));
    }
    return places;
}

Vec2 middleOf(const std::vector<Vec2>& places) {
    Vec2 sum;
    for (const Vec2 place : places) sum += place;
    return sum / static_cast<float>(places.size());
}

TEST(MouseDrag, carriesAJellyByItsMiddleAndLetsItFall) {
    Playroom room;
    room.at({-500, 170}).addComponent<BoxCollider>(1000, 20);
    Entity jelly = room.at({100, 120});
    jelly.addComponent<Jelly>().radius = 40.0f;
    Entity hand = room.at({0, 0});
    hand.addComponent<MouseDrag>();
    room.frame.mouseX = 100;
    room.frame.mouseY = 130;
    room.run(60);
    const Vec2 before = middleOf(particlesOf(room, jelly));
    room.frame.mouseButtons = 1;
    room.run();
    EXPECT_TRUE(jelly.hasComponent<SoftGrip>());
    EXPECT_FALSE(hand.hasComponent<Hidden>());
    room.frame.mouseX = 220;
    room.frame.mouseY = 60;
    room.run(120);
    EXPECT_LT(length(middleOf(particlesOf(room, jelly)) - before - Vec2{120, -70}), 25.0f);
    room.frame.mouseButtons = 0;
    room.run(120);
    EXPECT_FALSE(jelly.hasComponent<SoftGrip>());
    EXPECT_TRUE(hand.hasComponent<Hidden>());
    EXPECT_NEAR(middleOf(particlesOf(room, jelly)).y, before.y, 3.0f)
        << "the jelly must lie on the ground again";
}

TEST(MouseDrag, pullsARopeAndAClothWhichKeepTheirLengthAndTheirPins) {
    Playroom room;
    Entity rope = room.at({100, 20}), cloth = room.at({200, 20});
    rope.addComponent<Rope>().to = {0.0f, 100.0f};
    cloth.addComponent<Cloth>().size = {80.0f, 60.0f};
    room.at({0, 0}).addComponent<MouseDrag>();
    for (const auto& [entity, from] : {std::pair{rope, Vec2{100, 110}}, {cloth, Vec2{240, 70}}}) {
        room.frame.setMouse(from);
        room.frame.mouseButtons = 0;
        room.run(60);
        const std::vector<Vec2> before = particlesOf(room, entity);
        room.frame.mouseButtons = 1;
        room.run();
        ASSERT_TRUE(entity.hasComponent<SoftGrip>());
        room.frame.setMouse(from + Vec2{60, 40});
        room.run(120);
        const std::vector<Vec2> after = particlesOf(room, entity);
        EXPECT_GT(middleOf(after).x, middleOf(before).x + 5.0f);
        EXPECT_EQ(after.front(), before.front());
        for (std::size_t i = 0; i < after.size(); ++i)
            EXPECT_LT(length(after[i] - before.front()), 125.0f) << i;
    }
}

TEST(MouseDrag, ignoresSoftBodiesThatAreNotUnderTheMouse) {
    Playroom room;
    Entity rope = room.at({100, 20}), jelly = room.at({220, 80});
    rope.addComponent<Rope>().to = {0.0f, 100.0f};
    jelly.addComponent<Jelly>().radius = 30.0f;
    jelly.get<Jelly>().layers = 2;
    Entity hand = room.at({0, 0});
    hand.addComponent<MouseDrag>().mask = 1;
    room.run();
    for (const Vec2 place : {Vec2{130, 60}, {220, 80}, {100, 160}}) {
        room.frame.setMouse(place);
        room.frame.mouseButtons = 1;
        room.run();
        room.frame.mouseButtons = 0;
        EXPECT_TRUE(hand.hasComponent<Hidden>()) << place.x;
        room.run();
    }
}

TEST(Detonator, explodesAtItsTimeOrByItsAction) {
    Playroom room;
    Entity ball = room.ball({40, 0});
    Entity charge = room.at({0, 0});
    Detonator& detonator = charge.addComponent<Detonator>();
    detonator.after = 0.5f;
    detonator.action = room.named("Jump");
    room.run(29);
    EXPECT_EQ(ball.get<RigidBody>().velocity, Vec2{});
    room.run(2);
    const float once = ball.get<RigidBody>().velocity.x;
    EXPECT_GT(once, 10.0f);
    room.run(60);
    EXPECT_NEAR(ball.get<RigidBody>().velocity.x, once, 0.1f) << "the detonator must explode once";
    room.press(Key::Space);
    EXPECT_GT(ball.get<RigidBody>().velocity.x, once + 5.0f);
}

TEST(Portal, teleportsABodyWithOrWithoutItsVelocity) {
    for (const bool keeps : {true, false}) {
        SCOPED_TRACE(keeps);
        Playroom room;
        Entity ball = room.ball({0, 0});
        ball.get<RigidBody>().velocity = {120.0f, 0.0f};
        Portal& portal = room.trigger({40, 0}).addComponent<Portal>();
        portal.shift = {0.0f, 300.0f};
        portal.keepVelocity = keeps;
        room.run(60);
        EXPECT_GT(ball.get<Transform>().position.y, 250.0f);
        EXPECT_NEAR(ball.get<RigidBody>().velocity.x, keeps ? 120.0f : 0.0f, 0.5f);
    }
}

TEST(TouchColor, isOneColorInTriggersAndItsOwnOutsideOfThem) {
    Playroom room;
    room.trigger({40, 0});
    room.trigger({52, 0});
    Entity ball = room.ball({0, 0});
    ball.get<RigidBody>().velocity = {60.0f, 0.0f};
    const Color own{10, 20, 30, 255}, touched{1, 2, 3, 255};
    ball.addComponent<Sprite>().tint = own;
    ball.addComponent<TouchColor>().color = touched;
    int changes = 0;
    Color before = own;
    for (int i = 0; i < 120; ++i) {
        room.run();
        const Color now = ball.get<Sprite>().tint;
        changes += now == before ? 0 : 1;
        before = now;
        EXPECT_EQ(now == touched, ball.get<TouchColor>().touched > 0);
    }
    EXPECT_EQ(changes, 2) << "the color stays from one trigger to the next";
    EXPECT_EQ(before, own);
}

TEST(SceneKey, asksForItsSceneWhenItsActionIsPressed) {
    Playroom room;
    SceneKey& key = room.at({}).addComponent<SceneKey>();
    key.action = room.named("Jump");
    key.scene = {room.named("scenes/b.scene.json")};
    room.run(5);
    EXPECT_TRUE(room.world.resource<SceneRequests>().empty());
    room.press(Key::Space);
    EXPECT_EQ(room.world.resource<SceneRequests>().next, key.scene.path);
    EXPECT_FALSE(room.world.resource<SceneRequests>().overlay);
    key.does = MenuAction::Open;
    room.press(Key::Space);
    EXPECT_TRUE(room.world.resource<SceneRequests>().overlay);
}

TEST(ToggleKey, hidesAndShows) {
    Playroom room;
    Entity entity = room.at({});
    entity.addComponent<ToggleKey>().action = room.named("Jump");
    room.press(Key::Space);
    EXPECT_TRUE(entity.hasComponent<Hidden>());
    room.press(Key::Space);
    EXPECT_FALSE(entity.hasComponent<Hidden>());
}

}  // namespace
}  // namespace plumb
