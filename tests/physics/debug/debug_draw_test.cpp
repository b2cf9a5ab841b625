#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "physics/model/fields.hpp"
#include "physics/model/shapes.hpp"
#include "physics/queries/ray_cast.hpp"
#include "physics/soft/softbody.hpp"
#include "physics/workspace.hpp"
#include "tests/physics/support/recording_canvas.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

using namespace plumb;
using namespace plumb::physics;

namespace {

struct Points {
    std::size_t all = 0;
    std::size_t pushing = 0;
};

void count(Points& points, const Contact& contact) {
    if ((contact.flags & kTouching) == 0) return;
    points.all += contact.count;
    points.pushing +=
        (contact.impulse0 != 0.0f ? 1u : 0u) + (contact.count > 1 && contact.impulse1 != 0.0f ? 1u : 0u);
}

Points pointsOf(const World& world) {
    Points points;
    for (const Contact& contact : world.contacts) count(points, contact);
    for (const SleepingIsland& island : world.sleepers.islands) {
        for (std::uint32_t c = island.firstContact; c != kNone; c = world.sleepers.nextContact[c])
            count(points, world.sleepers.contacts[c]);
    }
    return points;
}

}  // namespace

TEST(DebugDraw, anEmptyWorldDrawsNothing) {
    World world;
    EXPECT_EQ(drawn(world, kDrawAll).count(), 0u);
}

TEST(DebugDraw, noRequestedPartsDrawNothing) {
    World world = makePit(20, 1);
    EXPECT_EQ(drawn(world, 0).count(), 0u);
}

TEST(DebugDraw, everyShapeIsDrawnInItsRole) {
    World world;
    const auto add = [&](BodyKind kind, const Geometry& geometry, bool trigger = false) {
        const BodyId body = addBody(world, kind, {});
        static_cast<void>(createShape(world, body, geometry, {.isTrigger = trigger}));
        return body;
    };
    add(BodyKind::Static, box({1.0f, 1.0f}));
    add(BodyKind::Static, segment({}, {1.0f, 0.0f}));
    add(BodyKind::Kinematic, circle(1.0f));
    add(BodyKind::Dynamic, capsule({}, {1.0f, 0.0f}, 0.5f));
    const BodyId asleep = add(BodyKind::Dynamic, box({1.0f, 1.0f}, {5.0f, 0.0f}, {}, 0.1f));
    setAwake(world, asleep, false);
    add(BodyKind::Dynamic, box({1.0f, 1.0f}), true);
    const BodyId gone = add(BodyKind::Dynamic, circle(1.0f));
    destroyBody(world, gone);
    const Recording recording = drawn(world, kDrawShapes);
    EXPECT_EQ(recording.count(DebugRole::Fixed, 'p'), 1u);
    EXPECT_EQ(recording.count(DebugRole::Fixed, 'l'), 1u);
    EXPECT_EQ(recording.count(DebugRole::Driven, 'c'), 1u);
    EXPECT_EQ(recording.count(DebugRole::Driven, 'l'), 1u);  // radius that shows the circle's rotation
    EXPECT_EQ(recording.count(DebugRole::Awake, 'p'), 1u);
    EXPECT_EQ(recording.count(DebugRole::Asleep, 'p'), 1u);
    EXPECT_EQ(recording.count(), 6u);
    EXPECT_EQ(drawn(world, kDrawTriggers).count(DebugRole::Trigger, 'p'), 1u);
    EXPECT_EQ(drawn(world, kDrawTriggers).count(), 1u);
    EXPECT_EQ(drawn(world, kDrawBounds).count(DebugRole::Bounds, 'p'), 6u);
    EXPECT_EQ(drawn(world, kDrawBroadPhase).count(DebugRole::BroadPhase, 'p'), 6u);
}

