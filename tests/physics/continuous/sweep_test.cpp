#include "physics/continuous/sweep.hpp"

#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "core/task_pool.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

using namespace plumb;
using namespace plumb::physics;

namespace {

int shots() {
    const char* asked = std::getenv("PLUMB_SHOTS");
    return asked != nullptr ? std::atoi(asked) : 10000;
}

/// A bullet and a wall in its path; the whole scene is rotated by `angle` about the origin.
struct Shot {
    World world;
    BodyId bullet;
    Rot rotation;
    float thickness;

    [[nodiscard]] Vec2 seen() const { return unrotate(rotation, centreOf(world, bullet) - WorldPosition{}); }
    /// Distance between the rear of the bullet and the far side of the wall, m; negative unless the whole
    /// bullet is behind the wall.
    [[nodiscard]] float behind() const {
        return seen().x - 0.5f * thickness - world.bodies.info[bullet.index].reach;
    }
};

Shot makeShot(Random& random) {
    Shot shot;
    World& world = shot.world;
    world.settings.gravity = {};
    const float angle = random.between(-3.0f, 3.0f);
    shot.rotation = rotFromAngle(angle);
    shot.thickness = random.below(2) == 0 ? 0.01f : random.between(0.01f, 1.0f);
    const BodyId wall = addBody(world, BodyKind::Static, {}, angle);
    ShapeDefinition material;
    material.friction = random.between(0.0f, 1.0f);
    material.bounciness = random.below(2) == 0 ? 0.0f : random.unit();
    static_cast<void>(createShape(world, wall, box({0.5f * shot.thickness, 900.0f}), material));
    const float speed =
        random.below(2) == 0 ? random.between(10.0f, 100.0f) : random.between(100.0f, 1000.0f);
    const Vec2 way{speed, random.between(-0.7f, 0.7f) * speed};
    const Vec2 start = Vec2{-random.between(1.5f, 6.0f), 0.0f};
    const WorldPosition place = WorldPosition{} + rotate(shot.rotation, start);
    shot.bullet = addBody(world, BodyKind::Dynamic, place, random.between(-3.0f, 3.0f));
    const float size = random.below(2) == 0 ? 0.02f : random.between(0.02f, 0.3f);
    if (random.below(3) == 0) {
        static_cast<void>(createShape(world, shot.bullet, circle(size)));
    } else {
        addRandomShape(world, shot.bullet, random, size);
        if (random.below(3) == 0)
            static_cast<void>(createShape(world, shot.bullet, circle(size, {2.0f * size, 0.0f})));
    }
    static_cast<void>(setVelocity(world, shot.bullet, rotate(shot.rotation, way)));
    if (random.below(2) == 0)
        static_cast<void>(setAngularVelocity(world, shot.bullet, random.between(-200.0f, 200.0f)));
    return shot;
}

}  // namespace

TEST(SweepFastBodies, noneOfTenThousandBulletsPassesAWall) {
    int passed = 0, arrived = 0;
    for (int seed = 0; seed < shots(); ++seed) {
        Random random = Random::seeded(static_cast<std::uint64_t>(seed));
        Shot shot = makeShot(random);
        bool touched = false;
        for (int i = 0; i < 60; ++i) {
            step(shot.world, kTick);
            touched = touched || !shot.world.events.empty();
            if (shot.behind() > 0.0f || (touched && shot.seen().x < -3.0f)) break;
        }
        ASSERT_LT(std::fabs(shot.seen().y), 900.0f);
        if (shot.behind() > 0.0f) {
            ADD_FAILURE() << "seed " << seed << " is " << shot.behind() << " m behind " << shot.thickness
                          << " m";
            if (++passed > 5) break;
        }
        arrived += touched ? 1 : 0;
    }
    EXPECT_GT(arrived, shots() * 9 / 10);
}

TEST(SweepFastBodies, stopsAtTheTimeOfImpact) {
    for (const float speed : {10.0f, 50.0f, 200.0f, 1000.0f}) {
        World world;
        world.settings.gravity = {};
        const BodyId wall = addBody(world, BodyKind::Static, {30.0, 0.0});
        static_cast<void>(createShape(world, wall, box({0.005f, 5.0f})));
        const BodyId bullet = addBody(world, BodyKind::Dynamic, {29.995 - 0.02 - 0.5 * speed / 60.0, 0.0});
        static_cast<void>(createShape(world, bullet, circle(0.02f)));
        ASSERT_TRUE(setVelocity(world, bullet, {speed, 0.0f}));
        step(world, kTick);
        EXPECT_NEAR(centreOf(world, bullet).x, 29.995 - 0.02, 1.0e-3) << speed;
        EXPECT_LE(centreOf(world, bullet).x, 29.995 - 0.02) << speed;
        EXPECT_NEAR(velocityOf(world, bullet).x, 0.0f, 1e-6f * speed);
        step(world, kTick);
        EXPECT_NEAR(velocityOf(world, bullet).x, 0.0f, 1e-6f * speed);
    }
}

TEST(SweepFastBodies, bouncingBodiesKeepTheirSpeed) {
    for (const float speed : {20.0f, 300.0f, 1000.0f}) {
        World world;
        world.settings.gravity = {};
        const BodyId wall = addBody(world, BodyKind::Static, {10.0, 0.0});
        static_cast<void>(createShape(world, wall, box({0.01f, 5.0f})));
        const BodyId ball = addBody(world, BodyKind::Dynamic, {9.0, 0.0});
        static_cast<void>(createShape(world, ball, circle(0.05f), {.bounciness = 1.0f}));
        ASSERT_TRUE(setVelocity(world, ball, {speed, 0.0f}));
        for (int i = 0; i < 10; ++i) step(world, kTick);
        EXPECT_NEAR(velocityOf(world, ball).x, -speed, 0.005f * speed);
    }
}

