#include "physics/debug_draw.hpp"

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "physics/shapes.hpp"
#include "scenes.hpp"

using namespace plumb;
using namespace plumb::physics;

namespace {

/// Counts what is drawn, by role and kind, and whether all of it can be drawn.
class Recording final : public DebugCanvas {
public:
    void line(Vec2 from, Vec2 to, DebugRole role) override { note(role, 'l', {from, to}); }
    void circle(Vec2 centre, float radius, DebugRole role) override {
        note(role, 'c', {centre, {radius, 0.0f}});
    }
    void polygon(std::span<const Vec2> corners, DebugRole role) override {
        note(role, 'p', {corners.begin(), corners.end()});
    }
    void arrow(Vec2 from, Vec2 to, DebugRole role) override { note(role, 'a', {from, to}); }
    void text(Vec2 at, std::string_view words, DebugRole role) override {
        note(role, 't', {at});
        EXPECT_FALSE(words.empty());
    }

    [[nodiscard]] std::size_t count(DebugRole role, char kind) const {
        const auto found = counts_.find({role, kind});
        return found != counts_.end() ? found->second : 0;
    }
    [[nodiscard]] std::size_t count() const {
        std::size_t all = 0;
        for (const auto& [key, number] : counts_) all += number;
        return all;
    }
    std::vector<Vec2> last;

private:
    void note(DebugRole role, char kind, std::vector<Vec2> points) {
        for (const Vec2 point : points) EXPECT_TRUE(isFinite(point));
        last = std::move(points);
        ++counts_[{role, kind}];
    }

    std::map<std::pair<DebugRole, char>, std::size_t> counts_;
};

Recording drawn(const World& world, unsigned parts, Place origin = {}) {
    Recording recording;
    debugDraw(world, recording, parts, origin);
    return recording;
}

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

TEST(DebugDraw, anEmptyWorldIsAnEmptyPicture) { EXPECT_EQ(drawn(World{}, kDrawAll).count(), 0u); }

TEST(DebugDraw, nothingAskedForIsNothingDrawn) { EXPECT_EQ(drawn(makePit(20, 1), 0).count(), 0u); }

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
    const Recording picture = drawn(world, kDrawShapes);
    EXPECT_EQ(picture.count(DebugRole::Fixed, 'p'), 1u);
    EXPECT_EQ(picture.count(DebugRole::Fixed, 'l'), 1u);
    EXPECT_EQ(picture.count(DebugRole::Driven, 'c'), 1u);
    EXPECT_EQ(picture.count(DebugRole::Awake, 'c'), 2u);
    EXPECT_EQ(picture.count(DebugRole::Awake, 'l'), 2u);
    EXPECT_EQ(picture.count(DebugRole::Asleep, 'c'), 4u);
    EXPECT_EQ(picture.count(DebugRole::Asleep, 'l'), 4u);
    EXPECT_EQ(picture.count(DebugRole::Trigger, 'p'), 1u);
    EXPECT_EQ(picture.count(), 16u);
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
        EXPECT_EQ(islands.count(DebugRole::Island, 'l') + islands.count(DebugRole::Island, 't'), 40u);
        EXPECT_GE(islands.count(DebugRole::Island, 't'), 1u);
    }
}

TEST(DebugDraw, velocitiesAndJointsAreWhereTheyAre) {
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
    EXPECT_EQ(drawn(world, kDrawJoints).count(DebugRole::Joint, 'l'), 3u);
}

TEST(DebugDraw, leavesTheWorldAsItWas) {
    World world = makePit(30, 3);
    for (int i = 0; i < 60; ++i) step(world, 1.0f / 60.0f);
    const std::uint64_t before = hashOf(world);
    EXPECT_GT(drawn(world, kDrawAll).count(), 200u);
    EXPECT_EQ(hashOf(world), before);
}