TEST(DebugDraw, everyContactPointIsDrawnAwakeAndAsleep) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        World world = makePit(40, seed);
        world.settings.sleepTime = 0.1f;
        for (int i = 0; i < 40 + 20 * static_cast<int>(seed); ++i) step(world, 1.0f / 60.0f);
        const Points points = pointsOf(world);
        ASSERT_GT(points.all, 20u);
        EXPECT_EQ(drawn(world, kDrawContacts).count(DebugRole::Contact, 'c'), points.all);
        EXPECT_EQ(drawn(world, kDrawNormals).count(DebugRole::Normal, 'a'), points.all);
        EXPECT_EQ(drawn(world, kDrawImpulses).count(DebugRole::Impulse, 'a'), points.pushing);
        EXPECT_EQ(drawn(world, kDrawCentres).count(DebugRole::Centre, 'c'), 40u);
        const Recording islands = drawn(world, kDrawIslands);
        EXPECT_EQ(islands.count(DebugRole::Island, 'p') + islands.count(DebugRole::Island, 'c'), 40u);
    }
}

TEST(DebugDraw, velocitiesAndJointsAreDrawnAtTheirPositions) {
    World world;
    world.settings.gravity = {};
    const BodyId a = addBody(world, BodyKind::Dynamic, {1000000.0, 2.0}),
                 b = addBody(world, BodyKind::Static, {});
    static_cast<void>(createShape(world, a, circle(0.5f)));
    ASSERT_TRUE(setVelocity(world, a, {3.0f, 0.0f}));
    const Recording arrows = drawn(world, kDrawVelocities, {1000000.0, 0.0});
    ASSERT_EQ(arrows.count(DebugRole::Velocity, 'a'), 1u);
    EXPECT_EQ(arrows.last[0], (Vec2{0.0f, 2.0f}));
    EXPECT_EQ(arrows.last[1].y, 2.0f);
    EXPECT_GT(arrows.last[1].x, 0.0f);
    ASSERT_TRUE(createJoint(world, {.a = a, .b = b}));
    EXPECT_EQ(drawn(world, kDrawJoints).count(DebugRole::Joint, 'c'), 1u);
    // One line from the centre of a to its anchor, one between the anchors; none for b, as it is static.
    EXPECT_EQ(drawn(world, kDrawJoints).count(DebugRole::Joint, 'l'), 2u);
}

TEST(DebugDraw, doesNotChangeTheWorld) {
    World world = makePit(30, 3);
    for (int i = 0; i < 60; ++i) step(world, 1.0f / 60.0f);
    const std::uint64_t before = hashOf(world);
    EXPECT_GT(drawn(world, kDrawAll).count(), 200u);
    EXPECT_EQ(hashOf(world), before);
}

TEST(DebugDraw, outlinesOfRoundedShapesAreAtTheirRadius) {
    World world;
    const BodyId body = addBody(world, BodyKind::Static, {});
    static_cast<void>(createShape(world, body, capsule({-1.0f, 0.0f}, {1.0f, 0.0f}, 0.5f)));
    const Recording recording = drawn(world, kDrawShapes);
    ASSERT_GE(recording.last.size(), 16u);
    float area = 0.0f;
    for (std::size_t i = 0; i < recording.last.size(); ++i) {
        const Vec2 point = recording.last[i], next = recording.last[(i + 1) % recording.last.size()];
        const Vec2 nearest{std::clamp(point.x, -1.0f, 1.0f), 0.0f};
        EXPECT_NEAR(length(point - nearest), 0.5f, 1e-6f);
        area += 0.5f * (point.x * next.y - point.y * next.x);
    }
    // a rectangle of 2 m2 and two half circles
    EXPECT_NEAR(std::fabs(area), 2.0f + 0.25f * 3.1415927f, 0.03f);
}