TEST(SweepFastBodies, slidingOverAFloorOfManyShapesIsNotStopped) {
    World world;
    world.settings.gravity = {0.0f, -10.0f};
    const BodyId floor = addBody(world, BodyKind::Static, {});
    for (int i = 0; i < 200; ++i)
        static_cast<void>(createShape(world, floor, box({0.25f, 0.5f}, {0.5f * static_cast<float>(i), -0.5f}),
                                      {.friction = 0.0f}));
    const BodyId crate = addBody(world, BodyKind::Dynamic, {1.0, 0.2});
    static_cast<void>(createShape(world, crate, box({0.2f, 0.2f}), {.friction = 0.0f}));
    for (int i = 0; i < 60; ++i) step(world, kTick);
    ASSERT_TRUE(setVelocity(world, crate, {40.0f, 0.0f}));
    const double from = centreOf(world, crate).x;
    for (int i = 0; i < 60; ++i) step(world, kTick);
    EXPECT_NEAR(centreOf(world, crate).x - from, 40.0, 0.5);
}

TEST(SweepFastBodies, chainsStopBodiesInFrontOnly) {
    for (const float side : {-1.0f, 1.0f}) {
        World world;
        world.settings.gravity = {};
        const BodyId ground = addBody(world, BodyKind::Static, {});
        const std::array<Vec2, 4> points{Vec2{-20.0f, 0.0f}, Vec2{-5.0f, 0.0f}, Vec2{5.0f, 0.0f},
                                         Vec2{20.0f, 0.0f}};
        ASSERT_TRUE(createChain(world, ground, points, false));
        const Vec2 front = normalOfChain(world.shapes.geometry[0]);
        const BodyId bullet = addBody(world, BodyKind::Dynamic, WorldPosition{} + front * (3.0f * side));
        static_cast<void>(createShape(world, bullet, circle(0.05f)));
        ASSERT_TRUE(setVelocity(world, bullet, front * (-500.0f * side)));
        for (int i = 0; i < 4; ++i) step(world, kTick);
        const float height = dot(front, centreOf(world, bullet) - WorldPosition{});
        if (side > 0.0f) {
            EXPECT_GT(height, 0.0f);
        } else {
            EXPECT_GT(height, 10.0f);
        }
    }
}

TEST(SweepFastBodies, onlyBulletsAreSweptAgainstMovingBodies) {
    for (const bool asBullet : {false, true}) {
        World world;
        world.settings.gravity = {};
        BodyDefinition definition;
        definition.bullet = asBullet;
        definition.position = {-3.0, 0.0};
        definition.velocity = {600.0f, 0.0f};
        const BodyId shot = *createBody(world, definition);
        static_cast<void>(createShape(world, shot, circle(0.05f)));
        const BodyId crate = addBody(world, BodyKind::Dynamic, {});
        static_cast<void>(createShape(world, crate, box({0.1f, 2.0f})));
        step(world, kTick);
        step(world, kTick);
        EXPECT_EQ(centreOf(world, shot).x < centreOf(world, crate).x, asBullet);
        EXPECT_EQ(velocityOf(world, crate).x > 0.1f, asBullet);
    }
}

TEST(SweepFastBodies, twoBulletsMeetHalfWay) {
    World world;
    world.settings.gravity = {};
    BodyId bullets[2];
    for (int i = 0; i < 2; ++i) {
        const float side = i == 0 ? -1.0f : 1.0f;
        BodyDefinition definition;
        definition.bullet = true;
        definition.position = {4.0 * static_cast<double>(side), 0.0};
        definition.velocity = {-400.0f * side, 0.0f};
        bullets[i] = *createBody(world, definition);
        static_cast<void>(createShape(world, bullets[i], circle(0.1f)));
    }
    for (int i = 0; i < 4; ++i) step(world, kTick);
    EXPECT_LT(centreOf(world, bullets[0]).x, centreOf(world, bullets[1]).x);
    EXPECT_NEAR(velocityOf(world, bullets[0]).x, 0.0f, 1.0f);
}

TEST(SweepFastBodies, givesTheSameBitsWithAnyNumberOfThreads) {
    World one;
    one.settings.gravity = {};
    const BodyId cage = addBody(one, BodyKind::Static, {});
    for (const float side : {-1.0f, 1.0f}) {
        static_cast<void>(
            createShape(one, cage, box({0.05f, 10.0f}, {10.0f * side, 0.0f}), {.bounciness = 1.0f}));
        static_cast<void>(
            createShape(one, cage, box({10.0f, 0.05f}, {0.0f, 10.0f * side}), {.bounciness = 1.0f}));
    }
    Random random = Random::seeded(4);
    for (int i = 0; i < 100; ++i) {
        BodyDefinition definition;
        definition.position = {-8.0 + 1.7 * (i % 10), -8.0 + 1.7 * (i / 10)};
        definition.velocity = {random.between(-300.0f, 300.0f), random.between(-300.0f, 300.0f)};
        definition.bullet = i % 5 == 0;
        const BodyId body = *createBody(one, definition);
        addRandomShape(one, body, random, 0.2f);
    }
    World several = one;
    TaskPool pool{3};
    for (int i = 0; i < 100; ++i) {
        step(one, kTick);
        step(several, kTick, {.pool = &pool, .minimumWork = 0});
        ASSERT_EQ(hashOf(one), hashOf(several)) << "step " << i;
    }
    for (const BodyPose& pose : one.bodies.pose) {
        EXPECT_LE(std::fabs(pose.centre.x), 10.0);
        EXPECT_LE(std::fabs(pose.centre.y), 10.0);
    }
}
