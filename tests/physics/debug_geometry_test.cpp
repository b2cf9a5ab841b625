#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "physics/model/fields.hpp"
#include "physics/model/joints.hpp"
#include "physics/model/shapes.hpp"
#include "random_shapes.hpp"
#include "recording_canvas.hpp"
#include "world_of_bodies.hpp"

// The places of what the debug view draws, by formula.

using namespace plumb;
using namespace plumb::physics;

namespace {

void expectNear(Vec2 found, Vec2 wanted, float tolerance = 1e-5f) {
    EXPECT_NEAR(found.x, wanted.x, tolerance);
    EXPECT_NEAR(found.y, wanted.y, tolerance);
}

void expectLine(const Stroke& stroke, Vec2 from, Vec2 to, float tolerance = 1e-5f) {
    ASSERT_EQ(stroke.points.size(), 2u);
    expectNear(stroke.points[0], from, tolerance);
    expectNear(stroke.points[1], to, tolerance);
}

float areaOf(std::span<const Vec2> points) {
    float twice = 0.0f;
    for (std::size_t i = 0; i < points.size(); ++i)
        twice += cross(points[i], points[(i + 1) % points.size()]);
    return 0.5f * twice;
}

/// m: distance from a convex outline; 0 inside.
float distanceFrom(std::span<const Vec2> corners, Vec2 point) {
    float nearest = std::numeric_limits<float>::max();
    bool isInside = true;
    const float turns = areaOf(corners) > 0.0f ? 1.0f : -1.0f;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 from = corners[i], side = corners[(i + 1) % corners.size()] - from;
        const float part = std::clamp(dot(point - from, side) / dot(side, side), 0.0f, 1.0f);
        nearest = std::min(nearest, length(point - from - part * side));
        if (turns * cross(side, point - from) < 0.0f) isInside = false;
    }
    return isInside ? 0.0f : nearest;
}

/// Two bodies at any poses and a joint of them; nothing moves.
struct Pair {
    World world;
    BodyId a, b;
    Rot turnA, turnB;
    Vec2 anchorA, anchorB;  // m, in the world

    Pair(Random& random, JointDefinition joint) {
        world.settings.gravity = {};
        const auto add = [&] {
            const BodyId body =
                addBody(world, BodyKind::Dynamic, WorldPosition{test::randomPoint(random, 3.0f)},
                        random.between(-3.0f, 3.0f));
            // Its center of mass is not its position.
            static_cast<void>(createShape(world, body, circle(0.5f, test::randomPoint(random, 0.5f))));
            return body;
        };
        a = joint.a = add();
        b = joint.b = add();
        turnA = rotationOf(world, a);
        turnB = rotationOf(world, b);
        anchorA = toVec2(worldPoint(world, a, joint.anchorA));
        anchorB = toVec2(worldPoint(world, b, joint.anchorB));
        EXPECT_TRUE(createJoint(world, joint));
    }
    [[nodiscard]] std::vector<Stroke> strokes(DebugRole role) {
        return strokesOf(drawn(world, kDrawJoints), role);
    }
    /// A stroke across `along` at a point, 0.2 m long.
    static void expectTick(const Stroke& stroke, Vec2 at, Vec2 along) {
        const Vec2 half = 0.1f * perpendicular(along);
        expectLine(stroke, at - half, at + half);
    }
};

constexpr std::uint64_t kPairs = 20;

}  // namespace