TEST(DebugDraw, eachIslandHasItsOwnColour) {
    World world;
    world.settings.gravity = {0.0f, -10.0f};
    const BodyId floor = addBody(world, BodyKind::Static, {});
    static_cast<void>(createShape(world, floor, box({20.0f, 0.5f})));
    for (const double x : {-5.0, 5.0}) {
        for (const double y : {1.0, 2.0}) {
            const BodyId body = addBody(world, BodyKind::Dynamic, {x, y});
            static_cast<void>(createShape(world, body, box({0.5f, 0.5f})));
        }
    }
    for (int i = 0; i < 120; ++i) {
        step(world, 1.0f / 60.0f);
        if (i < 10) continue;
        const std::vector<std::uint32_t> islands = drawn(world, kDrawIslands).islands;
        ASSERT_EQ(islands.size(), 4u);
        EXPECT_EQ(islands[0], islands[1]);
        EXPECT_EQ(islands[2], islands[3]);
        EXPECT_NE(islands[0], islands[2]);
    }
    EXPECT_TRUE(world.awake.empty());  // all islands sleep now, so both awake and sleeping ones were drawn
}

TEST(DebugDraw, theArrowOfAnImpulseIsProportionalToTheLoad) {
    World world;
    world.settings.gravity = {0.0f, -10.0f};
    const BodyId floor = addBody(world, BodyKind::Static, {});
    static_cast<void>(createShape(world, floor, box({20.0f, 0.5f})));
    for (const double y : {1.0, 2.0, 3.0}) {
        const BodyId body = addBody(world, BodyKind::Dynamic, {0.0, y});
        static_cast<void>(createShape(world, body, box({0.5f, 0.5f})));
    }
    world.settings.sleepTime = 1e6f;
    for (int i = 0; i < 300; ++i) step(world, 1.0f / 60.0f);
    Recording recording = drawn(world, kDrawImpulses);
    ASSERT_EQ(recording.arrows.size(), 6u);
    // Two contact points below each box share the weight of the boxes above: three, two or one.
    std::sort(recording.arrows.begin(), recording.arrows.end());
    const float weight = recording.arrows[0];
    EXPECT_GT(weight, 0.01f);
    EXPECT_NEAR(recording.arrows[2], 2.0f * weight, 0.1f * weight);
    EXPECT_NEAR(recording.arrows[4], 3.0f * weight, 0.1f * weight);
}

TEST(DebugDraw, anImpulseIsThatOfTheWholeStepAtAnyQuality) {
    for (const Quality quality : {Quality{0}, Quality{2}, Quality{5}}) {
        SCOPED_TRACE(int{quality});
        Playground scene;
        scene.floor();
        scene.crate({0.0, 0.5});
        // The second crate has its own quality, so its island is solved in another group.
        ASSERT_TRUE(setQuality(scene.world, scene.crate({5.0, 0.5}), quality).ok());
        scene.world.settings.quality = 0;
        scene.run(120);
        const auto isAsLongAsALoad = [](const Recording& recording) {
            ASSERT_EQ(recording.arrows.size(), 4u);
            for (std::size_t i = 0; i < 4; i += 2)
                EXPECT_NEAR(recording.arrows[i] + recording.arrows[i + 1], 0.2f, 0.002f);
        };
        isAsLongAsALoad(drawn(scene.world, kDrawImpulses));
        scene.world.settings.sleeping = true;
        scene.run(120);
        ASSERT_TRUE(scene.world.awake.empty());
        isAsLongAsALoad(drawn(scene.world, kDrawImpulses));
        World copied = scene.world;  // a copy has no data of the last step
        isAsLongAsALoad(drawn(copied, kDrawImpulses));
    }
}

TEST(DebugDraw, theArrowOfAnImpulseDoesNotDependOnTheTimeStep) {
    for (const float dt : {1.0f / 30.0f, 1.0f / 60.0f, 1.0f / 240.0f}) {
        SCOPED_TRACE(dt);
        Playground scene;
        scene.floor();
        scene.crate({0.0, 0.5});
        for (float time = 0.0f; time < 2.0f; time += dt) step(scene.world, dt);
        const Recording recording = drawn(scene.world, kDrawImpulses);
        ASSERT_EQ(recording.arrows.size(), 2u);
        EXPECT_NEAR(recording.arrows[0] + recording.arrows[1], 0.2f, 0.002f);  // 0.02 m per m/s2
        World copied = scene.world;
        EXPECT_EQ(drawn(copied, kDrawImpulses).arrows, recording.arrows);
    }
}

