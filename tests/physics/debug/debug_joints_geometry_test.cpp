#include "tests/physics/support/debug_strokes.hpp"

// Compares the strokes of the debug view with positions computed by formulas.

using namespace plumb;
using namespace plumb::physics;

TEST(DebugGeometry, armsAreDrawnFromTheCentresToTheAnchors) {
    for (std::uint64_t seed = 0; seed < kPairs; ++seed) {
        Random random = Random::seeded(seed);
        Pair pair{random,
                  {.kind = JointKind::Weld,
                   .anchorA = test::randomPoint(random, 2.0f),
                   .anchorB = test::randomPoint(random, 2.0f)}};
        const auto strokes = pair.strokes(DebugRole::Joint);
        ASSERT_EQ(strokes.size(), 4u);
        expectLine(strokes[0], toVec2(centreOf(pair.world, pair.a)), pair.anchorA);
        expectLine(strokes[1], toVec2(centreOf(pair.world, pair.b)), pair.anchorB);
        expectLine(strokes[2], pair.anchorA, pair.anchorB);
        expectNear(strokes[3].points[0], pair.anchorB);
        EXPECT_EQ(strokes[3].points[1].x, 0.02f);
        EXPECT_EQ(pair.strokes(DebugRole::JointLimit).size(), 0u);
    }
}

TEST(DebugGeometry, limitsOfAHingeAreDrawnAsTheSectorOfBsCentre) {
    for (std::uint64_t seed = 0; seed < 2 * kPairs; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const float lower = random.between(-3.0f, 0.0f), upper = random.between(0.0f, 3.0f);
        const float reference = random.between(-3.0f, 3.0f);
        Pair pair{random,
                  {.anchorA = test::randomPoint(random, 2.0f),
                   .anchorB = test::randomPoint(random, seed % 2 == 0 ? 1.0f : 0.05f),
                   .referenceAngle = reference,
                   .limit = {true, lower, upper}}};
        const auto strokes = pair.strokes(DebugRole::JointLimit);
        ASSERT_EQ(strokes.size(), 18u);  // 16 chords and two radii
        const Vec2 arm = toVec2(centreOf(pair.world, pair.b)) - pair.anchorB;
        const float radius = std::clamp(0.6f * length(arm), 0.08f, 0.35f);
        // Expected direction from the anchor to B's center at an angle, scaled to the radius.
        const auto at = [&](float angle) {
            const Vec2 own = unrotate(pair.rotationB, normalized(arm));
            return pair.anchorB +
                   radius * rotate(pair.rotationA * rotFromAngle(reference) * rotFromAngle(angle), own);
        };
        const float range = std::min(upper - lower, 2.0f * std::numbers::pi_v<float>);
        for (int i = 0; i < 16; ++i) {
            const auto angle = [&](int chord) { return lower + range * static_cast<float>(chord) / 16.0f; };
            expectLine(strokes[static_cast<std::size_t>(i)], at(angle(i)), at(angle(i + 1)), 1e-4f);
        }
        expectLine(strokes[16], pair.anchorB, at(lower), 1e-4f);
        expectLine(strokes[17], pair.anchorB, at(upper), 1e-4f);
    }
}

TEST(DebugGeometry, aHingeAtTheCentreOfBHasASectorToo) {
    World world;
    const BodyId a = addBody(world, BodyKind::Static, {}), b = addBody(world, BodyKind::Dynamic, {1.0, 0.0});
    ASSERT_TRUE(createShape(world, b, circle(0.5f)));
    ASSERT_TRUE(createJoint(world, {.a = a, .b = b, .anchorA = {1.0f, 0.0f}, .limit = {true, 0.0f, 1.0f}}));
    const auto strokes = strokesOf(drawn(world, kDrawJoints), DebugRole::JointLimit);
    ASSERT_EQ(strokes.size(), 18u);
    expectLine(strokes[16], {1.0f, 0.0f}, {1.08f, 0.0f});
    expectLine(strokes[17], {1.0f, 0.0f}, Vec2{1.0f, 0.0f} + 0.08f * Vec2{std::cos(1.0f), std::sin(1.0f)});
    ASSERT_TRUE(change(world, JointId{0, world.joints.hot[0].generation},
                       [](JointDefinition& joint) { joint.limit.on = false; }));
    EXPECT_EQ(strokesOf(drawn(world, kDrawJoints), DebugRole::JointLimit).size(), 0u);
}

