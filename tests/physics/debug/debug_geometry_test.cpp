#include "tests/physics/support/debug_strokes.hpp"

// Compares the strokes of the debug view with positions computed by formulas.

using namespace plumb;
using namespace plumb::physics;

TEST(DebugGeometry, roundedOutlinesAreOffsetByTheRadius) {
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
        // Eight chords across an angle of t lose an area of r2 t3 / 768; the angles of all corners sum to two
        // half circles.
        EXPECT_NEAR(std::fabs(areaOf(points)), wanted, 0.082f * radius * radius + 1e-4f);
        float turnAngle = 0.0f;
        for (std::size_t p = 0; p < points.size(); ++p) {
            EXPECT_NEAR(distanceFrom(corners, unrotate(rotFromAngle(angle), points[p])), radius, 2e-5f);
            const Vec2 in = points[p] - points[(p + points.size() - 1) % points.size()],
                       out = points[(p + 1) % points.size()] - points[p];
            if (length(in) > 1e-4f && length(out) > 1e-4f)
                turnAngle += std::atan2(cross(in, out), dot(in, out));
        }
        EXPECT_NEAR(std::fabs(turnAngle), 2.0f * kPi, 0.05f) << "the outline winds around once";
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
    const Recording recording = drawn(world, kDrawShapes);
    ASSERT_EQ(recording.strokes.back().kind, 'a');
    const Vec2 middle = Vec2{2.0f, 3.0f} + rotate(rotFromAngle(0.5f), {0.5f, 0.0f});
    expectLine(recording.strokes.back(), middle, middle + rotate(rotFromAngle(0.5f), {0.0f, 0.25f}));
    EXPECT_EQ(recording.count(DebugRole::Fixed, 'p'), 1u);
}

TEST(DebugGeometry, contactsAreWhereTheShapesTouch) {
    for (const float angle : {0.0f, 0.4f, 2.0f, -1.2f}) {
        SCOPED_TRACE(angle);
        const Rot rotation = rotFromAngle(angle);
        World world;
        world.settings.gravity = rotate(rotation, {0.0f, 10.0f});
        const auto at = [&](Vec2 point) { return WorldPosition{1e5, 0.0} + rotate(rotation, point); };
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
            const Vec2 place = unrotate(rotation, circles[i].points[0]);
            EXPECT_NEAR(place.y, -0.5f, 2e-3f);
            EXPECT_NEAR(std::fabs(place.x - 2.0f), 0.7f, 2e-3f);
            ends += place.x - 2.0f;
            EXPECT_EQ(circles[i].points[1].x, 0.02f);
            expectNear(normals[i].points[0], circles[i].points[0]);
            expectNear(unrotate(rotation, normals[i].points[1] - normals[i].points[0]), {0.0f, -0.2f}, 1e-4f);
            expectNear(pushes[i].points[0], circles[i].points[0]);
            // Each point carries half the weight, drawn with 0.02 m per m/s2.
            expectNear(unrotate(rotation, pushes[i].points[1] - pushes[i].points[0]), {0.0f, -0.1f}, 2e-3f);
        }
        EXPECT_NEAR(ends, 0.0f, 2e-3f) << "one contact point at each end";
    }
}

TEST(DebugGeometry, frictionIsDrawnBetweenTheContactPointsAgainstTheSliding) {
    for (const float side : {-1.0f, 1.0f}) {
        Playground scene;
        scene.floor({.friction = 0.5f});
        const BodyId crate = scene.crate({3.0, 0.25}, {0.5f, 0.25f}, {.friction = 0.5f});
        ASSERT_TRUE(setVelocity(scene.world, crate, {20.0f * side, 0.0f}));
        scene.run(10);
        const auto holds = strokesOf(drawn(scene.world, kDrawFriction), DebugRole::Friction);
        ASSERT_EQ(holds.size(), 1u);
        // The contact point is drawn at its position at the start of the step. Friction decelerates by 5
        // m/s2, which is drawn as 0.1 m.
        const auto place = static_cast<float>(scene.x(crate)) - kTick * velocityOf(scene.world, crate).x;
        EXPECT_NEAR(holds[0].points[0].x, place, 0.01f);
        EXPECT_NEAR(holds[0].points[0].y, 0.0f, 2e-3f);
        expectNear(holds[0].points[1] - holds[0].points[0], {-0.1f * side, 0.0f}, 2e-3f);
    }
}