TEST(DebugDraw, frictionIsDrawnAlongASlope) {
    const float slope = 0.3f;  // rad
    World world;
    world.settings.sleeping = false;
    const BodyId ground = addBody(world, BodyKind::Static, {});
    const Rot rotation = rotFromAngle(slope);
    static_cast<void>(createShape(world, ground, box({10.0f, 0.5f}, {}, rotation)));
    BodyDefinition lies;
    lies.position = WorldPosition{rotate(rotation, {0.0f, -1.0f})};
    lies.angle = slope;
    const BodyId body = *createBody(world, lies);
    static_cast<void>(createShape(world, body, box({0.5f, 0.5f})));
    for (int i = 0; i < 120; ++i) step(world, 1.0f / 60.0f);
    const auto holds = strokesOf(drawn(world, kDrawFriction), DebugRole::Friction);
    const auto pushes = strokesOf(drawn(world, kDrawImpulses), DebugRole::Impulse);
    ASSERT_EQ(holds.size(), 1u);
    ASSERT_EQ(pushes.size(), 2u);
    const Vec2 along = holds[0].points[1] - holds[0].points[0];
    const Vec2 uphill = rotate(rotation, {-1.0f, 0.0f});
    EXPECT_NEAR(dot(normalized(along), uphill), 1.0f, 1e-3f);
    float pushed = 0.0f;
    for (const Stroke& push : pushes) pushed += length(push.points[1] - push.points[0]);
    EXPECT_NEAR(length(along) / pushed, std::tan(slope), 0.02f);
    // The component of gravity along the normal is drawn with 0.02 m per m/s2.
    EXPECT_NEAR(pushed, 0.2f * std::cos(slope), 0.01f);
}

TEST(DebugDraw, bodiesAreInterpolatedBetweenSteps) {
    World world;
    world.settings.gravity = {};
    const BodyId body = addBody(world, BodyKind::Dynamic, {2.0, 3.0}),
                 fixed = addBody(world, BodyKind::Static, {0.0, 9.0});
    for (const BodyId one : {body, fixed}) static_cast<void>(createShape(world, one, box({0.5f, 0.5f})));
    ASSERT_TRUE(setVelocity(world, body, {6.0f, -3.0f}));
    ASSERT_TRUE(setAngularVelocity(world, body, 3.0f));
    const auto boxes = [&](float behind) {
        Recording recording;
        debugDraw(world, recording, {.parts = kDrawShapes, .behind = behind});
        return recording.strokes;
    };
    const auto before = boxes(0.0f);
    step(world, 1.0f / 60.0f);
    const auto after = boxes(0.0f), seen = boxes(1.0f / 60.0f);
    ASSERT_EQ(seen.size(), 2u);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        for (std::size_t corner = 0; corner < 4; ++corner)
            EXPECT_LT(length(seen[i].points[corner] - before[i].points[corner]), 1e-4f);
    }
    EXPECT_GT(length(after[0].points[0] - before[0].points[0]), 0.05f);
    EXPECT_EQ(after[1].points, before[1].points);
}

TEST(DebugDraw, aPredictedPathEndsWhereAThrownBodyIsOneSecondLater) {
    World world;
    const BodyId body = addBody(world, BodyKind::Dynamic, {500000.0, 3.0});
    static_cast<void>(createShape(world, body, circle(0.2f)));
    ASSERT_TRUE(setVelocity(world, body, {4.0f, -6.0f}));
    const Recording recording = drawn(world, kDrawPaths, {500000.0, 0.0});
    const auto path = strokesOf(recording, DebugRole::Path);
    ASSERT_GE(path.size(), 10u);
    EXPECT_EQ(path.front().points[0], (Vec2{0.0f, 3.0f}));
    // Parabola: x = 4 t, y = 3 - 6 t + 5 t2.
    EXPECT_NEAR(path.back().points[1].x, 4.0f, 1e-4f);
    EXPECT_NEAR(path.back().points[1].y, 2.0f, 1e-4f);
    for (int i = 0; i < 60; ++i) step(world, 1.0f / 60.0f);
    EXPECT_NEAR(positionOf(world, body).x, 500004.0, 1e-3);
    EXPECT_NEAR(positionOf(world, body).y, 2.0, 1e-2);
}