TEST(DebugGeometry, limitsOfASliderAreDrawnAlongTheAxisOfBodyA) {
    for (std::uint64_t seed = 0; seed < kPairs; ++seed) {
        Random random = Random::seeded(seed);
        const Vec2 axis = rotate(test::randomRotation(random), {1.0f, 0.0f});
        for (const JointKind kind : {JointKind::Prismatic, JointKind::Wheel}) {
            for (const bool limited : {false, true}) {
                const float lower = random.between(-2.0f, 0.0f), upper = random.between(0.0f, 2.0f);
                Pair pair{random,
                          {.kind = kind,
                           .anchorA = test::randomPoint(random, 2.0f),
                           .axis = axis,
                           .limit = {limited, lower, upper}}};
                const auto strokes = pair.strokes(DebugRole::JointLimit);
                const Vec2 along = rotate(pair.rotationA, axis);
                const Vec2 from = pair.anchorA + (limited ? lower : -0.5f) * along,
                           to = pair.anchorA + (limited ? upper : 0.5f) * along;
                ASSERT_EQ(strokes.size(), limited ? 3u : 1u);
                expectLine(strokes[0], from, to);
                if (!limited) continue;
                Pair::expectTick(strokes[1], from, along);
                Pair::expectTick(strokes[2], to, along);
            }
        }
    }
}

TEST(DebugGeometry, limitsOfARodAreDrawnAtItsMinimumAndMaximumLength) {
    for (std::uint64_t seed = 0; seed < kPairs; ++seed) {
        Random random = Random::seeded(seed);
        for (const float lower : {0.0f, 0.5f}) {
            Pair pair{random,
                      {.kind = JointKind::Distance,
                       .anchorA = test::randomPoint(random, 1.0f),
                       .anchorB = test::randomPoint(random, 1.0f),
                       .limit = {true, lower, 2.0f}}};
            const auto strokes = pair.strokes(DebugRole::JointLimit);
            const Vec2 along = normalized(pair.anchorB - pair.anchorA);
            ASSERT_EQ(strokes.size(), lower > 0.0f ? 2u : 1u) << "a rope has no lower limit";
            if (lower > 0.0f) Pair::expectTick(strokes[0], pair.anchorA + lower * along, along);
            Pair::expectTick(strokes.back(), pair.anchorA + 2.0f * along, along);
        }
    }
    Random random = Random::seeded(1);
    Pair loose{random, {.kind = JointKind::Distance, .limit = {false, 0.5f, 2.0f}}};
    EXPECT_EQ(loose.strokes(DebugRole::JointLimit).size(), 0u);
    World world;  // both anchors coincide, so the rod has no direction
    const BodyId a = addBody(world, BodyKind::Static, {}), b = addBody(world, BodyKind::Dynamic, {});
    ASSERT_TRUE(createShape(world, b, circle(0.5f)));
    ASSERT_TRUE(
        createJoint(world, {.kind = JointKind::Distance, .a = a, .b = b, .limit = {true, 0.5f, 2.0f}}));
    EXPECT_EQ(strokesOf(drawn(world, kDrawJoints), DebugRole::JointLimit).size(), 0u);
}

TEST(DebugGeometry, pulleysGearsAndMouseJointsAreDrawnBetweenTheirBodies) {
    for (std::uint64_t seed = 0; seed < kPairs; ++seed) {
        Random random = Random::seeded(seed);
        const Vec2 groundA = test::randomPoint(random, 3.0f), groundB = test::randomPoint(random, 3.0f);
        Pair pulley{random,
                    {.kind = JointKind::Pulley,
                     .anchorA = test::randomPoint(random, 1.0f),
                     .anchorB = test::randomPoint(random, 1.0f),
                     .length = 8.0f,
                     .groundA = groundA,
                     .groundB = groundB}};
        auto strokes = pulley.strokes(DebugRole::Joint);
        ASSERT_EQ(strokes.size(), 4u);
        expectLine(strokes[0], pulley.anchorA, groundA);
        expectLine(strokes[1], groundA, groundB);
        expectLine(strokes[2], groundB, pulley.anchorB);
        Pair mouse{random,
                   {.kind = JointKind::Mouse,
                    .anchorB = test::randomPoint(random, 1.0f),
                    .target = WorldPosition{groundA}}};
        strokes = mouse.strokes(DebugRole::Joint);
        ASSERT_EQ(strokes.size(), 2u);
        expectLine(strokes[0], groundA, mouse.anchorB);
    }
    World world;
    const BodyId ground = addBody(world, BodyKind::Static, {});
    const BodyId a = addBody(world, BodyKind::Dynamic, {1.0, 2.0}),
                 b = addBody(world, BodyKind::Dynamic, {4.0, 1.0});
    for (const BodyId body : {a, b}) static_cast<void>(createShape(world, body, circle(0.3f)));
    const JointId hinges[] = {*createJoint(world, {.a = ground, .b = a, .anchorA = {1.0f, 2.0f}}),
                              *createJoint(world, {.a = ground, .b = b, .anchorA = {4.0f, 1.0f}})};
    ASSERT_TRUE(createJoint(
        world, {.kind = JointKind::Gear, .a = a, .b = b, .jointA = hinges[0], .jointB = hinges[1]}));
    const auto strokes = strokesOf(drawn(world, kDrawJoints), DebugRole::Joint);
    const auto isGear = [](const Stroke& stroke) {
        return stroke.points == std::vector<Vec2>{{1.0f, 2.0f}, {4.0f, 1.0f}};
    };
    EXPECT_EQ(std::count_if(strokes.begin(), strokes.end(), isGear), 1);
}