TEST(DebugGeometry, roundedOutlinesAreTheCornersGrownByTheRadius) {
    Random random = Random::seeded(1);
    for (int i = 0; i < 50; ++i) {
        SCOPED_TRACE(i);
        const float radius = random.between(0.05f, 0.5f);
        const test::Outline sharp =
            i % 2 == 0 ? test::randomPolygon(random, 2.0f) : test::regularPolygon(3 + i / 2, 2.0f);
        std::vector<Vec2> corners;
        for (const Corner& corner : sharp.corners) corners.push_back(corner.point);
        World world;
        const float angle = random.between(-3.0f, 3.0f);
        const WorldPosition place{1e6 + random.unit(), -1e6};
        const BodyId body = addBody(world, BodyKind::Static, place, angle);
        ASSERT_TRUE(createPolygon(world, body, corners, radius));
        const auto strokes = strokesOf(drawn(world, kDrawShapes, place), DebugRole::Fixed);
        ASSERT_EQ(strokes.size(), 1u);
        const std::vector<Vec2>& points = strokes[0].points;
        EXPECT_EQ(points.size(), 9 * corners.size());
        float perimeter = 0.0f;
        for (std::size_t c = 0; c < corners.size(); ++c)
            perimeter += length(corners[(c + 1) % corners.size()] - corners[c]);
        const float sharpArea = std::fabs(areaOf(corners));
        const float wanted = sharpArea + perimeter * radius + kPi * radius * radius;
        // Arcs of eight chords lose r2 t3 / 768 each for an angle of t, which is at most two half circles.
        EXPECT_NEAR(std::fabs(areaOf(points)), wanted, 0.082f * radius * radius + 1e-4f);
        float turned = 0.0f;
        for (std::size_t p = 0; p < points.size(); ++p) {
            EXPECT_NEAR(distanceFrom(corners, unrotate(rotFromAngle(angle), points[p])), radius, 2e-5f);
            const Vec2 in = points[p] - points[(p + points.size() - 1) % points.size()],
                       out = points[(p + 1) % points.size()] - points[p];
            if (length(in) > 1e-4f && length(out) > 1e-4f) turned += std::atan2(cross(in, out), dot(in, out));
        }
        EXPECT_NEAR(std::fabs(turned), 2.0f * kPi, 0.05f) << "it goes round once";
    }
}

TEST(DebugGeometry, sharpOutlinesAreTheirCornersAndDiscsShowTheirRotation) {
    Random random = Random::seeded(2);
    for (int i = 0; i < 30; ++i) {
        World world;
        const Vec2 place = test::randomPoint(random, 3.0f);
        const float angle = random.between(-3.0f, 3.0f);
        const Frame frame{place, rotFromAngle(angle)};
        const BodyId body = addBody(world, BodyKind::Static, WorldPosition{place}, angle);
        const Vec2 from = test::randomPoint(random, 2.0f), to = test::randomPoint(random, 2.0f);
        ASSERT_TRUE(createShape(world, body, segment(from, to)));
        ASSERT_TRUE(createShape(world, body, circle(0.7f, from)));
        const test::Outline hull = test::randomPolygon(random, 2.0f);
        std::vector<Vec2> corners;
        for (const Corner& corner : hull.corners) corners.push_back(corner.point);
        ASSERT_TRUE(createPolygon(world, body, corners));
        const auto strokes = strokesOf(drawn(world, kDrawShapes), DebugRole::Fixed);
        ASSERT_EQ(strokes.size(), 4u);
        expectLine(strokes[0], apply(frame, from), apply(frame, to));
        expectNear(strokes[1].points[0], apply(frame, from));
        EXPECT_EQ(strokes[1].points[1].x, 0.7f);
        expectLine(strokes[2], apply(frame, from), apply(frame, from) + rotate(frame.rotation, {0.7f, 0.0f}));
        ASSERT_EQ(strokes[3].points.size(), corners.size());
        for (std::size_t c = 0; c < corners.size(); ++c)
            expectNear(strokes[3].points[c], apply(frame, hull.corners[c].point));
    }
}

TEST(DebugGeometry, oneWayShapesShowTheirOpenDirection) {
    World world;
    const BodyId body = addBody(world, BodyKind::Static, {2.0, 3.0}, 0.5f);
    ASSERT_TRUE(createShape(world, body, box({1.0f, 0.2f}, {0.5f, 0.0f}),
                            {.oneWay = true, .oneWayDirection = {0.0f, 1.0f}}));
    const Recording picture = drawn(world, kDrawShapes);
    ASSERT_EQ(picture.strokes.back().kind, 'a');
    const Vec2 middle = Vec2{2.0f, 3.0f} + rotate(rotFromAngle(0.5f), {0.5f, 0.0f});
    expectLine(picture.strokes.back(), middle, middle + rotate(rotFromAngle(0.5f), {0.0f, 0.25f}));
    EXPECT_EQ(picture.count(DebugRole::Fixed, 'p'), 1u);
}

