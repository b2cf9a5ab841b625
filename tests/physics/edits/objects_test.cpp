#include "physics/objects.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "physics/queries/ray_cast.hpp"

namespace plumb::physics {
namespace {

constexpr float kTick = 1.0f / 60.0f;

struct Counter : BoxCollider {
    using BoxCollider::BoxCollider;
    int entered = 0, stayed = 0, left = 0;
    void onCollisionEnter(Collider*) override { ++entered; }
    void onCollisionStay(Collider*) override { ++stayed; }
    void onCollisionExit(Collider*) override { ++left; }
};

/// A collider that destroys the colliders that touch it, and then itself.
struct Mine : CircleCollider {
    Physics& physics;
    int entered = 0;
    Mine(Physics& owner, float radius, const ColliderSettings& settings)
        : CircleCollider{radius, settings}, physics{owner} {}
    void onCollisionEnter(Collider* other) override {
        ++entered;
        if (other->body() != nullptr) physics.destroy(*other->body());
        physics.destroy(*this);
    }
};

TEST(Objects, aFallingCubeEntersStaysAndExitsWhenItJumps) {
    Physics physics;  // y down
    Counter* const floor = *physics.create<Counter>(nullptr, Vec2{10.0f, 1.0f});
    RigidBody* const body = *physics.createBody({0.0, -2.0});
    BoxCollider* const cube = *physics.create<BoxCollider>(body, Vec2{0.5f, 0.5f});
    EXPECT_FALSE(physics.isTouching(*floor, *cube));
    for (int i = 0; i < 60; ++i) physics.update(kTick);
    EXPECT_EQ(floor->entered, 1);
    EXPECT_GT(floor->stayed, 10);
    EXPECT_EQ(floor->left, 0);
    EXPECT_TRUE(physics.isTouching(*floor, *cube));
    EXPECT_TRUE(physics.isTouching(*cube, *floor));
    EXPECT_NEAR(body->position().y, -1.5, 0.01);
    ASSERT_TRUE(body->setVelocity({0.0f, -5.0f}).ok());
    for (int i = 0; i < 10; ++i) physics.update(kTick);
    EXPECT_EQ(floor->left, 1);
    EXPECT_FALSE(physics.isTouching(*floor, *cube));
}

TEST(Objects, collidersOfAnotherPhysicsOrOfNoneAreIgnored) {
    Physics physics, other;
    RigidBody* const body = *physics.createBody({0.0, 0.0});
    BoxCollider* const cube = *physics.create<BoxCollider>(body, Vec2{0.5f, 0.5f});
    BoxCollider* const floor =
        *physics.create<BoxCollider>(nullptr, Vec2{5.0f, 0.5f}, {.position = {0.0, 0.9}});
    RigidBody* const stranger = *other.createBody({0.0, 0.0});
    BoxCollider* const theirs = *other.create<BoxCollider>(stranger, Vec2{0.5f, 0.5f});
    BoxCollider* const theirFloor =
        *other.create<BoxCollider>(nullptr, Vec2{5.0f, 0.5f}, {.position = {0.0, 9.0}});
    BoxCollider unborn{Vec2{0.5f, 0.5f}};
    physics.update(kTick);
    other.update(kTick);
    ASSERT_TRUE(physics.isTouching(*cube, *floor));
    EXPECT_FALSE(physics.isTouching(*theirs, *theirFloor));
    EXPECT_FALSE(physics.isTouching(unborn, *floor));
    physics.destroy(unborn);
    physics.destroy(*theirs);
    physics.destroy(*stranger);
    EXPECT_FALSE(cube->destroyed());
    EXPECT_FALSE(theirs->destroyed());
    EXPECT_EQ(physics.colliderOf(cube->shape()), cube);
    EXPECT_TRUE(alive(physics.world(), body->id()));
    EXPECT_TRUE(alive(other.world(), stranger->id()));
}

TEST(Objects, callbacksMayDestroyBothColliders) {
    Physics physics;
    Mine* const mine = *physics.create<Mine>(nullptr, physics, 1.0f, ColliderSettings{.isTrigger = true});
    Counter* const floor =
        *physics.create<Counter>(nullptr, Vec2{10.0f, 1.0f}, ColliderSettings{.position = {0.0, 1.0}});
    for (int i = 0; i < 2; ++i) {
        RigidBody* const body = *physics.createBody({-0.4 + 0.8 * i, -0.1});
        ASSERT_TRUE(physics.create<BoxCollider>(body, Vec2{0.3f, 0.3f}).ok());
    }
    physics.update(kTick);
    EXPECT_EQ(mine->entered, 1) << "a destroyed collider receives no further callbacks";
    EXPECT_TRUE(mine->destroyed());
    for (int i = 0; i < 30; ++i) physics.update(kTick);
    EXPECT_EQ(bodyCount(physics.world()), 2u) << "the floor and the second cube";
    EXPECT_EQ(floor->entered - floor->left, 1);
}

TEST(Objects, forcesGravityAndConstraintsDoWhatTheySay) {
    Physics physics;
    RigidBody* const body = *physics.createBody({0.0, 0.0});
    ASSERT_TRUE(physics.create<CircleCollider>(body, 0.5f).ok());
    ASSERT_TRUE(body->setMass(4.0f).ok());
    EXPECT_EQ(body->mass(), 4.0f);
    body->useGravity(false);
    ASSERT_TRUE(body->addForce({8.0f, 0.0f}).ok());
    EXPECT_EQ(body->netForce().x, 8.0f);
    physics.update(0.5f);
    EXPECT_NEAR(body->velocity().x, 1.0f, 1.0e-4f);
    EXPECT_EQ(body->velocity().y, 0.0f);
    EXPECT_EQ(body->netForce(), Vec2{});
    const Frame next = body->predictTransform(2.0f);
    EXPECT_NEAR(next.position.x, body->position().x + 2.0, 1.0e-3);
    ASSERT_TRUE(body->setAngularVelocity(3.0f).ok());
    body->constrainRotation(true);
    physics.update(kTick);
    EXPECT_EQ(body->angularVelocity(), 0.0f);
}

TEST(Objects, invalidObjectsAreRejectedWithoutTraces) {
    Physics physics;
    EXPECT_FALSE(physics.create<CircleCollider>(nullptr, -1.0f).ok());
    EXPECT_FALSE(physics.create<BoxCollider>(nullptr, Vec2{}).ok());
    EXPECT_EQ(bodyCount(physics.world()), 0u);
}

TEST(Objects, setPositionKeepsTheAngleUnlessOneIsGiven) {
    Physics physics;
    RigidBody* const body = *physics.createBody({0.0, 0.0}, 0.5f);
    ASSERT_TRUE(body->setPosition({3.0, 4.0}).ok());
    EXPECT_NEAR(angleOf(body->rotation()), 0.5f, 1e-6f);
    EXPECT_EQ(body->position(), (WorldPosition{3.0, 4.0}));
    ASSERT_TRUE(body->setPosition({3.0, 4.0}, 0.0f).ok());
    EXPECT_EQ(angleOf(body->rotation()), 0.0f);
}

TEST(Objects, anInvalidTimeStepMovesNothingAndCallsNothing) {
    Physics physics;
    Counter* const floor = *physics.create<Counter>(nullptr, Vec2{10.0f, 1.0f});
    RigidBody* const body = *physics.createBody({0.0, -1.5});
    ASSERT_TRUE(physics.create<BoxCollider>(body, Vec2{0.5f, 0.5f}).ok());
    for (int i = 0; i < 5; ++i) physics.update(kTick);
    const std::uint64_t before = hashOf(physics.world());
    const int stayed = floor->stayed;
    for (const float dt : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(),
                           std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()})
        physics.update(dt);
    EXPECT_EQ(hashOf(physics.world()), before);
    EXPECT_EQ(floor->stayed, stayed);
    physics.update(kTick);
    EXPECT_EQ(floor->stayed, stayed + 1);
}

TEST(Objects, aRayFindsTheColliderThatItHits) {
    Physics physics;
    Counter* const floor = *physics.create<Counter>(nullptr, Vec2{10.0f, 1.0f});
    const auto hit = castRay(physics.world(), {0.0, -5.0}, {0.0f, 10.0f});
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->point.y, -1.0, 1e-6);
    EXPECT_EQ(physics.colliderOf(hit->shape), floor);
    physics.destroy(*floor);
    EXPECT_EQ(physics.colliderOf(hit->shape), nullptr);
}

