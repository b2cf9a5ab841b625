#include <array>
#include <numbers>

#include "tests/physics_reference/solved.hpp"

namespace plumb::reference {
namespace {

using physics::ShapeDefinition;

constexpr ShapeDefinition kElastic{.friction = 0.0f, .bounciness = 1.0f};

TEST(ReferenceMotion, freeFallIsExact) {
    Playground scene;
    const BodyId ball = scene.ball({0.0, 100.0});
    const Answer answer = solved(scene.world, 2.0);
    EXPECT_NEAR(of(answer, ball).centre.y, 80.0, 1.0e-11);
    EXPECT_NEAR(answer.energy, static_cast<double>(physics::massOf(scene.world, ball)) * 1000.0, 1.0e-9);
    expectHonest(farFrom(of(answer, ball), 0.0, 80.0), answer.error);
}

TEST(ReferenceMotion, dragSlowsByAnExponentialAndTheOrderIsTwo) {
    Playground scene;
    scene.world.settings.gravity = {};
    const BodyId ball = scene.ball({});
    ASSERT_TRUE(physics::setDrag(scene.world, ball, 0.5f, 0.0f).ok());
    ASSERT_TRUE(physics::setVelocity(scene.world, ball, {8.0f, 0.0f}).ok());
    const Answer answer = solved(scene.world, 2.0);
    expectHonest(farFrom(of(answer, ball), 16.0 * (1.0 - std::exp(-1.0)), 0.0), answer.error);
    EXPECT_NEAR(answer.order, 2.0, 0.1);
}

TEST(ReferenceMotion, aCrateSlidesDownAnInclineByCoulombsLaw) {
    Playground scene;
    const float friction = 0.25f;  // exactly representable as float, like its square root
    const BodyId slope = scene.body(BodyKind::Static, {}, -0.5f);
    scene.shape(slope, physics::box({100.0f, 1.0f}), {.friction = friction});
    const Rot rotation = physics::rotationOf(scene.world, slope);
    const double angle = -std::atan2(static_cast<double>(rotation.sin), static_cast<double>(rotation.cos));
    const double sine = std::sin(angle), cosine = std::cos(angle);
    const BodyId crate = scene.body(BodyKind::Dynamic, {1.5 * sine, 1.5 * cosine}, -0.5f);
    scene.shape(crate, physics::box({0.5f, 0.5f}), {.friction = friction});
    const Answer answer = solved(scene.world, 3.0);
    const double distance = 0.5 * 10.0 * (sine - 0.25 * cosine) * 9.0;
    const double x = 1.5 * sine + distance * cosine, y = 1.5 * cosine - distance * sine;
    EXPECT_LT(farFrom(of(answer, crate), x, y), 1.0e-9 * distance);
    expectHonest(farFrom(of(answer, crate), x, y), answer.error, 1.0e-8);
}

TEST(ReferenceMotion, aCrateSticksUpToTheAngleOfFriction) {
    for (const bool sticks : {true, false}) {
        Playground scene;
        const double angle = std::atan(0.5) * (sticks ? 0.999 : 1.001);
        const BodyId slope = scene.body(BodyKind::Static, {}, static_cast<float>(-angle));
        scene.shape(slope, physics::box({100.0f, 1.0f}), {.friction = 0.5f});
        const double sine = std::sin(angle), cosine = std::cos(angle);
        const BodyId crate =
            scene.body(BodyKind::Dynamic, {1.5 * sine, 1.5 * cosine}, static_cast<float>(-angle));
        scene.shape(crate, physics::box({0.5f, 0.5f}), {.friction = 0.5f});
        const double distance = farFrom(of(solved(scene.world, 1.0), crate), 1.5 * sine, 1.5 * cosine);
        if (sticks) {
            EXPECT_LT(distance, 1.0e-6);
        } else {
            EXPECT_GT(distance, 1.0e-3);
        }
    }
}

TEST(ReferenceMotion, aDiscThatSlidesRollsAtTwoThirdsOfItsSpeed) {
    Playground scene;
    scene.floor({.friction = 0.25f});
    const BodyId disc = scene.ball({-20.0, 0.5}, 0.5f, {.friction = 0.25f});
    ASSERT_TRUE(physics::setVelocity(scene.world, disc, {6.0f, 0.0f}).ok());
    const Answer answer = solved(scene.world, 1.5);
    const double sliding = 6.0 / (3.0 * 0.25 * 10.0);  // s until the disc rolls
    const double distance = 6.0 * sliding - 0.5 * 2.5 * sliding * sliding + 4.0 * (1.5 - sliding);
    EXPECT_NEAR(of(answer, disc).velocityX, 4.0, 1.0e-6);
    EXPECT_NEAR(of(answer, disc).angularVelocity, -8.0, 2.0e-6);
    expectHonest(farFrom(of(answer, disc), -20.0 + distance, 0.5), answer.error, 1.0e-6);
}

/// A disc that rolls off a cylinder without sliding: (R + r) phi'' = 2/3 g sin(phi), until it lifts off.
TEST(ReferenceMotion, aDiscRollsOffACylinder) {
    Playground scene;
    const ShapeDefinition rough{.friction = 50.0f};
    scene.shape(scene.body(BodyKind::Static, {}), physics::circle(1.0f), rough);
    double phi = 0.2, speed = 0.0;
    const BodyId disc = scene.body(BodyKind::Dynamic, {1.5 * std::sin(phi), 1.5 * std::cos(phi)});
    scene.shape(disc, physics::circle(0.5f), rough);
    constexpr int kSteps = 20000;
    constexpr double kSeconds = 0.8, kH = kSeconds / kSteps;
    const auto rise = [](double at) { return 20.0 / 3.0 / 1.5 * std::sin(at); };
    for (int i = 0; i < kSteps; ++i) {  // velocity Verlet; these steps are short enough
        speed += 0.5 * kH * rise(phi);
        phi += kH * speed;
        speed += 0.5 * kH * rise(phi);
    }
    ASSERT_GT(std::cos(phi), 4.0 / 7.0) << "the disc must not lift off yet";
    ASSERT_GT(phi, 0.5) << "the disc must have moved";
    const Answer answer = solved(scene.world, kSeconds, {.wantedError = 1.0e-7});
    expectHonest(farFrom(of(answer, disc), 1.5 * std::sin(phi), 1.5 * std::cos(phi)), answer.error);
    EXPECT_NEAR(answer.order, 2.0, 0.3);
    EXPECT_NEAR(answer.energy, 10.0 * 1.5 * std::cos(0.2) * 0.25 * std::numbers::pi, 1.0e-5);
}

TEST(ReferenceMotion, anElasticBallBouncesForEver) {
    Playground scene;
    scene.floor(kElastic);
    const BodyId ball = scene.ball({0.0, 2.5}, 0.5f, kElastic);
    const double fall = std::sqrt(0.4);  // s, fall from 2 m
    // after seven bounces, halfway between top and ground in time
    const double seconds = 2.0 * fall * 7.0 + 0.75 * fall;
    const Answer answer = solved(scene.world, seconds);
    expectHonest(farFrom(of(answer, ball), 0.0, 2.5 - 5.0 * std::pow(0.75 * fall, 2.0)), answer.error,
                 1.0e-7);
}

TEST(ReferenceMotion, aBouncinessOfAHalfKeepsHalfOfTheSpeed) {
    Playground scene;
    scene.floor();
    const BodyId ball = scene.ball({0.0, 5.5}, 0.5f, {.bounciness = 0.5f});
    const double seconds = 1.0 + 0.5;  // falls 5 m in 1 s, then rises at 5 m/s for 0.5 s
    const Answer answer = solved(scene.world, seconds);
    expectHonest(farFrom(of(answer, ball), 0.0, 0.5 + 1.25), answer.error, 1.0e-7);
}

TEST(ReferenceMotion, elasticPairsFollowTheFormula) {
    struct Pair {
        float massA, massB, speedA, speedB;
    };
    for (const Pair pair :
         {Pair{1, 1, 4, 0}, {1, 3, 5, -2}, {1, 100, 3, 0}, {50, 1, 2, 0}, {2, 7, 9, 1.5f}}) {
        Playground scene;
        scene.world.settings.gravity = {};
        const BodyId one = scene.ball({-2.0, 0.0}, 0.5f, kElastic), two = scene.ball({}, 0.5f, kElastic);
        ASSERT_TRUE(physics::setMass(scene.world, one, pair.massA).ok());
        ASSERT_TRUE(physics::setMass(scene.world, two, pair.massB).ok());
        ASSERT_TRUE(physics::setVelocity(scene.world, one, {pair.speedA, 0.0f}).ok());
        ASSERT_TRUE(physics::setVelocity(scene.world, two, {pair.speedB, 0.0f}).ok());
        const Answer answer = solved(scene.world, 1.0);
        const auto a = static_cast<double>(pair.massA), b = static_cast<double>(pair.massB);
        const auto u = static_cast<double>(pair.speedA), v = static_cast<double>(pair.speedB);
        const double common = (a * u + b * v) / (a + b), time = 1.0 / (u - v);
        EXPECT_NEAR(of(answer, one).velocityX, 2.0 * common - u, 1.0e-9);
        EXPECT_NEAR(of(answer, two).velocityX, 2.0 * common - v, 1.0e-9);
        const double place = -2.0 + u * time + (2.0 * common - u) * (1.0 - time);
        expectHonest(farFrom(of(answer, one), place, 0.0), answer.error, 1.0e-7);
    }
}

TEST(ReferenceMotion, asManyBallsLeaveACradleAsArrive) {
    Playground scene;
    scene.world.settings.gravity = {};
    std::array<BodyId, 5> balls;
    for (std::size_t i = 0; i < balls.size(); ++i)
        balls[i] = scene.ball({static_cast<double>(i) - (i < 2 ? 1.0 : 0.0), 0.0}, 0.5f, kElastic);
    for (std::size_t i = 0; i < 2; ++i)
        ASSERT_TRUE(physics::setVelocity(scene.world, balls[i], {4.0f, 0.0f}).ok());
    const Answer answer = solved(scene.world, 1.0);
    for (std::size_t i = 0; i < balls.size(); ++i)
        EXPECT_NEAR(of(answer, balls[i]).velocityX, i < 3 ? 0.0 : 4.0, 1.0e-9) << i;
}

TEST(ReferenceMotion, obliqueCollisionsConserveMomentumAndEnergy) {
    Playground scene;
    scene.world.settings.gravity = {};
    const BodyId one = scene.ball({-3.0, -0.6}, 0.5f, kElastic), two = scene.ball({}, 0.5f, kElastic);
    ASSERT_TRUE(physics::setVelocity(scene.world, one, {4.0f, 0.0f}).ok());
    const Answer answer = solved(scene.world, 2.0);
    const double along = 4.0 * 0.8, after = 2.0 - (3.0 - 0.8) / 4.0;  // m/s; time after the impact, s
    const double x = along * 0.8, y = along * 0.6;
    EXPECT_NEAR(of(answer, two).velocityX, x, 1.0e-7);
    EXPECT_NEAR(of(answer, two).velocityY, y, 1.0e-7);
    EXPECT_NEAR(of(answer, one).velocityX + of(answer, two).velocityX, 4.0, 1.0e-9);
    expectHonest(farFrom(of(answer, two), x * after, y * after), answer.error, 1.0e-6);
}

TEST(ReferenceMotion, noBodyPassesAThinWallAtAnySpeed) {
    for (const float speed : {10.0f, 100.0f, 1000.0f}) {
        Playground scene;
        scene.world.settings.gravity = {};
        scene.shape(scene.body(BodyKind::Static, {}), physics::box({0.01f, 10.0f}), {.friction = 0.0f});
        const BodyId ball = scene.ball({-5.0, 0.0}, 0.05f, {.friction = 0.0f});
        ASSERT_TRUE(physics::setVelocity(scene.world, ball, {speed, 0.0f}).ok());
        const Answer answer = solved(scene.world, 0.6);
        EXPECT_NEAR(of(answer, ball).centre.x, -0.06, 1.0e-7) << speed;
    }
}

TEST(ReferenceMotion, resultsDoNotDependOnTheOrigin) {
    double ends[2];
    for (const bool isFar : {false, true}) {
        Playground scene;
        const double away = isFar ? 1.0e6 : 0.0;
        scene.shape(scene.body(BodyKind::Static, {away, away - 1.0}), physics::box({50.0f, 1.0f}));
        const BodyId crate = scene.crate({away, away + 2.0});
        ASSERT_TRUE(physics::setAngularVelocity(scene.world, crate, 1.0f).ok());
        ends[isFar ? 1 : 0] = of(solved(scene.world, 1.0, {.wantedError = 1.0e-3}), crate).centre.x - away;
    }
    EXPECT_NEAR(ends[0], ends[1], 1.0e-6);
}

}  // namespace
}  // namespace plumb::reference