TEST(DebugGeometry, contactsAreWhereTheShapesTouch) {
    for (const float angle : {0.0f, 0.4f, 2.0f, -1.2f}) {
        SCOPED_TRACE(angle);
        const Rot turn = rotFromAngle(angle);
        World world;
        world.settings.gravity = rotate(turn, {0.0f, 10.0f});
        const auto at = [&](Vec2 point) { return WorldPosition{1e5, 0.0} + rotate(turn, point); };
        const BodyId ground = addBody(world, BodyKind::Static, at({0.0f, 0.0f}), angle);
        ASSERT_TRUE(createShape(world, ground, box({10.0f, 0.5f})));
        const BodyId crate = addBody(world, BodyKind::Dynamic, at({2.0f, -0.9f}), angle);
        ASSERT_TRUE(createShape(world, crate, box({0.7f, 0.4f})));
        for (int i = 0; i < 30; ++i) step(world, kTick);
        const WorldPosition origin{1e5, 0.0};
        const auto circles = strokesOf(drawn(world, kDrawContacts, origin), DebugRole::Contact);
        const auto normals = strokesOf(drawn(world, kDrawNormals, origin), DebugRole::Normal);
        const auto pushes = strokesOf(drawn(world, kDrawImpulses, origin), DebugRole::Impulse);
        ASSERT_EQ(circles.size(), 2u);
        ASSERT_EQ(normals.size(), 2u);
        ASSERT_EQ(pushes.size(), 2u);
        float ends = 0.0f;
        for (std::size_t i = 0; i < 2; ++i) {
            const Vec2 place = unrotate(turn, circles[i].points[0]);
            EXPECT_NEAR(place.y, -0.5f, 2e-3f);
            EXPECT_NEAR(std::fabs(place.x - 2.0f), 0.7f, 2e-3f);
            ends += place.x - 2.0f;
            EXPECT_EQ(circles[i].points[1].x, 0.02f);
            expectNear(normals[i].points[0], circles[i].points[0]);
            expectNear(unrotate(turn, normals[i].points[1] - normals[i].points[0]), {0.0f, -0.2f}, 1e-4f);
            expectNear(pushes[i].points[0], circles[i].points[0]);
            // Half of 0.02 m for each m/s2 of its weight.
            expectNear(unrotate(turn, pushes[i].points[1] - pushes[i].points[0]), {0.0f, -0.1f}, 2e-3f);
        }
        EXPECT_NEAR(ends, 0.0f, 2e-3f) << "one at each end";
    }
}

TEST(DebugGeometry, frictionIsDrawnInTheMiddleOfThePointsAndHoldsBackWhatSlides) {
    for (const float side : {-1.0f, 1.0f}) {
        Playground scene;
        scene.floor({.friction = 0.5f});
        const BodyId crate = scene.crate({3.0, 0.25}, {0.5f, 0.25f}, {.friction = 0.5f});
        ASSERT_TRUE(setVelocity(scene.world, crate, {20.0f * side, 0.0f}));
        scene.run(10);
        const auto holds = strokesOf(drawn(scene.world, kDrawFriction), DebugRole::Friction);
        ASSERT_EQ(holds.size(), 1u);
        // Points are where they were found, at the begin of the step. It brakes at 5 m/s2: 0.1 m.
        const auto place = static_cast<float>(scene.x(crate)) - kTick * velocityOf(scene.world, crate).x;
        EXPECT_NEAR(holds[0].points[0].x, place, 0.01f);
        EXPECT_NEAR(holds[0].points[0].y, 0.0f, 2e-3f);
        expectNear(holds[0].points[1] - holds[0].points[0], {-0.1f * side, 0.0f}, 2e-3f);
    }
}

