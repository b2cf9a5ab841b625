#include <cmath>

#include "math/portable.hpp"
#include "tests/box_physics/scene_of_bodies.hpp"

namespace plumb::box_physics {
namespace {

TEST(Contact, nothingTunnelsThroughThinWallsAtAnySpeed) {
    for (const float speed : {10.0f, 30.0f, 100.0f, 300.0f, 1000.0f}) {
        for (std::uint64_t seed = 0; seed < 40; ++seed) {
            SCOPED_TRACE(testing::Message() << "speed " << speed << " seed " << seed);
            Random random = Random::seeded(seed);
            Stage60 s;
            s.settings.gravity = {};
            // A closed room with walls 2 cm thick.
            s.box(BodyKind::Static, {0, -5}, {6, 0.01f});
            s.box(BodyKind::Static, {0, 5}, {6, 0.01f});
            s.box(BodyKind::Static, {-5, 0}, {0.01f, 6});
            s.box(BodyKind::Static, {5, 0}, {0.01f, 6});
            const Vec2 start{random.between(-4, 4), random.between(-4, 4)};
            const float angle = random.between(0, kTau);
            const Vec2 velocity = Vec2{cosine(angle), sine(angle)} * speed;
            const BodyId body = seed % 2 == 0 ? s.ball(start, 0.1f, velocity, 0.9f)
                                              : s.box(BodyKind::Dynamic, start, {0.1f, 0.15f}, velocity);
            for (int i = 0; i < 30; ++i) {
                s.run(1);
                ASSERT_LT(std::abs(s.position(body).x), 5.0f);
                ASSERT_LT(std::abs(s.position(body).y), 5.0f);
            }
        }
    }
}

TEST(Contact, boxesComeToRestOnAFloorAndStay) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        Stage60 s;
        s.box(BodyKind::Static, {0, 1}, {50, 0.5f});
        BodyDefinition d;
        d.shape = Shape::box({random.between(0.1f, 0.8f), random.between(0.1f, 0.8f)});
        d.position = {random.between(-5, 5), random.between(-6, -1)};
        d.velocity = {random.between(-3, 3), random.between(-3, 8)};
        d.friction = 0.5f;
        const BodyId box = s.add(d);
        s.run(240);
        const Vec2 rest = s.position(box);
        EXPECT_NEAR(rest.y, 0.5f - d.shape.half.y, 2e-3f);
        EXPECT_TRUE(grounded(s.world, box));
        for (int i = 0; i < 120; ++i) {
            s.run(1);
            ASSERT_EQ(s.position(box), rest);
            ASSERT_TRUE(grounded(s.world, box));
        }
    }
}

TEST(Contact, aStackOfFiveStandsStill) {
    Stage60 s;
    s.box(BodyKind::Static, {0, 1}, {5, 0.5f});
    std::vector<BodyId> stack;
    for (int i = 0; i < 5; ++i) {
        stack.push_back(s.box(BodyKind::Dynamic, {0, 0.25f - 0.5f * static_cast<float>(i)}, {0.25f, 0.25f}));
    }
    s.run(600);
    for (int i = 0; i < 5; ++i) {
        const Vec2 at = s.position(stack[static_cast<std::size_t>(i)]);
        EXPECT_NEAR(at.y, 0.25f - 0.5f * static_cast<float>(i), 0.01f);
        EXPECT_EQ(at.x, 0.0f);
    }
}

TEST(Contact, collisionsKeepMomentum) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        Stage60 s;
        s.settings.gravity = {};
        Vec2 before;
        std::vector<std::pair<BodyId, float>> bodies;
        for (int i = 0; i < 12; ++i) {
            BodyDefinition d;
            d.shape = i % 2 == 0 ? Shape::circle(0.3f) : Shape::box({0.3f, 0.2f});
            d.position = {random.between(-2, 2), random.between(-2, 2)};
            d.velocity = {random.between(-4, 4), random.between(-4, 4)};
            d.mass = random.between(0.5f, 5);
            d.bounciness = random.unit();
            d.friction = random.unit();
            bodies.emplace_back(s.add(d), d.mass);
            before += d.velocity * d.mass;
        }
        s.run(60);
        Vec2 after;
        for (const auto& [id, mass] : bodies) after += s.velocity(id) * mass;
        EXPECT_NEAR(after.x, before.x, 1e-3f);
        EXPECT_NEAR(after.y, before.y, 1e-3f);
    }
}

TEST(Contact, twoEqualBallsTradeTheirSpeeds) {
    Stage60 s;
    s.settings.gravity = {};
    const BodyId a = s.ball({0, 0}, 0.5f, {5, 0}, 1.0f);
    const BodyId b = s.ball({3, 0}, 0.5f, {0, 0}, 1.0f);
    s.run(60);
    EXPECT_NEAR(s.velocity(a).x, 0.0f, 1e-5f);
    EXPECT_NEAR(s.velocity(b).x, 5.0f, 1e-5f);
    EXPECT_NEAR(s.position(b).x, 3.0f + 5.0f * (1.0f - 2.0f / 5.0f), 1e-3f);
}

