#include <array>

#include "tests/physics_reference/solved.hpp"

namespace plumb::reference {
namespace {

TEST(ReferenceStanding, eachLevelOfAStackCarriesTheWeightAbove) {
    Playground scene;
    std::vector<BodyId> bodies{scene.floor()};
    for (int i = 0; i < 20; ++i) bodies.push_back(scene.crate({0.0, 0.5 + i}));
    const Answer answer = solved(scene.world, 1.0);
    for (std::size_t level = 0; level < 20; ++level) {
        const double carried = 10.0 * static_cast<double>(20 - level);
        EXPECT_NEAR(forceBetween(answer, bodies[level], bodies[level + 1]) / carried, 1.0, 1.0e-6) << level;
    }
    expectHonest(farFrom(of(answer, bodies.back()), 0.0, 19.5), answer.error);
}

TEST(ReferenceStanding, aBoxOfAThousandTimesTheMassRestsOnTwo) {
    Playground scene;
    const BodyId ground = scene.floor(), low = scene.crate({0.0, 0.5}), middle = scene.crate({0.0, 1.5});
    const BodyId heavy = scene.crate({0.0, 2.5});
    ASSERT_TRUE(physics::setMass(scene.world, heavy, 1000.0f).ok());
    const Answer answer = solved(scene.world, 2.0);
    EXPECT_NEAR(forceBetween(answer, ground, low), 10020.0, 0.01);
    EXPECT_NEAR(forceBetween(answer, middle, heavy), 10000.0, 0.01);
    EXPECT_LT(farFrom(of(answer, heavy), 0.0, 2.5), 1.0e-6);
    expectHonest(farFrom(of(answer, heavy), 0.0, 2.5), answer.error);
}

TEST(ReferenceStanding, aPyramidStaysWhereItIs) {
    constexpr int kBase = 8;
    Playground scene;
    scene.floor();
    for (int row = 0; row < kBase; ++row) {
        for (int i = 0; i < kBase - row; ++i) scene.crate({i + 0.5 * row, row + 0.5});
    }
    const physics::World before = scene.world;
    const Answer answer = solved(scene.world, 0.5);
    const double moved = compare(before, answer).position;
    EXPECT_LT(moved, 1.0e-9);
    expectHonest(moved, answer.error);
}

TEST(ReferenceStanding, allOutlinesRestOnAFloorAndOnAChain) {
    const std::array<Vec2, 3> wedge{Vec2{-0.5f, -0.25f}, Vec2{0.5f, -0.25f}, Vec2{0.0f, 0.5f}};
    for (const bool onChain : {false, true}) {
        Playground scene;
        if (onChain) {
            const std::array<Vec2, 6> points{Vec2{20, 0}, Vec2{12, 0},  Vec2{3, 0},
                                             Vec2{-4, 0}, Vec2{-12, 0}, Vec2{-20, 0}};
            const BodyId ground = scene.body(BodyKind::Static, {});
            ASSERT_TRUE(physics::createChain(scene.world, ground, points, false).ok());
        } else {
            scene.floor();
        }
        const BodyId capsule = scene.body(BodyKind::Dynamic, {-6.0, 0.25});
        scene.shape(capsule, physics::capsule({-0.5f, 0.0f}, {0.5f, 0.0f}, 0.25f));
        const BodyId rounded = scene.body(BodyKind::Dynamic, {-4.0, 0.625});
        scene.shape(rounded, physics::box({0.5f, 0.5f}, {}, {}, 0.125f));
        const BodyId corner = scene.body(BodyKind::Dynamic, {3.0, 0.25});
        ASSERT_TRUE(physics::createPolygon(scene.world, corner, wedge).ok());
        scene.ball({6.0, 0.5});
        const physics::World before = scene.world;
        const Answer answer = solved(scene.world, 0.5);
        EXPECT_LT(compare(before, answer).position, 1.0e-7) << onChain;
        double carried = 0.0, weight = 0.0;
        for (const ContactAnswer& contact : answer.contacts) carried += contact.force;
        for (const BodyAnswer& body : answer.bodies)
            weight += 10.0 * static_cast<double>(physics::massOf(scene.world, body.body));
        EXPECT_NEAR(carried, weight, 1.0e-6 * weight) << onChain;
    }
}

TEST(ReferenceStanding, aCrateSlidesOverTheSeamsOfAChain) {
    Playground scene;
    std::vector<Vec2> points;
    for (int i = 20; i >= -20; --i) points.push_back({static_cast<float>(i), 0.0f});
    const BodyId ground = scene.body(BodyKind::Static, {});
    ASSERT_TRUE(physics::createChain(scene.world, ground, points, false, {.friction = 0.25f}).ok());
    const BodyId crate = scene.crate({-5.0, 0.5}, {0.5f, 0.5f}, {.friction = 0.25f});
    ASSERT_TRUE(physics::setVelocity(scene.world, crate, {5.0f, 0.0f}).ok());
    const Answer answer = solved(scene.world, 3.0);  // it stops after 2 s
    EXPECT_NEAR(of(answer, crate).velocityX, 0.0, 1.0e-9);
    expectHonest(farFrom(of(answer, crate), 0.0, 0.5), answer.error, 1.0e-6);
}

TEST(ReferenceStanding, aBeltCarriesAndAPlatformLifts) {
    Playground scene;
    const BodyId belt = scene.body(BodyKind::Static, {0.0, -1.0});
    scene.shape(belt, physics::box({50.0f, 1.0f}), {.friction = 0.25f, .surfaceSpeed = 2.0f});
    const BodyId crate = scene.crate({0.0, 0.5}, {0.5f, 0.5f}, {.friction = 0.25f});
    const BodyId lift = scene.body(BodyKind::Kinematic, {80.0, -1.0});
    scene.shape(lift, physics::box({5.0f, 1.0f}));
    ASSERT_TRUE(physics::setVelocity(scene.world, lift, {0.0f, 1.0f}).ok());
    const BodyId rider = scene.crate({80.0, 0.5});
    const Answer answer = solved(scene.world, 1.5);
    physics::World world = scene.world;
    for (int i = 0; i < 90; ++i) physics::step(world, 1.0f / 60.0f);
    EXPECT_NEAR(of(answer, crate).velocityX, static_cast<double>(physics::velocityOf(world, crate).x),
                1.0e-2);
    EXPECT_NEAR(std::fabs(of(answer, crate).velocityX), 2.0, 1.0e-9);
    EXPECT_NEAR(of(answer, rider).centre.y, 2.0, 1.0e-7);
    EXPECT_NEAR(forceBetween(answer, lift, rider), 10.0, 1.0e-5);
}

TEST(ReferenceStanding, overlapsAreRemovedAtOnceWithoutSpeed) {
    Playground scene;
    scene.floor();
    const BodyId low = scene.crate({0.0, 0.5}), high = scene.crate({0.0, 1.25});
    const Answer answer = solved(scene.world, 0.5);
    EXPECT_NEAR(of(answer, low).centre.y, 0.5, 1.0e-9);
    EXPECT_NEAR(of(answer, high).centre.y, 1.5, 1.0e-9);
    EXPECT_NEAR(of(answer, high).velocityY, 0.0, 1.0e-9);
}

}  // namespace
}  // namespace plumb::reference