TEST(DebugGeometry, hardHitsAreDrawnAsArrowsOfAMetre) {
    Playground scene;
    scene.floor();
    const BodyId ball = scene.ball({0.0, 0.52});
    ASSERT_TRUE(setVelocity(scene.world, ball, {0.0f, -50.0f}));
    scene.run(1);
    const auto pushes = strokesOf(drawn(scene.world, kDrawImpulses), DebugRole::Impulse);
    ASSERT_EQ(pushes.size(), 1u);
    expectNear(pushes[0].points[1] - pushes[0].points[0], {0.0f, 1.0f});
    // A joint that is torn at, too: 1000 N on 1 kg would be 20 m.
    const BodyId post = scene.body(BodyKind::Static, {10.0, 5.0}), hung = scene.crate({10.0, 5.0});
    ASSERT_TRUE(createJoint(scene.world, {.a = post, .b = hung}));
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(applyForce(scene.world, hung, {1000.0f, 0.0f}));
        scene.run(1);
    }
    const auto forces = strokesOf(drawn(scene.world, kDrawJointForces), DebugRole::JointForce);
    ASSERT_EQ(forces.size(), 1u);
    const Vec2 displacement = forces[0].points[1] - forces[0].points[0];
    EXPECT_NEAR(length(displacement), 1.0f, 1e-4f);
    EXPECT_NEAR(displacement.x, -1.0f, 1e-3f);
}