TEST(DebugDraw, aPredictedPathIncludesDrag) {
    World world;
    const BodyId body = *createBody(world, {.velocity = {4.0f, -6.0f}, .linearDrag = 3.0f});
    static_cast<void>(createShape(world, body, circle(0.2f)));
    const Vec2 end = strokesOf(drawn(world, kDrawPaths), DebugRole::Path).back().points[1];
    for (int i = 0; i < 60; ++i) step(world, 1.0f / 60.0f);
    EXPECT_NEAR(length(toVec2(positionOf(world, body)) - end), 0.0f, 1e-3f);
}

TEST(DebugDraw, aTriggerIsConnectedToTheBodiesInside) {
    World world;
    world.settings.gravity = {};
    const BodyId area = addBody(world, BodyKind::Static, {});
    static_cast<void>(createShape(world, area, box({1.0f, 1.0f}), {.isTrigger = true}));
    const BodyId inside = addBody(world, BodyKind::Dynamic, {0.5, 0.25}),
                 outside = addBody(world, BodyKind::Dynamic, {5.0, 0.0});
    for (const BodyId body : {inside, outside}) static_cast<void>(createShape(world, body, circle(0.1f)));
    step(world, 1.0f / 60.0f);
    const auto ties = strokesOf(drawn(world, kDrawTriggers), DebugRole::Visitor);
    ASSERT_EQ(ties.size(), 1u);
    EXPECT_EQ(ties[0].points, (std::vector<Vec2>{{0.0f, 0.0f}, {0.5f, 0.25f}}));
    EXPECT_EQ(drawn(world, kDrawContacts).count(), 0u) << "a contact with a trigger has no points";
}

TEST(DebugDraw, theSweptPathAndTheHitOfAFastBodyAreDrawn) {
    World world;
    world.settings.gravity = {};
    const BodyId wall = addBody(world, BodyKind::Static, {5.0, 0.0});
    static_cast<void>(createShape(world, wall, box({0.05f, 5.0f})));
    const BodyId shot = addBody(world, BodyKind::Dynamic, {4.0, 0.0});
    static_cast<void>(createShape(world, shot, circle(0.1f)));
    ASSERT_TRUE(setVelocity(world, shot, {600.0f, 0.0f}));
    step(world, 1.0f / 60.0f);
    const Recording recording = drawn(world, kDrawSweeps);
    const auto stops = strokesOf(recording, DebugRole::Impact);
    ASSERT_EQ(stops.size(), 1u);
    EXPECT_NEAR(stops[0].points[0].x, 4.85f, 1e-2f);
    const auto ways = strokesOf(recording, DebugRole::Sweep);
    ASSERT_EQ(ways.back().kind, 'l');
    EXPECT_EQ(ways.back().points[0], stops[0].points[0]) << "the path after the hit begins at the hit";
    EXPECT_NEAR(ways.back().points[1].x, 4.85f, 1e-2f) << "the body does not bounce";
    ASSERT_TRUE(setVelocity(world, shot, {0.1f, 0.0f}));
    step(world, 1.0f / 60.0f);
    EXPECT_EQ(drawn(world, kDrawSweeps).count(), 0u) << "slow bodies are not swept";
}

TEST(DebugDraw, theSleepTimerOfARestingBodyIsDrawn) {
    World world;
    const BodyId ground = addBody(world, BodyKind::Static, {});
    static_cast<void>(createShape(world, ground, box({5.0f, 0.5f})));
    const BodyId body = addBody(world, BodyKind::Dynamic, {0.0, -1.0});
    static_cast<void>(createShape(world, body, box({0.5f, 0.5f})));
    float before = 0.0f;
    for (int i = 0; i < 90; ++i) {
        step(world, 1.0f / 60.0f);
        const auto rests = strokesOf(drawn(world, kDrawRest), DebugRole::Rest);
        if (rests.empty()) continue;
        const float width = rests[0].points[2].x - rests[0].points[0].x;
        const float part =
            world.awake.empty() ? 1.0f : world.bodies.motion[body.index].restTime / world.settings.sleepTime;
        EXPECT_NEAR(std::fabs(width), part, 1e-3f);
        EXPECT_GE(std::fabs(width), before - 1e-3f);
        before = std::fabs(width);
    }
    EXPECT_TRUE(world.awake.empty());
    EXPECT_EQ(before, 1.0f);
}

