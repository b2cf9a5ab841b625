#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/ranges.hpp"
#include "physics/soft/softbody.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

namespace plumb::physics {
namespace {

TEST(Step, freeFallIsExactForAnyNumberOfSubsteps) {
    for (const Quality quality : {Quality{0}, Quality{2}, Quality{4}}) {
        Playground scene;
        scene.world.settings.quality = quality;
        const BodyId ball = scene.ball({0.0, 100.0});
        scene.run(120);
        EXPECT_NEAR(scene.y(ball), 100.0 - 0.5 * 10.0 * 4.0, 2.0e-4) << int{quality};
        EXPECT_NEAR(scene.velocity(ball).y, -20.0f, 1.0e-4f);
    }
}

TEST(Step, freeFallIsExactInEveryDirectionOfGravity) {
    Random random = Random::seeded(5);
    for (int i = 0; i < 30; ++i) {
        Playground scene;
        scene.world.settings.quality = static_cast<Quality>(i % 5);
        scene.world.settings.gravity = {random.between(-20.0f, 20.0f), random.between(-20.0f, 20.0f)};
        const BodyId ball = scene.ball({0.0, 0.0});
        scene.run(60);
        const Vec2 fall = 0.5f * scene.world.settings.gravity;
        EXPECT_NEAR(scene.x(ball), static_cast<double>(fall.x), 2.0e-4);
        EXPECT_NEAR(scene.y(ball), static_cast<double>(fall.y), 2.0e-4);
    }
}

TEST(Step, anInvalidTimeStepChangesNothing) {
    Playground play;
    play.floor();
    play.crate({0.0, 0.5});
    play.crate({0.3, 1.5});
    play.run(30);
    const std::uint64_t before = hashOf(play.world);
    for (const float dt : {0.0f, -0.0f, -kTick, std::numeric_limits<float>::quiet_NaN(),
                           std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()}) {
        step(play.world, dt);
        EXPECT_EQ(hashOf(play.world), before) << dt;
        EXPECT_TRUE(play.world.events.empty());
    }
}

TEST(Step, dragFollowsItsExponential) {
    Playground scene;
    const Result<BodyId> made =
        createBody(scene.world, {.velocity = {10.0f, 0.0f}, .gravityScale = 0.0f, .linearDrag = 0.7f});
    ASSERT_TRUE(made.ok());
    scene.shape(*made, circle(0.5f));
    scene.run(60);
    EXPECT_NEAR(scene.velocity(*made).x, 10.0 * std::exp(-0.7), 1.0e-4);
    EXPECT_NEAR(scene.x(*made), 10.0 / 0.7 * (1.0 - std::exp(-0.7)), 1.0e-3);
}

TEST(Step, dragOfAnySizeFollowsItsExponential) {
    Random random = Random::seeded(6);
    for (int i = 0; i < 300; ++i) {
        Playground scene;
        scene.world.settings.sleeping = false;
        scene.world.settings.quality = static_cast<Quality>(i % 5);
        scene.world.settings.gravity = {random.between(-20.0f, 20.0f), random.between(-20.0f, 20.0f)};
        const Vec2 velocity{random.between(-30.0f, 30.0f), random.between(-30.0f, 30.0f)};
        const float drag = std::pow(10.0f, random.between(-2.0f, 6.0f));  // 1/s
        const BodyId ball = *createBody(scene.world, {.velocity = velocity, .linearDrag = drag});
        scene.shape(ball, circle(0.5f));
        scene.run(60);
        const double k = static_cast<double>(drag), glide = (1.0 - std::exp(-k)) / k,
                     fall = (1.0 - glide) / k;
        const auto expected = [&](float speed, float gravity) {
            return glide * static_cast<double>(speed) + fall * static_cast<double>(gravity);
        };
        // A body that stops within one substep (up to 1/60 s) may stop up to 1/14 of its step early.
        const double stops = drag > 13.8f * 60.0f ? static_cast<double>(length(velocity)) / k : 0.0;
        const double error = 1.0e-3 + stops;
        EXPECT_NEAR(scene.x(ball), expected(velocity.x, scene.world.settings.gravity.x), error)
            << drag << ' ' << i;
        EXPECT_NEAR(scene.y(ball), expected(velocity.y, scene.world.settings.gravity.y), error)
            << drag << ' ' << i;
    }
}

TEST(Step, dragDoesNotSlowKinematicBodies) {
    Playground scene;
    const BodyId platform = *createBody(scene.world, {.kind = BodyKind::Kinematic,
                                                      .velocity = {1.0f, 0.0f},
                                                      .angularVelocity = 1.0f,
                                                      .linearDrag = 1.0f,
                                                      .angularDrag = 1.0f});
    // A body with drag makes the world run the drag effect.
    static_cast<void>(*createBody(scene.world, {.linearDrag = 1.0f}));
    scene.run(60);
    EXPECT_EQ(scene.velocity(platform), (Vec2{1.0f, 0.0f}));
    EXPECT_EQ(angularVelocityOf(scene.world, platform), 1.0f);
}

TEST(Step, aBodyRotatesByItsAngularVelocityAtAnySpeed) {
    for (const float spin : {1.0f, 10.0f, 100.0f, 1000.0f}) {
        Playground scene;
        scene.world.settings.gravity = {};
        const BodyId ball = scene.ball({0.0, 0.0});
        ASSERT_TRUE(setAngularVelocity(scene.world, ball, spin).ok());
        scene.run(1);
        const Rot expected = rotFromAngle(spin * kTick);
        EXPECT_NEAR(rotationOf(scene.world, ball).cos, expected.cos, 2.0e-5f) << spin;
        EXPECT_NEAR(rotationOf(scene.world, ball).sin, expected.sin, 2.0e-5f) << spin;
    }
}

TEST(Step, aCrateOnTheFloorRestsOnIt) {
    Playground scene;
    scene.floor();
    const BodyId crate = scene.crate({0.0, 0.5});
    scene.run(600);
    EXPECT_NEAR(scene.y(crate), 0.5, 0.001);
    EXPECT_LT(length(scene.velocity(crate)), 1.0e-3f);
    EXPECT_NEAR(scene.x(crate), 0.0, 1.0e-4);
}

TEST(Step, theForceUnderAStackIsItsWeight) {
    Playground scene;
    scene.floor();
    for (int i = 0; i < 10; ++i) scene.crate({0.0, 0.5 + i});
    scene.run(600);
    // The impulse of a substep divided by the substep's duration is a force.
    const float h = kTick / 4.0f;
    float force = 0.0f;
    for (const Contact& contact : scene.world.contacts) {
        if ((contact.flags & kFixedA) != 0) force += (contact.impulse0 + contact.impulse1) / h;
    }
    EXPECT_NEAR(force, 10 * 10.0f, 1.0f);
}

TEST(Step, collisionsConserveMomentum) {
    Playground scene;
    scene.world.settings.gravity = {};
    Vec2 before;
    for (int i = 0; i < 40; ++i) {
        const BodyId body = i % 2 == 0 ? scene.crate({1.1 * (i % 8), 1.1 * (i / 8)})
                                       : scene.ball({1.1 * (i % 8), 1.1 * (i / 8)});
        const Vec2 velocity{static_cast<float>(i % 5) - 2.0f, static_cast<float>(i % 3) - 1.0f};
        ASSERT_TRUE(setVelocity(scene.world, body, velocity).ok());
        before += massOf(scene.world, body) * velocity;
    }
    int met = 0;
    for (int i = 0; i < 120; ++i) {
        scene.run(1);
        met += touching(scene.world);
    }
    Vec2 after;
    for (std::size_t i = 0; i < scene.world.bodies.size(); ++i) {
        after += scene.world.bodies.mass[i].mass * scene.world.bodies.motion[i].velocity;
    }
    EXPECT_GT(met, 50);
    EXPECT_NEAR(after.x, before.x, 1.0e-3f);
    EXPECT_NEAR(after.y, before.y, 1.0e-3f);
}

TEST(Step, aCrateSticksToASlopeUnlessItIsSteeperThanItsFriction) {
    for (const float friction : {0.2f, 0.5f, 0.9f}) {
        for (const float part : {0.98f, 1.02f}) {  // fraction of the critical angle
            Playground scene;
            const float angle = std::atan(friction) * part;
            const ShapeDefinition rough{.friction = friction};
            const BodyId slope = scene.body(BodyKind::Static, {0.0, 0.0}, angle);
            scene.shape(slope, box({100.0f, 1.0f}), rough);
            const BodyId crate =
                scene.body(BodyKind::Dynamic, {-1.5 * std::sin(angle), 1.5 * std::cos(angle)}, angle);
            scene.shape(crate, box({0.5f, 0.5f}), rough);
            // During the first second the contact force builds up.
            scene.run(60);
            const float before = length(scene.velocity(crate));
            scene.run(120);
            const double gained = (length(scene.velocity(crate)) - before) / 2.0;
            const double fall = 10.0 * (std::sin(angle) - static_cast<double>(friction) * std::cos(angle));
            EXPECT_NEAR(gained, std::max(fall, 0.0), 0.001) << friction << " " << part;
            EXPECT_TRUE(fall > 0.0 || length(scene.velocity(crate)) < 1.0e-4f) << friction;
        }
    }
}

TEST(Step, aBallBouncesToTheHeightOfItsBounciness) {
    for (const float bounciness : {0.5f, 0.8f, 1.0f}) {
        Playground scene;
        scene.floor();
        const BodyId ball = scene.ball({0.0, 2.5}, 0.5f, {.bounciness = bounciness});
        double highest = 0.0;
        bool bounced = false;
        for (int i = 0; i < 200; ++i) {
            scene.run(1);
            const bool rises = scene.velocity(ball).y > 0.0f;
            if (bounced && !rises) break;
            bounced = bounced || rises;
            if (rises) highest = scene.y(ball) - 0.5;
        }
        EXPECT_NEAR(highest, 2.0 * bounciness * bounciness, 0.04) << bounciness;
    }
}

// For any time of impact within a step and any overlap at detection.
TEST(Step, aBounceLosesOnlyTheHeightOfItsBounciness) {
    for (const Quality quality : {Quality{0}, Quality{2}, Quality{4}}) {
        for (const float bounciness : {0.5f, 0.9f, 1.0f}) {
            for (int k = 0; k < 40; ++k) {
                SCOPED_TRACE(testing::Message() << int{quality} << " " << bounciness << " " << k);
                Playground scene;
                scene.world.settings.quality = quality;
                scene.floor();
                const double fall = 2.0 + 0.004 * k;
                const BodyId ball = scene.ball({0.0, fall + 0.5}, 0.5f, {.bounciness = bounciness});
                double wanted = fall;
                int bounces = 0;
                for (float before = 0.0f; bounces < 3;) {
                    scene.run(1);
                    const float now = scene.velocity(ball).y;
                    if (before < 0.0f && now > 0.0f) {
                        ++bounces;
                        wanted *= static_cast<double>(bounciness * bounciness);
                        scene.run(5);  // the ball has left the floor
                        const auto speed = static_cast<double>(scene.velocity(ball).y);
                        ASSERT_NEAR(scene.y(ball) - 0.5 + speed * speed / 20.0, wanted, 2.0e-4 * wanted);
                    }
                    before = scene.velocity(ball).y;
                }
            }
        }
    }
}

TEST(Step, aKinematicBodyCarriesBodies) {
    Playground scene;
    const BodyId lift = scene.body(BodyKind::Kinematic, {0.0, -0.5});
    scene.shape(lift, box({5.0f, 0.5f}));
    const BodyId crate = scene.crate({0.0, 0.5});
    scene.run(60);
    ASSERT_TRUE(setVelocity(scene.world, lift, {1.0f, 0.5f}).ok());
    scene.run(240);
    EXPECT_NEAR(scene.x(crate), scene.x(lift), 0.1);
    EXPECT_NEAR(scene.y(crate), scene.y(lift) + 1.0, 0.01);
}

TEST(Step, noBodyMovesFurtherThanTheMaxSpeedAllows) {
    // The speed is limited only at the end of the step; without a limit in the substeps the body would move
    // by thousands of kilometers.
    Playground scene;
    scene.world.settings.quality = 0;
    const BodyId ball = scene.ball({0.0, 0.0});
    ASSERT_TRUE(applyForce(scene.world, ball, {1.0e12f, 0.0f}).ok());
    scene.run(1);
    EXPECT_LE(scene.x(ball), static_cast<double>(scene.world.settings.maxSpeed * kTick) * 1.0001);
    EXPECT_GT(scene.x(ball), 1.0);
}

TEST(Step, aConveyorCarriesAtItsSpeed) {
    Playground scene;
    scene.floor({.friction = 0.6f, .surfaceSpeed = 2.0f});
    const BodyId crate = scene.crate({0.0, 0.5});
    scene.run(240);
    EXPECT_NEAR(std::fabs(scene.velocity(crate).x), 2.0f, 0.01f);
}

TEST(Step, aPositiveSurfaceSpeedMovesAroundTheShapeFromXToY) {
    // The crate is pressed against each side of a block; either the block or the crate has the surface speed.
    for (const Vec2 outward : {Vec2{1.0f, 0.0f}, Vec2{0.0f, 1.0f}, Vec2{-1.0f, 0.0f}, Vec2{0.0f, -1.0f}}) {
        const Vec2 along{-outward.y, outward.x};
        for (const bool movesBelt : {false, true}) {
            Playground scene;
            scene.world.settings.gravity = -10.0f * outward;
            const BodyId block = scene.body(BodyKind::Static, {0.0, 0.0});
            scene.shape(block, box({20.0f, 20.0f}), {.surfaceSpeed = movesBelt ? 0.0f : 2.0f});
            const BodyId crate = scene.body(BodyKind::Dynamic, WorldPosition{} + 20.5f * outward);
            scene.shape(crate, box({0.5f, 0.5f}), {.surfaceSpeed = movesBelt ? 2.0f : 0.0f});
            scene.run(60);
            // The crate's own surface moves in the opposite direction around the crate's outline, which
            // drives the crate in the same direction as a belt below it.
            EXPECT_NEAR(dot(scene.velocity(crate), along), 2.0f, 0.01f) << outward.x << " " << outward.y;
        }
    }
    // With y down, bodies on a belt move to the right.
    World world;
    const BodyId belt = addBody(world, BodyKind::Static, {0.0, 1.0});
    ASSERT_TRUE(createShape(world, belt, box({50.0f, 1.0f}), {.surfaceSpeed = 2.0f}).ok());
    const BodyId crate = addBody(world, BodyKind::Dynamic, {0.0, -0.5});
    ASSERT_TRUE(createShape(world, crate, box({0.5f, 0.5f})).ok());
    for (int i = 0; i < 60; ++i) step(world, kTick);
    EXPECT_NEAR(velocityOf(world, crate).x, 2.0f, 0.01f);
}

TEST(Step, aPredictionMatchesFreeFlight) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const auto drag = [&] { return seed % 4 == 0 ? 0.0f : std::pow(10.0f, random.between(-3.0f, 1.5f)); };
        Playground scene;
        scene.world.settings.quality = static_cast<Quality>(random.below(5));
        BodyDefinition definition{.position = {random.between(-9.0f, 9.0f), 3.0},
                                  .velocity = {random.between(-9.0f, 9.0f), random.between(-9.0f, 9.0f)},
                                  .angularVelocity = random.between(-3.0f, 3.0f),
                                  .gravityScale = random.between(-1.0f, 2.0f),
                                  .linearDrag = drag(),
                                  .angularDrag = drag()};
        if (seed % 10 == 7) definition.kind = BodyKind::Kinematic;
        const BodyId body = *createBody(scene.world, definition);
        scene.shape(body, box({0.5f, 0.2f}, {0.3f, 0.1f}));
        if (seed % 10 != 7) {
            ASSERT_TRUE(setAcceleration(scene.world, body, {random.between(-5.0f, 5.0f), 1.0f}).ok());
        }
        const int ticks = 1 + static_cast<int>(random.below(120));
        const Frame expected = predictTransform(scene.world, body, kTick * static_cast<float>(ticks));
        const Vec2 arm = scene.world.bodies.pose[body.index].localCentre;
        scene.run(ticks);
        const Vec2 miss = toVec2(centreOf(scene.world, body)) - apply(expected, arm);
        EXPECT_NEAR(length(miss), 0.0f, 1.0e-4f * (length(expected.position) + 10.0f));
        // Rotation is integrated with the angular velocity at the end of each substep.
        const float substep = kTick / static_cast<float>(1 << scene.world.settings.quality);
        const float turn = angleOf(between(expected.rotation, rotationOf(scene.world, body)));
        EXPECT_NEAR(turn, 0.0f, 0.55f * substep * std::fabs(definition.angularVelocity) + 1.0e-3f);
    }
}