TEST(DebugGeometry, armsLeadFromTheCentresToTheAnchors) {
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

TEST(DebugGeometry, ofAHingeWithLimitsTheSectorOfBsCentreIsDrawn) {
    for (std::uint64_t seed = 0; seed < 2 * kPairs; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const float lower = random.between(-3.0f, 0.0f), upper = random.between(0.0f, 9.0f);
        const float reference = random.between(-3.0f, 3.0f);
        Pair pair{random,
                  {.anchorA = test::randomPoint(random, 2.0f),
                   .anchorB = test::randomPoint(random, seed % 2 == 0 ? 1.0f : 0.05f),
                   .referenceAngle = reference,
                   .limit = {true, lower, upper}}};
        const auto strokes = pair.strokes(DebugRole::JointLimit);
        ASSERT_EQ(strokes.size(), 18u);  // 16 chords and two sides
        const Vec2 arm = toVec2(centreOf(pair.world, pair.b)) - pair.anchorB;
        const float radius = std::clamp(0.6f * length(arm), 0.08f, 0.35f);
        // Where B's center would be at an angle.
        const auto at = [&](float angle) {
            const Vec2 own = unrotate(pair.turnB, normalized(arm));
            return pair.anchorB +
                   radius * rotate(pair.turnA * rotFromAngle(reference) * rotFromAngle(angle), own);
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

TEST(DebugGeometry, slidersShowTheirRangeAlongAsAxis) {
    for (std::uint64_t seed = 0; seed < kPairs; ++seed) {
        Random random = Random::seeded(seed);
        const Vec2 axis = rotate(test::randomTurn(random), {1.0f, 0.0f});
        for (const JointKind kind : {JointKind::Prismatic, JointKind::Wheel}) {
            for (const bool limited : {false, true}) {
                const float lower = random.between(-2.0f, 0.0f), upper = random.between(0.0f, 2.0f);
                Pair pair{random,
                          {.kind = kind,
                           .anchorA = test::randomPoint(random, 2.0f),
                           .axis = axis,
                           .limit = {limited, lower, upper}}};
                const auto strokes = pair.strokes(DebugRole::JointLimit);
                const Vec2 along = rotate(pair.turnA, axis);
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

TEST(DebugGeometry, rodsShowTheirShortestAndTheirLongest) {
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
            ASSERT_EQ(strokes.size(), lower > 0.0f ? 2u : 1u) << "a rope has no shortest length";
            if (lower > 0.0f) Pair::expectTick(strokes[0], pair.anchorA + lower * along, along);
            Pair::expectTick(strokes.back(), pair.anchorA + 2.0f * along, along);
        }
    }
    Random random = Random::seeded(1);
    Pair loose{random, {.kind = JointKind::Distance, .limit = {false, 0.5f, 2.0f}}};
    EXPECT_EQ(loose.strokes(DebugRole::JointLimit).size(), 0u);
    World world;  // Both anchors at one place: no direction.
    const BodyId a = addBody(world, BodyKind::Static, {}), b = addBody(world, BodyKind::Dynamic, {});
    ASSERT_TRUE(createShape(world, b, circle(0.5f)));
    ASSERT_TRUE(
        createJoint(world, {.kind = JointKind::Distance, .a = a, .b = b, .limit = {true, 0.5f, 2.0f}}));
    EXPECT_EQ(strokesOf(drawn(world, kDrawJoints), DebugRole::JointLimit).size(), 0u);
}

TEST(DebugGeometry, pulleysGearsAndMiceAreDrawnByWhatTheyConnect) {
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

TEST(DebugGeometry, fieldsAreDrawnByTheirRegion) {
    const auto strokesOfField = [](const FieldDefinition& field) {
        World world;
        EXPECT_TRUE(createField(world, field));
        return strokesOf(drawn(world, kDrawFields, {100.0, 0.0}), DebugRole::Field);
    };
    FieldDefinition wind{.kind = FieldKind::Wind, .region = RegionKind::Circle, .place = {103.0, 2.0}};
    wind.radius = 4.0f;
    wind.velocity = {0.0f, -3.0f};
    auto strokes = strokesOfField(wind);
    ASSERT_EQ(strokes.size(), 2u);
    EXPECT_EQ(strokes[0].kind, 'c');
    expectLine(strokes[0], {3.0f, 2.0f}, {4.0f, 0.0f});  // and its radius
    expectLine(strokes[1], {3.0f, 2.3f}, {3.0f, 1.7f});  // 0.2 m for each m/s
    wind.region = RegionKind::Everywhere;
    wind.velocity = {6.0f, -8.0f};
    strokes = strokesOfField(wind);
    ASSERT_EQ(strokes.size(), 1u) << "no region";
    expectLine(strokes[0], {2.7f, 2.4f}, {3.3f, 1.6f});  // not above a metre
    FieldDefinition area{.kind = FieldKind::AreaGravity, .region = RegionKind::Box, .place = {101.0, 1.0}};
    area.half = {0.5f, 2.0f};
    area.acceleration = {0.0f, 5.0f};
    strokes = strokesOfField(area);
    ASSERT_EQ(strokes.size(), 2u);
    EXPECT_EQ(strokes[0].points,
              (std::vector<Vec2>{{0.5f, -1.0f}, {1.5f, -1.0f}, {1.5f, 3.0f}, {0.5f, 3.0f}}));
    expectLine(strokes[1], {1.0f, 0.95f}, {1.0f, 1.05f});
    FieldDefinition lake{.kind = FieldKind::Buoyancy, .place = {102.0, -1.0}};
    strokes = strokesOfField(lake);
    ASSERT_EQ(strokes.size(), 1u);
    expectLine(strokes[0], {-2.0f, -1.0f}, {6.0f, -1.0f});
}

TEST(DebugGeometry, attractorsShowTheirPullAtTheirBody) {
    for (const float strength : {5.0f, -5.0f}) {
        for (const bool hasBody : {false, true}) {
            World world;
            FieldDefinition pull{.kind = FieldKind::Attractor, .place = {1.0, 1.0}, .strength = strength};
            if (hasBody) {
                pull.a = addBody(world, BodyKind::Dynamic, {7.0, 3.0});
                static_cast<void>(createShape(world, pull.a, circle(0.3f, {0.5f, 0.0f})));
            }
            ASSERT_TRUE(createField(world, pull));
            const auto strokes = strokesOf(drawn(world, kDrawFields), DebugRole::Field);
            const Vec2 middle = hasBody ? Vec2{7.5f, 3.0f} : Vec2{1.0f, 1.0f};
            ASSERT_EQ(strokes.size(), 4u);
            Vec2 sum;
            for (const Stroke& stroke : strokes) {
                EXPECT_EQ(stroke.kind, 'a');
                const Vec2 from = stroke.points[0] - middle, to = stroke.points[1] - middle;
                EXPECT_FLOAT_EQ(length(from), strength > 0.0f ? 0.5f : 0.25f);
                EXPECT_FLOAT_EQ(length(to), strength > 0.0f ? 0.25f : 0.5f);
                EXPECT_NEAR(cross(from, to), 0.0f, 1e-6f);
                EXPECT_GT(dot(from, to), 0.0f);
                sum += to;
            }
            expectNear(sum, {});
            FieldDefinition none = pull;
            none.strength = 0.0f;
            ASSERT_TRUE(setField(world, FieldId{0, world.fields.all[0].generation}, none));
            EXPECT_EQ(drawn(world, kDrawFields).count(), 0u);
        }
    }
}

TEST(DebugGeometry, springsLeadFromAnchorToAnchor) {
    Random random = Random::seeded(3);
    Pair pair{random, {.kind = JointKind::Filter}};
    FieldDefinition spring{.kind = FieldKind::Spring, .strength = 1.0f, .a = pair.a, .b = pair.b};
    spring.anchorA = {0.3f, 0.1f};
    spring.anchorB = {-0.2f, 0.4f};
    ASSERT_TRUE(createField(pair.world, spring));
    const Vec2 ends[] = {toVec2(worldPoint(pair.world, pair.a, spring.anchorA)),
                         toVec2(worldPoint(pair.world, pair.b, spring.anchorB))};
    const auto strokes = strokesOf(drawn(pair.world, kDrawFields), DebugRole::Field);
    ASSERT_EQ(strokes.size(), 3u);
    expectLine(strokes[0], ends[0], ends[1]);
    for (std::size_t i = 0; i < 2; ++i) expectLine(strokes[i + 1], ends[i], {0.06f, 0.0f});
    // It is shown with either of its bodies, or if it is selected itself.
    EXPECT_EQ(drawnOf(pair.world, kDrawFields, {}).count(), 0u);
    for (const BodyId body : {pair.a, pair.b})
        EXPECT_EQ(drawnOf(pair.world, kDrawFields, {&body, 1}).count(), 3u);
    FieldDefinition wind{.kind = FieldKind::Wind, .velocity = {1.0f, 0.0f}};
    wind.a = pair.a;
    ASSERT_TRUE(createField(pair.world, wind));
    EXPECT_EQ(drawnOf(pair.world, kDrawFields, {&pair.a, 1}).count(), 3u) << "only springs are their bodies'";
    const std::vector<std::uint8_t> chosen{0, 1};
    Recording picture;
    debugDraw(pair.world, picture, {.parts = kDrawFields, .chosenOnly = true, .fields = chosen});
    EXPECT_EQ(picture.count(), 1u);
    destroyField(pair.world, FieldId{0, pair.world.fields.all[0].generation});
    EXPECT_EQ(drawn(pair.world, kDrawFields).count(), 1u);
}

TEST(DebugGeometry, velocitiesAreDrawnInTenthsOfASecondAndPathsInTwentiethsOfTheirs) {
    World world;
    world.settings.gravity = {0.0f, 10.0f};
    const BodyId slow = *createBody(world, {.position = {0.0, 5.0}, .velocity = {0.04f, 0.0f}}),
                 fast = *createBody(world, {.position = {2.0, 1.0}, .velocity = {3.0f, -4.0f}}),
                 limit = *createBody(world,
                                     {.position = {4.0, 1.0}, .velocity = {0.5f, 0.0f}, .sleepSpeed = 0.5f});
    for (const BodyId body : {slow, fast, limit}) static_cast<void>(createShape(world, body, circle(0.5f)));
    const BodyId lift = *createBody(world, {.kind = BodyKind::Kinematic, .velocity = {1.0f, 2.0f}});
    static_cast<void>(createShape(world, lift, circle(0.5f)));
    const auto arrows = strokesOf(drawn(world, kDrawVelocities), DebugRole::Velocity);
    ASSERT_EQ(arrows.size(), 4u);
    expectLine(arrows[1], {2.0f, 1.0f}, {2.3f, 0.6f});
    expectLine(arrows[3], {0.0f, 0.0f}, {0.1f, 0.2f});
    const auto lines = strokesOf(drawn(world, kDrawPaths), DebugRole::Path);
    ASSERT_EQ(lines.size(), 40u) << "of dynamic bodies that are not slower than their sleep speed";
    for (std::size_t i = 0; i < 20; ++i) {
        const auto at = [](std::size_t part) {
            const float time = 0.05f * static_cast<float>(part);
            return Vec2{2.0f + 3.0f * time, 1.0f - 4.0f * time + 5.0f * time * time};
        };
        expectLine(lines[i], at(i), at(i + 1), 1e-4f);
    }
    const auto middles = strokesOf(drawn(world, kDrawCentres), DebugRole::Centre);
    ASSERT_EQ(middles.size(), 3u);
    expectLine(middles[1], {2.0f, 1.0f}, {0.02f, 0.0f});
}

TEST(DebugGeometry, whatIsOutOfSightIsLeftOutAndWhatIsSmallIsABox) {
    World world;
    for (const double x : {0.0, 5.0, 9.0}) {
        const BodyId body = addBody(world, BodyKind::Static, {x, 0.0});
        static_cast<void>(createShape(world, body, circle(0.5f)));
    }
    const auto discs = [&](AABB sight, float minimum = 0.0f) {
        Recording picture;
        debugDraw(world, picture, {.parts = kDrawShapes, .sight = &sight, .minimum = minimum});
        return std::pair{picture.count(DebugRole::Fixed, 'c'), picture.count(DebugRole::Fixed, 'p')};
    };
    EXPECT_EQ(discs({{-1.0f, -1.0f}, {10.0f, 1.0f}}).first, 3u);
    EXPECT_EQ(discs({{1.0f, -1.0f}, {10.0f, 1.0f}}).first, 2u);
    EXPECT_EQ(discs({{1.0f, 3.0f}, {10.0f, 4.0f}}).first, 0u);
    EXPECT_EQ(discs({{-1.0f, -1.0f}, {10.0f, 1.0f}}, 0.9f), (std::pair<std::size_t, std::size_t>{3u, 0u}));
    EXPECT_EQ(discs({{-1.0f, -1.0f}, {10.0f, 1.0f}}, 2.0f), (std::pair<std::size_t, std::size_t>{0u, 3u}));
}

TEST(DebugGeometry, sweptShapesAreDrawnWhereTheyWereSweptFrom) {
    World world;
    world.settings.gravity = {};
    const BodyId shot = addBody(world, BodyKind::Dynamic, {4.0, 1.0});
    static_cast<void>(createShape(world, shot, circle(0.1f)));
    const BodyId wall = addBody(world, BodyKind::Static, {50.0, 0.0});
    static_cast<void>(createShape(world, wall, box({0.05f, 5.0f})));
    ASSERT_TRUE(setVelocity(world, shot, {600.0f, 0.0f}));
    step(world, kTick);
    const Recording picture = drawn(world, kDrawSweeps);
    EXPECT_EQ(picture.count(DebugRole::Impact, 'c'), 0u);
    const auto strokes = strokesOf(picture, DebugRole::Sweep);
    ASSERT_EQ(strokes.size(), 3u);  // a disc, its spoke and the path
    expectLine(strokes[0], {4.0f, 1.0f}, {0.1f, 0.0f});
    expectLine(strokes[2], {4.0f, 1.0f}, {14.0f, 1.0f}, 1e-3f);
    EXPECT_EQ(drawnOf(world, kDrawSweeps, {&wall, 1}).count(), 0u);
    EXPECT_EQ(drawnOf(world, kDrawSweeps, {&shot, 1}).count(), 3u);
}

TEST(DebugGeometry, whatConnectsTwoBodiesIsDrawnWithEitherAndNotOnceItIsGone) {
    Random random = Random::seeded(5);
    Pair pair{random, {.kind = JointKind::Weld}};
    for (const BodyId body : {pair.a, pair.b})
        EXPECT_EQ(drawnOf(pair.world, kDrawJoints, {&body, 1}).count(DebugRole::Joint, 'c'), 1u);
    EXPECT_EQ(drawnOf(pair.world, kDrawJoints, {}).count(), 0u);
    destroyJoint(pair.world, JointId{0, pair.world.joints.hot[0].generation});
    EXPECT_EQ(drawn(pair.world, kDrawJoints | kDrawJointForces).count(), 0u);
}

TEST(DebugGeometry, ofASleeperEveryCornerIsDrawnAsRest) {
    for (const int count : {3, 15, 16, 17, 31, 32}) {
        SCOPED_TRACE(count);
        World world;
        const BodyId body = addBody(world, BodyKind::Dynamic, {});
        std::vector<Vec2> corners;
        for (const Corner& corner : test::regularPolygon(count, 1.0f).corners)
            corners.push_back(corner.point);
        ASSERT_TRUE(createPolygon(world, body, corners));
        setAwake(world, body, false);
        const auto rests = strokesOf(drawn(world, kDrawRest), DebugRole::Rest);
        ASSERT_EQ(rests.size(), 1u);
        EXPECT_EQ(rests[0].points.size(), static_cast<std::size_t>(count));
        for (const Vec2 point : rests[0].points) EXPECT_NEAR(length(point), 1.0f, 1e-5f);
    }
}
