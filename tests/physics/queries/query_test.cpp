#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "physics/bounds.hpp"
#include "physics/narrowphase/distance.hpp"
#include "physics/queries/overlap.hpp"
#include "physics/queries/ray_cast.hpp"
#include "physics/shapes/hull.hpp"
#include "physics/shapes/shape_types.hpp"
#include "tests/physics/support/strewn_world.hpp"

using namespace plumb;
using namespace plumb::physics;

namespace {

/// Returns each kind of broad phase for even and for odd seeds.
BroadPhaseKind anyBroadPhase(std::uint64_t seed) {
    return static_cast<BroadPhaseKind>(seed / 2 % static_cast<std::uint64_t>(BroadPhaseKind::Count));
}
}  // namespace

TEST(CastRay, findsTheSameAsBruteForce) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        World world = scatterShapes(seed, seed % 2 == 0 ? 0.0 : kFar);
        world.settings.broadPhase = anyBroadPhase(seed);
        Random random = Random::seeded(seed);
        std::vector<CastHit> hits;
        for (int i = 0; i < 20; ++i) {
            const WorldPosition from{
                (seed % 2 == 0 ? 0.0 : kFar) + static_cast<double>(random.between(-12.0f, 12.0f)),
                static_cast<double>(random.between(-12.0f, 12.0f))};
            const Vec2 way{random.between(-20.0f, 20.0f), random.between(-20.0f, 20.0f)};
            const QueryFilter filter = randomFilter(world, random);
            std::vector<std::pair<float, std::uint32_t>> expected;
            for (std::uint32_t s = 0; s < world.shapes.size(); ++s) {
                if (!wanted(world, s, filter)) continue;
                const Frame frame = frameAt(world, s, from);
                const Ray ray{applyInverse(frame, {}), unrotate(frame.rotation, way)};
                const auto hit = castRay(world.shapes.geometry[s], world.shapes.corners, ray);
                if (hit) expected.emplace_back(hit->fraction, s);
            }
            std::sort(expected.begin(), expected.end());
            castRayAll(world, from, way, filter, hits);
            const auto first = castRay(world, from, way, filter);
            ASSERT_EQ(isRayBlocked(world, from, way, filter), !expected.empty());
            ASSERT_EQ(hits.size(), expected.size());
            ASSERT_EQ(first.has_value(), !expected.empty());
            for (std::size_t h = 0; h < hits.size(); ++h) {
                EXPECT_NEAR(hits[h].fraction, expected[h].first, 1.0e-5f);
                EXPECT_TRUE(alive(world, hits[h].shape));
                EXPECT_EQ(hits[h].body, bodyOf(world, hits[h].shape));
                EXPECT_NEAR(length(hits[h].normal), 1.0f, 1.0e-5f);
                if (h > 0) {
                    EXPECT_GE(hits[h].fraction, hits[h - 1].fraction);
                }
            }
            if (first) {
                EXPECT_EQ(first->shape, hits[0].shape);
                EXPECT_EQ(first->point, hits[0].point);
            }
        }
    }
}

TEST(CastRay, hasTheResultsOfSimpleCases) {
    World world;
    const BodyId ball = addBody(world, BodyKind::Dynamic, {5.0, 0.0});
    const BodyId crate = addBody(world, BodyKind::Static, {10.0, 0.0}, 0.5f * kPi);
    const ShapeId disc = *createShape(world, ball, circle(1.0f));
    const ShapeId slab = *createShape(world, crate, box({4.0f, 0.5f}));
    std::vector<CastHit> hits;
    castRayAll(world, {0.0, 0.5}, {20.0f, 0.0f}, {}, hits);
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_EQ(hits[0].shape, disc);
    EXPECT_EQ(hits[1].shape, slab);
    EXPECT_NEAR(hits[0].point.x, 5.0 - std::sqrt(0.75), 1.0e-6);
    EXPECT_NEAR(hits[0].normal.x, -std::sqrt(0.75f), 1.0e-6f);
    EXPECT_NEAR(hits[0].normal.y, 0.5f, 1.0e-6f);
    EXPECT_NEAR(hits[1].distance, 9.5f, 1.0e-5f);
    EXPECT_NEAR(hits[1].fraction, 0.475f, 1.0e-6f);
    EXPECT_NEAR(hits[1].normal.x, -1.0f, 1.0e-6f);
    EXPECT_FALSE(castRay(world, {0.0, 5.0}, {20.0f, 0.0f}).has_value());
    EXPECT_EQ(castRay(world, {5.2, 0.0}, {20.0f, 0.0f})->fraction, 0.0f);
}