TEST(Step, aPredictionIncludesForcesTorquesAndLocks) {
    Playground scene;
    scene.world.settings.gravity = {};
    const BodyId body = scene.crate({0.0, 0.0});
    ASSERT_TRUE(applyForce(scene.world, body, {6.0f, 8.0f}).ok());
    ASSERT_TRUE(applyTorque(scene.world, body, 0.5f).ok());
    setLocks(scene.world, body, false, true);
    const Frame expected = predictTransform(scene.world, body, kTick);
    scene.run(1);
    EXPECT_EQ(expected.position.y, 0.0f);
    EXPECT_NEAR(expected.position.x, scene.x(body), 1.0e-5);
    EXPECT_GT(expected.rotation.sin, 0.0f);
    EXPECT_LE(expected.rotation.sin, rotationOf(scene.world, body).sin);
}

TEST(Step, aPredictionDoesNotFallWhereGravityIsPinnedOff) {
    Playground scene;
    const BodyId body = scene.crate({0.0, 5.0});
    scene.world.manifest.pinnedOff = Manifest::bit(Effect::Gravity);
    const Frame expected = predictTransform(scene.world, body, 1.0f);
    scene.run(60);
    EXPECT_EQ(scene.y(body), 5.0);
    EXPECT_EQ(expected.position.y, 5.0f);
}

// A step of 1e-20 s made particles of soft bodies NaN, one of 1e10 s moved bodies beyond kFarthest.
TEST(Step, lengthIsLimited) {
    for (const auto& [length, limit] : {std::pair{1.0e-38f, kShortestStep},
                                        {1.0e-20f, kShortestStep},
                                        {1.0e3f, kLongestStep},
                                        {1.0e10f, kLongestStep}}) {
        SCOPED_TRACE(length);
        World world = makePit(6, 1);
        const SoftBodyId cloth = *createCloth(world, {0.0, 20.0}, {3.0f, 1.5f}, 5, 4, {.mass = 1.0f});
        static_cast<void>(pinParticle(world, cloth, 0, true));
        World limited = world;
        for (int i = 0; i < 30; ++i) {
            step(world, length);
            step(limited, limit);
            EXPECT_EQ(hashOf(world), hashOf(limited));
        }
        for (const BodyPose& pose : world.bodies.pose)
            EXPECT_LT(std::fabs(pose.centre.x) + std::fabs(pose.centre.y), kFarthest);
        for (const SoftParticle& particle : particlesOf(world, cloth))
            EXPECT_TRUE(isFinite(particle.velocity));
    }
}

}  // namespace
}  // namespace plumb::physics