TEST(DebugDraw, theRegionsOfEveryBroadPhaseContainAllBoxes) {
    for (const BroadPhaseKind kind : {BroadPhaseKind::Tree, BroadPhaseKind::Grid,
                                      BroadPhaseKind::SweepAndPrune, BroadPhaseKind::Quadtree}) {
        SCOPED_TRACE(nameOf(kind));
        World world = makePit(300, 5);
        world.settings.broadPhase = kind;
        for (int i = 0; i < 30; ++i) step(world, 1.0f / 60.0f);
        const Recording recording = drawn(world, kDrawBroadPhase);
        const auto regions = strokesOf(recording, DebugRole::Region);
        ASSERT_GT(regions.size(), 0u);
        std::size_t outside = 0;
        for (const Stroke& box : strokesOf(recording, DebugRole::BroadPhase)) {
            const Vec2 middle = (box.points[0] + box.points[2]) * 0.5f;
            const bool isHeld = std::any_of(regions.begin(), regions.end(), [&](const Stroke& region) {
                // A grid cell contains a corner of the box of each proxy in it, a quadtree square its middle.
                return std::any_of(box.points.begin(), box.points.end(),
                                   [&](Vec2 corner) {
                                       return contains({region.points[0], region.points[2]}, corner);
                                   }) ||
                       contains({region.points[0], region.points[2]}, middle);
            });
            if (!isHeld) ++outside;
        }
        // Grid and sweep-and-prune store some proxies separately: very large ones and newly added ones.
        const bool hasStrays = kind == BroadPhaseKind::Grid || kind == BroadPhaseKind::SweepAndPrune;
        EXPECT_LE(outside, hasStrays ? 30u : 0u);
    }
}

TEST(DebugDraw, anOverwrittenWorldHasNoLastStepUntilTheNextOne) {
    const World crowd = makePit(60, 2);
    World world = makePit(3, 1);
    ASSERT_TRUE(setQuality(world, {1, 1}, 4));  // two qualities, so two groups of islands
    for (int i = 0; i < 60; ++i) step(world, 1.0f / 60.0f);
    EXPECT_NE(lastStepOf(world), nullptr);
    EXPECT_GT(detectionOf(world).touching, 0);
    World later = crowd;
    for (int i = 0; i < 60; ++i) step(later, 1.0f / 60.0f);
    world = later;
    // The query overwrites a part of the workspace.
    static_cast<void>(castRay(world, {0.0, 50.0}, {0.0f, -60.0f}));
    EXPECT_EQ(lastStepOf(world), nullptr);
    EXPECT_EQ(detectionOf(world).touching, 0);
    World copy = world;
    EXPECT_EQ(strokesOf(drawn(world, kDrawAll), DebugRole::Sweep).size(), 0u);
    EXPECT_EQ(drawn(world, kDrawImpulses).strokes.size(), drawn(copy, kDrawImpulses).strokes.size());
    step(world, 1.0f / 60.0f);
    EXPECT_NE(lastStepOf(world), nullptr);
    World moved = std::move(world);
    EXPECT_NE(lastStepOf(moved), nullptr);
    EXPECT_EQ(lastStepOf(world), nullptr);  // NOLINT(bugprone-use-after-move)
}