TEST(Contact, aBallBouncesToTheHeightThatItsBouncinessAllows) {
    for (const float bounciness : {0.5f, 0.8f, 1.0f}) {
        SCOPED_TRACE(bounciness);
        Stage60 s;
        s.box(BodyKind::Static, {0, 1}, {50, 1});
        const BodyId ball = s.ball({0, -2.1f}, 0.1f, {}, bounciness);
        float highest = 0.0f;
        bool bounced = false;
        for (int i = 0; i < 120; ++i) {
            s.run(1);
            bounced = bounced || s.velocity(ball).y < -0.1f;
            if (bounced) highest = std::max(highest, -0.1f - s.position(ball).y);
            if (bounced && s.velocity(ball).y > 0.0f) break;
        }
        EXPECT_NEAR(highest, 2.0f * bounciness * bounciness, 0.02f);
    }
}

TEST(Contact, frictionBrakesByItsCoefficientTimesGravity) {
    Stage60 s;
    s.box(BodyKind::Static, {0, 1}, {100, 1});
    BodyDefinition d;
    d.shape = Shape::box({0.5f, 0.5f});
    d.position = {0, -0.5f};
    d.velocity = {5, 0};
    d.friction = 0.3f;
    const BodyId box = s.add(d);
    s.run(60);
    EXPECT_NEAR(s.velocity(box).x, 5.0f - 0.3f * 9.81f, 0.01f);
    s.run(120);
    EXPECT_EQ(s.velocity(box).x, 0.0f);
}

TEST(Contact, pairsBeginOnceStayAndEnd) {
    Stage60 s;
    const BodyId floor = s.box(BodyKind::Static, {0, 1}, {5, 0.5f});
    const BodyId box = s.box(BodyKind::Dynamic, {0, -1}, {0.25f, 0.25f});
    int began = 0;
    int stayed = 0;
    for (int i = 0; i < 120; ++i) {
        s.run(1);
        began += s.count(ContactPhase::Began, box);
        stayed += s.count(ContactPhase::Stayed, floor);
        EXPECT_EQ(s.count(ContactPhase::Ended, box), 0);
    }
    EXPECT_EQ(began, 1);
    EXPECT_GT(stayed, 60);
    ASSERT_TRUE(setPosition(s.world, box, {0, -3}).ok());
    s.run(1);
    EXPECT_EQ(s.count(ContactPhase::Ended, box), 1);
}

TEST(Contact, aDestroyedBodyEndsItsContacts) {
    Stage60 s;
    s.box(BodyKind::Static, {0, 1}, {5, 0.5f});
    const BodyId box = s.box(BodyKind::Dynamic, {0, 0.25f}, {0.25f, 0.25f});
    s.run(5);
    destroyBody(s.world, box);
    const BodyId next = s.box(BodyKind::Dynamic, {0, 0.25f}, {0.25f, 0.25f});
    s.run(1);
    EXPECT_EQ(s.count(ContactPhase::Ended, box), 1);
    EXPECT_EQ(s.count(ContactPhase::Began, next), 1);
}

TEST(Contact, triggersSeeEvenTheFastestAndStopNobody) {
    Stage60 s;
    s.settings.gravity = {};
    BodyDefinition d;
    d.kind = BodyKind::Static;
    d.isTrigger = true;
    d.position = {4, 0};
    d.shape = Shape::circle(0.2f);
    const BodyId coin = s.add(d);
    const BodyId bullet = s.box(BodyKind::Dynamic, {0, 0}, {0.05f, 0.05f}, {900, 0});
    s.run(1);
    EXPECT_EQ(s.count(ContactPhase::Began, coin), 1);
    EXPECT_TRUE(s.world.events[0].isTrigger);
    EXPECT_FLOAT_EQ(s.position(bullet).x, 15.0f);
    s.run(1);
    EXPECT_EQ(s.count(ContactPhase::Ended, coin), 1);
}

TEST(Contact, layersAndMasksMustAgreeOnBothSides) {
    for (int which = 0; which < 3; ++which) {
        SCOPED_TRACE(which);
        Stage60 s;
        BodyDefinition floor;
        floor.kind = BodyKind::Static;
        floor.position = {0, 1};
        floor.shape = Shape::box({5, 0.5f});
        floor.layers = 2;
        floor.mask = which == 1 ? ~1u : ~0u;
        s.add(floor);
        BodyDefinition box;
        box.layers = 1;
        box.mask = which == 2 ? ~2u : ~0u;
        box.shape = Shape::box({0.25f, 0.25f});
        const BodyId id = s.add(box);
        s.run(120);
        EXPECT_EQ(s.position(id).y < 0.3f, which == 0);
    }
}

TEST(Contact, aRisingPlatformCarriesItsRiderWithoutDrift) {
    Stage60 s;
    const BodyId platform = s.box(BodyKind::Kinematic, {0, 0.5f}, {2, 0.5f}, {0, -2});
    const BodyId rider = s.box(BodyKind::Dynamic, {0, -0.25f}, {0.25f, 0.25f});
    for (int i = 0; i < 600; ++i) {
        s.run(1);
        ASSERT_NEAR(s.position(rider).y - s.position(platform).y, -0.75f, 1e-3f) << i;
        ASSERT_TRUE(grounded(s.world, rider));
    }
}

}  // namespace
}  // namespace plumb::box_physics