TEST(DebugGeometry, arrowsOfHardHitsAreLimitedToOneMetre) {
    Playground scene;
    scene.floor();
    const BodyId ball = scene.ball({0.0, 0.52});
    ASSERT_TRUE(setVelocity(scene.world, ball, {0.0f, -50.0f}));
    scene.run(1);
    const auto pushes = strokesOf(drawn(scene.world, kDrawImpulses), DebugRole::Impulse);
    ASSERT_EQ(pushes.size(), 1u);
    expectNear(pushes[0].points[1] - pushes[0].points[0], {0.0f, 1.0f});
    // Joint forces are also limited to 1 m: 1000 N on 1 kg would be 20 m.
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
    expectLine(strokes[0], {3.0f, 2.0f}, {4.0f, 0.0f});  // with its radius
    expectLine(strokes[1], {3.0f, 2.3f}, {3.0f, 1.7f});  // 0.2 m for each m/s
    wind.region = RegionKind::Everywhere;
    wind.velocity = {6.0f, -8.0f};
    strokes = strokesOfField(wind);
    ASSERT_EQ(strokes.size(), 1u) << "no region";
    expectLine(strokes[0], {2.7f, 2.4f}, {3.3f, 1.6f});  // limited to 1 m
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

TEST(DebugGeometry, springsAreDrawnFromAnchorToAnchor) {
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
    // The spring is drawn if one of its bodies or the spring itself is selected.
    EXPECT_EQ(drawnOf(pair.world, kDrawFields, {}).count(), 0u);
    for (const BodyId body : {pair.a, pair.b})
        EXPECT_EQ(drawnOf(pair.world, kDrawFields, {&body, 1}).count(), 3u);
    FieldDefinition wind{.kind = FieldKind::Wind, .velocity = {1.0f, 0.0f}};
    wind.a = pair.a;
    ASSERT_TRUE(createField(pair.world, wind));
    EXPECT_EQ(drawnOf(pair.world, kDrawFields, {&pair.a, 1}).count(), 3u) << "only springs belong to bodies";
    const std::vector<std::uint8_t> chosen{0, 1};
    Recording recording;
    debugDraw(pair.world, recording, {.parts = kDrawFields, .selectedOnly = true, .fields = chosen});
    EXPECT_EQ(recording.count(), 1u);
    destroyField(pair.world, FieldId{0, pair.world.fields.all[0].generation});
    EXPECT_EQ(drawn(pair.world, kDrawFields).count(), 1u);
}

TEST(DebugGeometry, velocitiesAreDrawnForATenthOfASecondAndPathsInTwentySegments) {
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
    ASSERT_EQ(lines.size(), 40u) << "only dynamic bodies at least as fast as their sleep speed have lines";
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

TEST(DebugGeometry, invisibleBodiesAreOmittedAndSmallOnesDrawnAsBoxes) {
    World world;
    for (const double x : {0.0, 5.0, 9.0}) {
        const BodyId body = addBody(world, BodyKind::Static, {x, 0.0});
        static_cast<void>(createShape(world, body, circle(0.5f)));
    }
    const auto discs = [&](AABB sight, float minimum = 0.0f) {
        Recording recording;
        debugDraw(world, recording, {.parts = kDrawShapes, .sight = &sight, .minimum = minimum});
        return std::pair{recording.count(DebugRole::Fixed, 'c'), recording.count(DebugRole::Fixed, 'p')};
    };
    EXPECT_EQ(discs({{-1.0f, -1.0f}, {10.0f, 1.0f}}).first, 3u);
    EXPECT_EQ(discs({{1.0f, -1.0f}, {10.0f, 1.0f}}).first, 2u);
    EXPECT_EQ(discs({{1.0f, 3.0f}, {10.0f, 4.0f}}).first, 0u);
    EXPECT_EQ(discs({{-1.0f, -1.0f}, {10.0f, 1.0f}}, 0.9f), (std::pair<std::size_t, std::size_t>{3u, 0u}));
    EXPECT_EQ(discs({{-1.0f, -1.0f}, {10.0f, 1.0f}}, 2.0f), (std::pair<std::size_t, std::size_t>{0u, 3u}));
}

TEST(DebugGeometry, sweptShapesAreDrawnAtTheStartOfTheSweep) {
    World world;
    world.settings.gravity = {};
    const BodyId shot = addBody(world, BodyKind::Dynamic, {4.0, 1.0});
    static_cast<void>(createShape(world, shot, circle(0.1f)));
    const BodyId wall = addBody(world, BodyKind::Static, {50.0, 0.0});
    static_cast<void>(createShape(world, wall, box({0.05f, 5.0f})));
    ASSERT_TRUE(setVelocity(world, shot, {600.0f, 0.0f}));
    step(world, kTick);
    const Recording recording = drawn(world, kDrawSweeps);
    EXPECT_EQ(recording.count(DebugRole::Impact, 'c'), 0u);
    const auto strokes = strokesOf(recording, DebugRole::Sweep);
    ASSERT_EQ(strokes.size(), 3u);  // a disc, the line that shows its rotation, and the path
    expectLine(strokes[0], {4.0f, 1.0f}, {0.1f, 0.0f});
    expectLine(strokes[2], {4.0f, 1.0f}, {14.0f, 1.0f}, 1e-3f);
    EXPECT_EQ(drawnOf(world, kDrawSweeps, {&wall, 1}).count(), 0u);
    EXPECT_EQ(drawnOf(world, kDrawSweeps, {&shot, 1}).count(), 3u);
}

TEST(DebugGeometry, connectionsAreDrawnWithEitherSelectedBodyUntilDestroyed) {
    Random random = Random::seeded(5);
    Pair pair{random, {.kind = JointKind::Weld}};
    for (const BodyId body : {pair.a, pair.b})
        EXPECT_EQ(drawnOf(pair.world, kDrawJoints, {&body, 1}).count(DebugRole::Joint, 'c'), 1u);
    EXPECT_EQ(drawnOf(pair.world, kDrawJoints, {}).count(), 0u);
    destroyJoint(pair.world, JointId{0, pair.world.joints.hot[0].generation});
    EXPECT_EQ(drawn(pair.world, kDrawJoints | kDrawJointForces).count(), 0u);
}

TEST(DebugGeometry, sleepingBodiesAreFilledUpToEveryCorner) {
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