TEST(CastRay, isEquallyExactAThousandKilometresAway) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE(seed);
        World here = scatterShapes(seed, 0.0), there = scatterShapes(seed, kFar);
        Random random = Random::seeded(seed);
        for (int i = 0; i < 20; ++i) {
            const double x = static_cast<double>(random.below(2560)) / 128.0 - 10.0;
            const double y = static_cast<double>(random.below(2560)) / 128.0 - 10.0;
            const Vec2 way{random.between(-20.0f, 20.0f), random.between(-20.0f, 20.0f)};
            const auto a = castRay(here, {x, y}, way), b = castRay(there, {x + kFar, y}, way);
            ASSERT_EQ(a.has_value(), b.has_value());
            if (!a) continue;
            EXPECT_EQ(a->shape, b->shape);
            EXPECT_NEAR(a->fraction, b->fraction, 1.0e-5f);
            EXPECT_NEAR(a->point.x + kFar, b->point.x, 1.0e-4);
        }
    }
}

TEST(Queries, includeEditsBetweenSteps) {
    World world;
    const BodyId body = addBody(world, BodyKind::Dynamic, {0.0, 0.0});
    const auto sees = [&](double x) { return castRay(world, {x, -5.0}, {0.0f, 10.0f}).has_value(); };
    EXPECT_FALSE(sees(0.0));
    const ShapeId shape = *createShape(world, body, circle(0.5f));
    EXPECT_TRUE(sees(0.0));
    ASSERT_TRUE(setPosition(world, body, {7.0, 0.0}, 0.0f));
    EXPECT_FALSE(sees(0.0));
    EXPECT_TRUE(sees(7.0));
    const World snapshot = world;
    destroyShape(world, shape);
    EXPECT_FALSE(sees(7.0));
    world = snapshot;
    EXPECT_TRUE(sees(7.0));
    world.settings.broadPhase = BroadPhaseKind::Grid;
    destroyBody(world, body);
    EXPECT_FALSE(sees(7.0));
}

TEST(Queries, doNotChangeSteps) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        SCOPED_TRACE(seed);
        World plain = makePit(40, seed), asked = plain;
        Random random = Random::seeded(seed);
        std::vector<ShapeId> found;
        std::size_t answers = 0;
        for (int i = 0; i < 120; ++i) {
            if (i % 40 == 20) {
                for (World* world : {&plain, &asked}) {
                    const BodyId body = addBody(*world, BodyKind::Dynamic, {0.0, 9.0});
                    static_cast<void>(createShape(*world, body, box({0.5f, 0.5f})));
                    destroyBody(*world, {3, world->bodies.info[3].generation});
                }
            }
            const WorldPosition place{static_cast<double>(random.between(-9.0f, 9.0f)), 2.0};
            answers += castRay(asked, place, {0.0f, -3.0f}).has_value() ? 1u : 0u;
            overlapCircle(asked, place, 2.0f, {}, found);
            answers += found.size();
            answers += closestPoint(asked, place, 5.0f).has_value() ? 1u : 0u;
            if (i == 60) asked = World{asked};
            step(plain, kTick);
            step(asked, kTick);
            ASSERT_EQ(hashOf(plain), hashOf(asked)) << "step " << i;
        }
        EXPECT_GT(answers, 200u);
        EXPECT_GT(plain.contacts.size(), 20u);
    }
}

TEST(Overlap, findsTheSameAsBruteForce) {
    std::size_t all = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        const double origin = seed % 2 == 0 ? 0.0 : kFar;
        World world = scatterShapes(seed, origin);
        world.settings.broadPhase = anyBroadPhase(seed);
        Random random = Random::seeded(seed);
        std::vector<ShapeId> found;
        for (int i = 0; i < 10; ++i) {
            const QueryFilter filter = randomFilter(world, random);
            const Vec2 half{random.between(0.1f, 3.0f), random.between(0.1f, 3.0f)};
            QueryShape query;
            query.geometry = i % 2 == 0 ? box(half) : capsule(-half, half, 0.3f);
            query.rotation = rotFromAngle(random.between(-3.0f, 3.0f));
            query.position = {origin + static_cast<double>(random.between(-10.0f, 10.0f)),
                              static_cast<double>(random.between(-10.0f, 10.0f))};
            overlapShape(world, query, filter, found);
            std::vector<ShapeId> expected;
            for (std::uint32_t s = 0; s < world.shapes.size(); ++s) {
                if (!wanted(world, s, filter)) continue;
                const Convex theirs = convexOf(world.shapes.geometry[s], world.shapes.corners);
                const Convex ours = convexOf(query.geometry, {});
                const Distance gap = distanceBetween(
                    ours, theirs, inverse(Frame{{}, query.rotation}) * frameAt(world, s, query.position));
                if (gap.distance <= 0.0f) expected.push_back({s, world.shapes.info[s].generation});
            }
            EXPECT_EQ(found, expected);
            all += found.size();
        }
    }
    EXPECT_GT(all, 500u);
}