TEST(Objects, aPlatformCarriesBodies) {
    Physics physics;
    RigidBody* const platform =
        *physics.createBody({.kind = BodyKind::Kinematic, .position = {0.0, 1.0}, .velocity = {1.0f, 0.0f}});
    ASSERT_TRUE(physics.create<BoxCollider>(platform, Vec2{3.0f, 0.5f}, {.friction = 1.0f}).ok());
    RigidBody* const crate = *physics.createBody({0.0, 0.0});
    ASSERT_TRUE(physics.create<BoxCollider>(crate, Vec2{0.5f, 0.5f}, {.friction = 1.0f}).ok());
    for (int i = 0; i < 120; ++i) physics.update(kTick);
    EXPECT_NEAR(platform->position().x, 2.0, 1e-3);
    EXPECT_NEAR(crate->velocity().x, 1.0f, 1e-3f);
    EXPECT_FALSE(physics.createBody({.kind = BodyKind::None}).ok());
}

/// A collider that counts its exit events in a variable that outlives it.
struct Tally : BoxCollider {
    int& left;
    Tally(Vec2 half, const ColliderSettings& settings, int& count)
        : BoxCollider{half, settings}, left{count} {}
    void onCollisionExit(Collider*) override { ++left; }
};

TEST(Objects, sleepingCollidersKeepTheirContactsAndReportTheirEnd) {
    Physics physics;
    int heard = 0;
    Counter* const floor = *physics.create<Counter>(nullptr, Vec2{10.0f, 1.0f});
    RigidBody* const body = *physics.createBody({0.0, -1.5});
    Tally* const box = *physics.create<Tally>(body, Vec2{0.5f, 0.5f}, ColliderSettings{}, heard);
    for (int i = 0; i < 120; ++i) physics.update(kTick);
    ASSERT_FALSE(isAwake(physics.world(), body->id()));
    const int stayed = floor->stayed;
    physics.update(kTick);
    EXPECT_EQ(floor->stayed, stayed);
    EXPECT_TRUE(physics.isTouching(*floor, *box));
    physics.destroy(*body);
    EXPECT_FALSE(physics.isTouching(*floor, *box));
    physics.update(kTick);
    EXPECT_EQ(floor->left, 1);
    EXPECT_EQ(heard, 0) << "destroyed colliders receive no callbacks";
}