TEST(DebugDraw, fieldsShowTheirRegionAndTheirBodies) {
    World world;
    const BodyId body = addBody(world, BodyKind::Dynamic, {3.0, 0.0});
    static_cast<void>(createShape(world, body, circle(0.5f)));
    FieldDefinition wind{.kind = FieldKind::Wind, .region = RegionKind::Box, .place = {1.0, 2.0}};
    wind.half = {2.0f, 1.0f};
    wind.velocity = {5.0f, 0.0f};
    ASSERT_TRUE(createField(world, wind));
    Recording recording = drawn(world, kDrawFields);
    auto strokes = strokesOf(recording, DebugRole::Field);
    ASSERT_EQ(strokes.size(), 2u);
    EXPECT_EQ(strokes[0].points,
              (std::vector<Vec2>{{-1.0f, 1.0f}, {3.0f, 1.0f}, {3.0f, 3.0f}, {-1.0f, 3.0f}}));
    EXPECT_EQ(strokes[1].kind, 'a');
    EXPECT_EQ(strokes[1].points, (std::vector<Vec2>{{0.5f, 2.0f}, {1.5f, 2.0f}}));
    ASSERT_TRUE(
        createField(world, {.kind = FieldKind::Spring, .place = {3.0, -2.0}, .strength = 5.0f, .a = body}));
    const std::vector<BodyId> chosen{body};
    strokes = strokesOf(drawnOf(world, kDrawFields, chosen), DebugRole::Field);
    ASSERT_EQ(strokes.size(), 3u) << "if one body is selected, only its spring is drawn";
    EXPECT_EQ(strokes[0].points, (std::vector<Vec2>{{3.0f, 0.0f}, {3.0f, -2.0f}}));
}

TEST(DebugDraw, aRopeIsDrawnLinkByLink) {
    World world;
    ASSERT_TRUE(createRope(world, {0.0, 0.0}, {1.0, 0.0}, 5));
    std::size_t links = 0;
    for (const SoftBody& soft : world.softBodies.all) links += soft.links.size();
    const Recording recording = drawn(world, kDrawShapes);
    EXPECT_EQ(recording.count(DebugRole::Soft, 'l'), links);
    EXPECT_GE(links, 4u);
}

TEST(DebugDraw, onlySelectedSoftBodiesAreDrawn) {
    World world;
    const SoftBodyId ropes[] = {*createRope(world, {0.0, 0.0}, {1.0, 0.0}, 5),
                                *createRope(world, {0.0, 2.0}, {1.0, 2.0}, 8)};
    for (const SoftBodyId rope : ropes) {
        // The flags end after the selected body, so for the first one they are fewer than the soft bodies.
        std::vector<std::uint8_t> chosen(rope.index + 1);
        chosen[rope.index] = 1;
        Recording recording;
        debugDraw(world, recording, {.parts = kDrawShapes, .selectedOnly = true, .softBodies = chosen});
        EXPECT_EQ(recording.count(), softBodyOf(world, rope).links.size());
        EXPECT_EQ(recording.last.back().y, static_cast<float>(particlesOf(world, rope)[0].place.y));
    }
    Recording none;
    debugDraw(world, none, {.parts = kDrawShapes, .selectedOnly = true});
    EXPECT_EQ(none.count(), 0u);
}

TEST(DebugDraw, onlyPartsOfSelectedBodiesAreDrawn) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        SCOPED_TRACE(seed);
        World world = makePit(40, seed);
        for (int i = 0; i < 60; ++i) step(world, 1.0f / 60.0f);
        std::vector<BodyId> bodies;
        for (std::uint32_t i = 0; i < world.bodies.size(); ++i)
            bodies.push_back({i, world.bodies.info[i].generation});
        for (unsigned bit = 1; bit < kDrawAll; bit <<= 1) {
            SCOPED_TRACE(bit);
            const Recording all = drawn(world, bit);
            EXPECT_EQ(drawnOf(world, bit, {}).count(), 0u);
            EXPECT_EQ(drawnOf(world, bit, bodies).count(), all.count() - all.count(DebugRole::Region, 'p'));
        }
        std::size_t shapes = 0;
        for (const BodyId& body : bodies) shapes += drawnOf(world, kDrawShapes, {&body, 1}).count();
        EXPECT_EQ(shapes, drawn(world, kDrawShapes).count());
    }
}
