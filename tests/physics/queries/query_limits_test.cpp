#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "physics/measure/snapshot.hpp"
#include "physics/queries/overlap.hpp"
#include "physics/queries/ray_cast.hpp"
#include "physics/queries/shape_cast.hpp"
#include "physics/ranges.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

// Queries with equal distances, shapes that only touch, and values at the ends of ranges; damaged snapshots.

using namespace plumb;
using namespace plumb::physics;

namespace {

/// Adds discs, each on a body of its own.
std::vector<ShapeId> addDiscs(World& world, std::initializer_list<WorldPosition> places, float radius,
                              const ShapeDefinition& definition = {}) {
    std::vector<ShapeId> made;
    for (const WorldPosition place : places)
        made.push_back(
            *createShape(world, addBody(world, BodyKind::Static, place), circle(radius), definition));
    return made;
}

}  // namespace

TEST(QueryLimits, theFirstOfEquallyNearShapesIsFound) {
    for (int kind = 0; kind < static_cast<int>(BroadPhaseKind::Count); ++kind) {
        World world;
        world.settings.broadPhase = static_cast<BroadPhaseKind>(kind);
        const auto discs = addDiscs(world, {{5.0, 0.0}, {5.0, 0.0}, {5.0, 0.0}, {-5.0, 0.0}}, 1.0f);
        EXPECT_EQ(castRay(world, {}, {9.0f, 0.0f})->shape, discs[0]);
        EXPECT_EQ(castShape(world, {.geometry = circle(0.5f)}, {9.0f, 0.0f})->shape, discs[0]);
        EXPECT_EQ(closestPoint(world, {}, 9.0f)->shape, discs[0]);
        EXPECT_EQ(closestPoint(world, {0.0, 0.0}, 9.0f)->body, bodyOf(world, discs[0]));
        std::vector<CastHit> hits;
        castRayAll(world, {}, {9.0f, 0.0f}, {}, hits);
        ASSERT_EQ(hits.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(hits[i].shape, discs[i]);
        castShapeAll(world, {.geometry = circle(0.5f)}, {9.0f, 0.0f}, {}, hits);
        ASSERT_EQ(hits.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(hits[i].shape, discs[i]);
    }
}

TEST(QueryLimits, touchingCountsAsOverlapAndRangesIncludeTheirEnd) {
    World world;
    const ShapeId square =
        *createShape(world, addBody(world, BodyKind::Static, {2.0, 0.0}), box({1.0f, 1.0f}));
    std::vector<ShapeId> found;
    overlapBox(world, {0.0, -0.5}, {1.0, 0.5}, {}, found);
    EXPECT_EQ(found, std::vector{square});
    overlapBox(world, {0.0, -0.5}, {0.99, 0.5}, {}, found);
    EXPECT_TRUE(found.empty());
    overlapCircle(world, {0.0, 0.0}, 1.0f, {}, found);
    EXPECT_EQ(found, std::vector{square});
    overlapCircle(world, {0.0, 0.0}, 0.99f, {}, found);
    EXPECT_TRUE(found.empty());
    for (const double x : {1.001, 2.0, 2.999}) {
        overlapPoint(world, {x, 0.5}, {}, found);
        EXPECT_EQ(found, std::vector{square});
    }
    overlapPoint(world, {0.999, 0.0}, {}, found);
    EXPECT_TRUE(found.empty());
    EXPECT_TRUE(closestPoint(world, {0.0, 0.0}, 1.0f).has_value());
    EXPECT_FALSE(closestPoint(world, {0.0, 0.0}, std::nextafter(1.0f, 0.0f)).has_value());
    EXPECT_TRUE(closestPoint(world, {2.0, 0.0}, 0.0f).has_value()) << "inside";
    EXPECT_FALSE(closestPoint(world, {2.0, 0.0}, -1.0e-6f).has_value());
    EXPECT_TRUE(castRay(world, {}, {1.0f, 0.0f}).has_value()) << "the ray ends on the surface";
    EXPECT_FALSE(castRay(world, {}, {0.999f, 0.0f}).has_value());
    ASSERT_TRUE(castRay(world, {}, {2.0f, 2.0f}).has_value()) << "the ray touches only a corner";
    EXPECT_EQ(castRay(world, {}, {2.0f, 2.0f})->fraction, 0.5f);
    EXPECT_FALSE(castRay(world, {}, {2.0f, 2.001f}).has_value());
}

TEST(QueryLimits, boxesLargerThanAnyShapeAreSearched) {
    const double far = 3.0 * static_cast<double>(kLargest);
    for (int kind = 0; kind < static_cast<int>(BroadPhaseKind::Count); ++kind) {
        World world;
        world.settings.broadPhase = static_cast<BroadPhaseKind>(kind);
        const auto discs = addDiscs(world, {{0.0, 0.0}, {far, 0.0}, {0.0, -far}, {5.0, 5.0}}, 1.0f);
        std::vector<ShapeId> found;
        overlapBox(world, {-kFarthest, -kFarthest}, {kFarthest, kFarthest}, {}, found);
        EXPECT_EQ(found, discs) << kind;
        overlapBox(world, {-0.5 * far, -10.0}, {far, 10.0}, {}, found);
        EXPECT_EQ(found, (std::vector{discs[0], discs[1], discs[3]})) << kind;
        overlapBox(world, {-far, 100.0}, {far, 200.0}, {}, found);
        EXPECT_TRUE(found.empty()) << kind;
        overlapBox(world, {-far, 10.0}, {far, -10.0}, {}, found);
        EXPECT_TRUE(found.empty()) << "no box";
        overlapBox(world, {-2.0 * kFarthest, -1.0}, {far, 1.0}, {}, found);
        EXPECT_TRUE(found.empty()) << "out of range";
    }
}

TEST(QueryLimits, layersAreMatchedBothWaysAndAStaleBodyExcludesNothing) {
    World world;
    const auto seen = addDiscs(world, {{3.0, 0.0}}, 1.0f, {.layers = 2, .mask = 4});
    const BodyId body = bodyOf(world, seen[0]);
    const auto hits = [&](const QueryFilter& filter) {
        return isRayBlocked(world, {}, {9.0f, 0.0f}, filter);
    };
    EXPECT_TRUE(hits({.layers = 4, .mask = 2}));
    EXPECT_TRUE(hits({.layers = 7, .mask = 7}));
    EXPECT_FALSE(hits({.layers = 3, .mask = 2}));
    EXPECT_FALSE(hits({.layers = 4, .mask = 5}));
    EXPECT_FALSE(hits({.except = body}));
    EXPECT_TRUE(hits({.except = {body.index, body.generation + 1}}));
    EXPECT_TRUE(hits({.except = {body.index + 1, body.generation}}));
    EXPECT_TRUE(hits({.movers = false}));
    EXPECT_FALSE(hits({.fixed = false}));
}

TEST(QueryLimits, positionsUpToTheFarthestAreSupported) {
    for (const double end : {-kFarthest, kFarthest}) {
        for (const bool vertical : {false, true}) {
            World world;
            const auto at = [&](double along) {
                return vertical ? WorldPosition{0.0, along} : WorldPosition{along, 0.0};
            };
            addDiscs(world, {at(end)}, 1000.0f);
            std::vector<ShapeId> found;
            const double beyond = std::nextafter(end, 2.0 * end);
            overlapPoint(world, at(end), {}, found);
            EXPECT_EQ(found.size(), 1u);
            overlapPoint(world, at(beyond), {}, found);
            EXPECT_TRUE(found.empty());
            EXPECT_TRUE(castRay(world, at(end), {1.0f, 1.0f}).has_value());
            EXPECT_FALSE(castRay(world, at(beyond), {1.0f, 1.0f}).has_value());
            overlapCircle(world, at(end), 1.0f, {}, found);
            EXPECT_EQ(found.size(), 1u);
            overlapCircle(world, at(beyond), 1.0f, {}, found);
            EXPECT_TRUE(found.empty());
        }
    }
    World world;
    addDiscs(world, {{0.0, 0.0}}, 1.0f);
    constexpr auto kEnd = static_cast<float>(kFarthest);
    for (const float side : {-1.0f, 1.0f}) {
        const float beyond = std::nextafter(kEnd, 2.0f * kEnd);
        EXPECT_TRUE(castRay(world, {}, {side * kEnd, 0.0f}).has_value());
        EXPECT_TRUE(castRay(world, {}, {0.0f, side * kEnd}).has_value());
        EXPECT_FALSE(castRay(world, {}, {side * beyond, 0.0f}).has_value());
        EXPECT_FALSE(castRay(world, {}, {0.0f, side * beyond}).has_value());
    }
    EXPECT_TRUE(closestPoint(world, {}, kEnd).has_value());
    EXPECT_FALSE(closestPoint(world, {}, std::nextafter(kEnd, 2.0f * kEnd)).has_value());
    for (const float turn : {0.9996f, 1.0004f}) {
        std::vector<ShapeId> found;
        overlapShape(world, {.geometry = circle(1.0f), .rotation = {turn, 0.0f}}, {}, found);
        EXPECT_EQ(found.size(), 1u);
    }
    for (const float turn : {0.999f, 1.001f, 0.0f}) {
        std::vector<ShapeId> found;
        overlapShape(world, {.geometry = circle(1.0f), .rotation = {turn, 0.0f}}, {}, found);
        EXPECT_TRUE(found.empty()) << turn;
    }
}

TEST(Snapshot, withAnyMissingOrChangedByteIsRejected) {
    World world = makePit(3, 1);
    static_cast<void>(createJoint(world, {.a = {1, 1}, .b = {2, 1}}));
    for (int i = 0; i < 20; ++i) step(world, kTick);
    const std::vector<std::uint8_t> bytes = toBytes(world);
    const auto copy = worldFrom(bytes);
    ASSERT_TRUE(copy.ok());
    EXPECT_EQ(hashOf(*copy), hashOf(world));
    EXPECT_GT(stateBytes(world), sizeof(World));
    std::size_t taken = 0;
    for (std::size_t i = 0; i < bytes.size(); i += 1 + i / 64) {
        std::vector<std::uint8_t> spoiled = bytes;
        spoiled[i] ^= static_cast<std::uint8_t>(1u << (i % 8));
        taken += worldFrom(spoiled).ok() ? 1 : 0;
        taken += worldFrom(std::span{bytes}.first(i)).ok() ? 1 : 0;
    }
    EXPECT_EQ(taken, 0u);
    std::vector<std::uint8_t> longer = bytes;
    longer.push_back(0);
    EXPECT_FALSE(worldFrom(longer).ok());
}

TEST(Snapshot, ofARecordingContinuesFromAnyStep) {
    World world = makePit(5, 2);
    WorldRecording recording{world};
    std::vector<std::uint64_t> hashes{hashOf(world)};
    for (int i = 0; i < 12; ++i) {
        if (i == 5) static_cast<void>(addBody(world, BodyKind::Dynamic, {0.0, 9.0}));
        if (i == 8) static_cast<void>(setVelocity(world, {1, 1}, {0.0f, 5.0f}));
        recording.step(world, kTick);
        hashes.push_back(hashOf(world));
    }
    const std::vector<std::uint8_t> bytes = recording.toBytes();
    const auto loaded = WorldRecording::from(bytes);
    ASSERT_TRUE(loaded.ok());
    EXPECT_EQ(loaded->steps(), 12u);
    for (std::size_t i = 0; i <= 12; ++i) {
        const auto again = loaded->replay(i);
        ASSERT_TRUE(again.ok());
        EXPECT_EQ(hashOf(*again), hashes[i]);
    }
    EXPECT_FALSE(loaded->replay(13).ok());
    for (std::size_t i = 0; i < bytes.size(); i += 1 + i / 32) {
        std::vector<std::uint8_t> spoiled = bytes;
        spoiled[i] ^= 4u;
        EXPECT_FALSE(WorldRecording::from(spoiled).ok());
        EXPECT_FALSE(WorldRecording::from(std::span{bytes}.first(i)).ok());
    }
}