/// A collider that tries to step the physics in a collision callback.
struct Hasty : BoxCollider {
    Physics& physics;
    int entered = 0;
    Hasty(Physics& owner, Vec2 size, const ColliderSettings& settings)
        : BoxCollider{size, settings}, physics{owner} {}
    void onCollisionEnter(Collider*) override {
        ++entered;
        for (int i = 0; i < 10; ++i) physics.update(kTick);
    }
};

TEST(Objects, steppingInACallbackIsRejected) {
    Physics physics;
    Hasty* const floor = *physics.create<Hasty>(nullptr, physics, Vec2{10.0f, 1.0f}, ColliderSettings{});
    RigidBody* const body = *physics.createBody({0.0, -1.49});
    ASSERT_TRUE(physics.create<BoxCollider>(body, Vec2{0.5f, 0.5f}).ok());
    for (int i = 0; i < 5; ++i) physics.update(kTick);
    EXPECT_EQ(floor->entered, 1);
    EXPECT_EQ(physics.world().steps, 5u);
}

TEST(Objects, aBodyOfAnotherWorldIsRejected) {
    Physics physics, other;
    RigidBody* const stranger = *other.createBody({0.0, 0.0});
    const auto made = physics.create<CircleCollider>(stranger, 1.0f);
    ASSERT_FALSE(made.ok());
    EXPECT_FALSE(made.error().remedy.empty());
    physics.update(kTick);
    EXPECT_EQ(other.world().shapes.size(), 0u);
}

template <class Kind, class... Arguments>
concept CanBeMade = requires(Physics& physics, Arguments... arguments) {
    physics.create<Kind>(nullptr, arguments...);
};
// Classes that cannot be created give a one-line compile error at the call, not deep inside the library.
static_assert(CanBeMade<BoxCollider, Vec2> && CanBeMade<CircleCollider, float, ColliderSettings>);
static_assert(!CanBeMade<BoxCollider, float> && !CanBeMade<Collider> && !CanBeMade<World>);

TEST(Objects, theFirstExampleOfTheReadmeEndsOnTheGround) {
    World world;
    const BodyId ground = *createBody(world, {.kind = BodyKind::Static, .position = {0.0, 1.0}});
    ASSERT_TRUE(createShape(world, ground, box({50.0f, 1.0f})).ok());
    const BodyId crate = *createBody(world, {.position = {0.0, -5.0}});
    ASSERT_TRUE(createShape(world, crate, box({0.5f, 0.5f}), {.friction = 0.6f}).ok());
    for (int tick = 0; tick < 120; ++tick) step(world, kTick);
    EXPECT_NEAR(positionOf(world, crate).y, -0.5, 0.01);
}

}  // namespace
}  // namespace plumb::physics