TEST(Overlap, hasTheResultsOfSimpleCases) {
    World world;
    const BodyId floor = addBody(world, BodyKind::Static, {0.0, 0.0});
    const ShapeId left = *createShape(world, floor, box({1.0f, 1.0f}, {-2.0f, 0.0f}));
    const ShapeId right = *createShape(world, floor, circle(1.0f, {2.0f, 0.0f}));
    std::vector<ShapeId> found;
    overlapBox(world, {-1.5, -0.5}, {1.5, 0.5}, {}, found);
    EXPECT_EQ(found, (std::vector<ShapeId>{left, right}));
    overlapBox(world, {-0.9, -0.5}, {0.9, 0.5}, {}, found);
    EXPECT_TRUE(found.empty());
    overlapCircle(world, {0.0, 0.0}, 1.01f, {}, found);
    EXPECT_EQ(found.size(), 2u);
    overlapCircle(world, {2.9, 0.9}, 0.2f, {}, found);  // overlaps only a corner of the disc's bounding box
    EXPECT_TRUE(found.empty());
    overlapPoint(world, {-1.5, 0.5}, {}, found);
    EXPECT_EQ(found, (std::vector<ShapeId>{left}));
    overlapPoint(world, {1.1, 0.8}, {}, found);
    EXPECT_TRUE(found.empty());
}

TEST(Overlap, aPolygonUsesItsOwnCorners) {
    World world;
    const BodyId body = addBody(world, BodyKind::Static, {0.0, 0.0});
    static_cast<void>(createShape(world, body, box({1.0f, 1.0f})));
    const std::array<Vec2, 3> points{Vec2{0.0f, 0.0f}, Vec2{2.0f, 0.0f}, Vec2{0.0f, 2.0f}};
    const Hull hull = *makeHull(points);
    const std::vector<Corner> corners{hull.corners.begin(), hull.corners.end()};
    std::vector<ShapeId> found;
    overlapShape(world, {polygon(hull, 0), {0.9, 0.9}, {}, corners}, {}, found);
    EXPECT_EQ(found.size(), 1u);
    overlapShape(world, {polygon(hull, 0), {1.1, 0.9}, {}, corners}, {}, found);
    EXPECT_TRUE(found.empty());
    overlapShape(world, {polygon(hull, 7), {0.9, 0.9}, {}, corners}, {},
                 found);  // the polygon refers to corners beyond the end of the list
    EXPECT_TRUE(found.empty());
}

TEST(ClosestPoint, isTheNearestOfAllShapes) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        World world = scatterShapes(seed, 0.0);
        world.settings.broadPhase = anyBroadPhase(seed);
        Random random = Random::seeded(seed);
        for (int i = 0; i < 20; ++i) {
            const WorldPosition place{static_cast<double>(random.between(-12.0f, 12.0f)),
                                      static_cast<double>(random.between(-12.0f, 12.0f))};
            const float within = random.between(0.0f, 4.0f);
            const QueryFilter filter = randomFilter(world, random);
            float nearest = std::numeric_limits<float>::infinity();
            for (std::uint32_t s = 0; s < world.shapes.size(); ++s) {
                if (!wanted(world, s, filter)) continue;
                const Vec2 seen = applyInverse(frameAt(world, s, place), {});
                nearest = std::min(
                    nearest, closestPoint(world.shapes.geometry[s], world.shapes.corners, seen).distance);
            }
            const auto found = closestPoint(world, place, within, filter);
            ASSERT_EQ(found.has_value(), nearest <= within);
            if (!found) continue;
            EXPECT_NEAR(found->distance, nearest, 1.0e-5f);
            EXPECT_NEAR(length(found->point - place), std::fabs(nearest), 1.0e-4f);
        }
    }
}

TEST(Queries, invalidNumbersFindNothing) {
    World world = scatterShapes(1, 0.0);
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    const float fnan = std::numeric_limits<float>::quiet_NaN(), finf = std::numeric_limits<float>::infinity();
    std::vector<CastHit> hits;
    std::vector<ShapeId> found;
    for (const double bad : {nan, inf, -inf, 1.0e12, 1.0e300}) {
        castRayAll(world, {bad, 0.0}, {1.0f, 0.0f}, {}, hits);
        EXPECT_TRUE(hits.empty());
        overlapPoint(world, {0.0, bad}, {}, found);
        EXPECT_TRUE(found.empty());
        overlapBox(world, {bad, bad}, {1.0, 1.0}, {}, found);
        EXPECT_TRUE(found.empty());
        overlapCircle(world, {bad, 0.0}, 1.0f, {}, found);
        EXPECT_TRUE(found.empty());
        EXPECT_FALSE(closestPoint(world, {bad, 0.0}, 100.0f).has_value());
    }
    for (const float bad : {fnan, finf, -finf}) {
        EXPECT_FALSE(castRay(world, {-20.0, 0.0}, {bad, 0.0f}).has_value());
        overlapCircle(world, {0.0, 0.0}, bad, {}, found);
        EXPECT_TRUE(found.empty());
        EXPECT_FALSE(closestPoint(world, {0.0, 0.0}, bad).has_value());
        overlapShape(world, {box({1.0f, 1.0f}), {}, {bad, 0.0f}}, {}, found);
        EXPECT_TRUE(found.empty());
    }
    overlapCircle(world, {0.0, 0.0}, -1.0f, {}, found);
    EXPECT_TRUE(found.empty());
    overlapBox(world, {1.0, 1.0}, {-1.0, -1.0}, {}, found);
    EXPECT_TRUE(found.empty());
    EXPECT_FALSE(castRay(world, {30.0, 30.0}, {}).has_value());
}
