#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "physics/broadphase/box_rows.hpp"
#include "physics/contacts/pair_set.hpp"
#include "physics/islands/quality.hpp"
#include "physics/queries/lists.hpp"
#include "physics/shapes/convex.hpp"
#include "physics/tuning.hpp"
#include "physics/workspace.hpp"
#include "tests/physics/support/proxy_world.hpp"
#include "tests/physics/support/random_shapes.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

// Compares small shared functions with the simplest possible implementations.

using namespace plumb;
using namespace plumb::physics;

TEST(PairSet, behavesLikeASet) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        PairSet pairs;
        std::set<PairKey> wanted;
        const std::uint32_t most = 4 + random.below(200);
        for (int i = 0; i < 3000; ++i) {
            const PairKey key = pairKey(random.below(most), most + random.below(4));
            EXPECT_EQ(pairs.has(key), wanted.contains(key));
            if (random.below(5) < 3) {
                EXPECT_EQ(pairs.add(key), wanted.insert(key).second);
            } else {
                pairs.remove(key);
                wanted.erase(key);
            }
            ASSERT_EQ(pairs.size(), wanted.size());
            if (i % 1000 == 999) {
                for (std::uint32_t a = 0; a < most; ++a) {
                    for (std::uint32_t b = 0; b < 4; ++b)
                        EXPECT_EQ(pairs.has(pairKey(a, most + b)), wanted.contains(pairKey(a, most + b)));
                }
            }
            if (i == 2000) pairs.clear(), wanted.clear();
        }
    }
}

TEST(BoxStatistics, matchAGridOfBoxes) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        test::ProxyWorld world;
        std::vector<std::uint32_t> ids;
        // A grid of boxes, with additional empty boxes that must not be counted.
        const int columns = 20 + static_cast<int>(random.below(30)),
                  rows = 20 + static_cast<int>(random.below(30));
        const float apart = random.between(0.5f, 5.0f), size = random.between(0.1f, 4.0f);
        const Vec2 corner = test::randomPoint(random, 100.0f);
        for (int y = 0; y < rows; ++y) {
            for (int x = 0; x < columns; ++x) {
                const Vec2 middle = corner + apart * Vec2{static_cast<float>(x), static_cast<float>(y)};
                const Vec2 half = 0.5f * Vec2{size, 0.5f * size};
                ids.push_back(world.add({middle - half, middle + half}));
            }
        }
        const BoxStatistics found = statisticsOf(world.proxies(), ids);
        EXPECT_NEAR(found.spacing, apart, 0.06f * apart);
        EXPECT_NEAR(found.aspect, static_cast<float>(columns) / static_cast<float>(rows),
                    0.03f * found.aspect);
        EXPECT_GE(found.extent, 0.999f * size);
        EXPECT_LE(found.extent, 1.501f * size) << "the extent is rounded up by at most half";
    }
}

TEST(BoxStatistics, ignoreAQuarterOfLargeBoxes) {
    for (const float large : {2.0f, 8.0f, 100.0f}) {
        test::ProxyWorld world;
        std::vector<std::uint32_t> ids;
        const auto extent = [&](int small, int others) {
            world = {};
            ids.clear();
            for (int i = 0; i < small + others; ++i) {
                const float half = 0.5f * (i < small ? 1.0f : large);
                ids.push_back(world.add({{-half, -half}, {half, half}}));
            }
            return statisticsOf(world.proxies(), ids).extent;
        };
        EXPECT_LE(extent(80, 20), 1.5f);
        EXPECT_GT(extent(60, 40), 1.5f) << "40 % large boxes are not ignored";
        EXPECT_LE(extent(60, 40), 3.0f) << "no more than twice the median";
        EXPECT_GT(extent(40, 60), 0.999f * large);
    }
}

TEST(SubstepEstimate, addsALevelAboveEachLimit) {
    const auto levels = [](auto&& change) {
        SubstepEstimate island;
        island.bodies = 10.0f;
        island.size = 5.0f;  // layers of 1 m
        island.lightest = island.heaviest = 1.0f;
        island.lowest = island.highest = 0.0f;
        island.joints = 0.0f;
        change(island);
        return extraQuality(island);
    };
    EXPECT_EQ(levels([](SubstepEstimate&) {}), 0);
    EXPECT_EQ(levels([](SubstepEstimate& i) { i.bodies = 0.0f, i.heaviest = 1e9f; }), 0);
    constexpr std::pair<float, int> kRatios[] = {{10.0f, 0}, {10.1f, 1}, {30.0f, 1}, {30.1f, 2},
                                                 {90.0f, 2}, {90.1f, 3}, {1e6f, 3}};
    for (const auto& [ratio, wanted] : kRatios) {
        EXPECT_EQ(levels([r = ratio](SubstepEstimate& i) { i.heaviest = r; }), wanted) << ratio;
        EXPECT_EQ(levels([r = ratio](SubstepEstimate& i) { i.lightest = 2.0f, i.heaviest = 2.0f * r; }),
                  wanted)
            << ratio;
    }
    constexpr std::pair<float, int> kHeights[] = {{7.0f, 0},  {7.1f, 1},  {14.0f, 1},
                                                  {14.1f, 2}, {28.0f, 2}, {28.1f, 3}};
    for (const auto& [height, wanted] : kHeights) {
        EXPECT_EQ(levels([h = height](SubstepEstimate& i) { i.lowest = -1.0f, i.highest = h - 1.0f; }),
                  wanted)
            << height;
        EXPECT_EQ(levels([h = height](SubstepEstimate& i) { i.size = 10.0f, i.highest = 2.0f * h; }), wanted)
            << height;
    }
    constexpr std::pair<float, int> kJoints[] = {{8.0f, 0},  {8.5f, 1},   {32.0f, 1},
                                                 {32.5f, 2}, {128.0f, 2}, {129.0f, 3}};
    for (const auto& [joints, wanted] : kJoints)
        EXPECT_EQ(levels([j = joints](SubstepEstimate& i) { i.joints = j; }), wanted) << joints;
}

TEST(Convex, theFarthestCornerIsTheFirstOfEqualOnes) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        Random random = Random::seeded(seed);
        const test::Outline outline = test::randomPolygon(random, 3.0f);
        const Vec2 direction = test::randomPoint(random, 1.0f);
        const int best = farthest(outline.corners, direction);
        for (int i = 0; i < static_cast<int>(outline.corners.size()); ++i) {
            EXPECT_GE(dot(outline.corners[static_cast<std::size_t>(best)].point, direction),
                      dot(outline.corners[static_cast<std::size_t>(i)].point, direction));
        }
    }
    const auto square = cornersOfBox({}, {1.0f, 1.0f}, {});
    EXPECT_EQ(farthest(square, {0.0f, -1.0f}), 0);
    EXPECT_EQ(farthest(square, {1.0f, 0.0f}), 1);
    EXPECT_EQ(farthest(square, {0.0f, 1.0f}), 2);
    EXPECT_EQ(farthest(square, {-1.0f, 0.0f}), 0);
}

TEST(Convex, ofBoxesAndSegmentsHasCornersInTheOrderOfTheirNormals) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        Random random = Random::seeded(seed);
        const Vec2 centre = test::randomPoint(random, 3.0f),
                   half{random.between(0.1f, 2.0f), random.between(0.1f, 2.0f)};
        const Rot rotation = test::randomRotation(random);
        const Geometry geometry = box(half, centre, rotation, 0.25f);
        const Convex convex = convexOf(geometry, {});
        EXPECT_EQ(convex.centre, centre);
        EXPECT_EQ(convex.radius, 0.25f);
        ASSERT_EQ(convex.corners().size(), 4u);
        constexpr Vec2 kSides[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
        constexpr Vec2 kNormals[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec2 local = unrotate(rotation, convex.corners()[i].point - centre);
            EXPECT_NEAR(local.x, kSides[i].x * half.x, 1e-5f);
            EXPECT_NEAR(local.y, kSides[i].y * half.y, 1e-5f);
            EXPECT_NEAR(length(unrotate(rotation, convex.corners()[i].normal) - kNormals[i]), 0.0f, 1e-6f);
        }
        const Vec2 end = test::randomPoint(random, 3.0f);
        const Convex rod = convexOf(capsule(centre, end, 0.1f), {});
        EXPECT_EQ(rod.centre, (centre + end) * 0.5f);
        ASSERT_EQ(rod.count, 2);
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_EQ(rod.corners()[i].point, i == 0 ? centre : end);
            EXPECT_NEAR(dot(rod.corners()[i].normal, end - centre), 0.0f, 1e-5f);
            EXPECT_GT(cross(rod.corners()[i].normal, i == 0 ? end - centre : centre - end), 0.0f);
        }
        EXPECT_EQ(convexOf(segment(centre, end), {}).radius, 0.0f);
    }
    EXPECT_EQ(convexOf(capsule({1.0f, 1.0f}, {1.0f, 1.0f}, 1.0f), {}).count, 1);
    EXPECT_EQ(convexOf(capsule({}, {1.1f * kBlur, 0.0f}, 1.0f), {}).count, 2);
    EXPECT_EQ(convexOf(capsule({}, {kBlur, 0.0f}, 1.0f), {}).count, 1);
}

TEST(Lists, matchASearchOfAllContacts) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        SCOPED_TRACE(seed);
        World world = makePit(30, seed);
        const BodyId zone = addBody(world, BodyKind::Static, {0.0, 1.0});
        const ShapeId trigger = *createShape(world, zone, box({4.0f, 1.0f}), {.isTrigger = true});
        const BodyId rover = addBody(world, BodyKind::Dynamic, {0.0, 6.0});
        const ShapeId moving = *createShape(world, rover, box({3.0f, 3.0f}), {.isTrigger = true});
        static_cast<void>(createShape(world, rover, circle(0.3f)));
        world.settings.sleepTime = 0.1f;
        for (int i = 0; i < 60 + 40 * static_cast<int>(seed); ++i) step(world, kTick);
        std::vector<const Contact*> all;
        for (const Contact& contact : world.contacts) all.push_back(&contact);
        for (const SleepingIsland& island : world.sleepers.islands) {
            for (std::uint32_t c = island.firstContact; c != kNone; c = world.sleepers.nextContact[c])
                all.push_back(&world.sleepers.contacts[c]);
        }
        std::erase_if(all, [](const Contact* contact) { return (contact->flags & kTouching) == 0; });
        std::vector<const Contact*> found;
        const auto expectFound = [&](auto&& concerns) {
            std::size_t wanted = 0;
            for (const Contact* contact : all) {
                if (!concerns(*contact)) continue;
                ++wanted;
                EXPECT_EQ(std::count(found.begin(), found.end(), contact), 1);
            }
            EXPECT_EQ(found.size(), wanted);
        };
        for (std::uint32_t b = 0; b < world.bodies.size(); ++b) {
            contactsOf(world, BodyId{b, world.bodies.info[b].generation}, found);
            expectFound([&](const Contact& c) {
                return (c.flags & kTriggered) == 0 && (c.bodyA == b || c.bodyB == b);
            });
        }
        for (std::uint32_t s = 0; s < world.shapes.size(); ++s) {
            contactsOf(world, ShapeId{s, world.shapes.info[s].generation}, found);
            expectFound([&](const Contact& c) {
                return (c.flags & kTriggered) == 0 && (c.shapeA == s || c.shapeB == s);
            });
        }
        for (const ShapeId sensor : {trigger, moving}) {
            std::vector<ShapeId> inside;
            overlapsOf(world, sensor, inside);
            std::set<std::uint32_t> wanted;
            for (const Contact* contact : all) {
                if ((contact->flags & kTriggered) == 0) continue;
                if (contact->shapeA == sensor.index) wanted.insert(contact->shapeB);
                if (contact->shapeB == sensor.index) wanted.insert(contact->shapeA);
            }
            std::set<std::uint32_t> got;
            for (const ShapeId shape : inside) {
                EXPECT_TRUE(alive(world, shape));
                got.insert(shape.index);
            }
            EXPECT_EQ(got, wanted);
            EXPECT_EQ(got.size(), inside.size());
        }
        for (const Contact* contact : all) {
            const auto points = contactPoints(world, *contact);
            ASSERT_EQ(points.size(), static_cast<std::size_t>(contact->count));
            const float separations[] = {contact->separation0, contact->separation1};
            const float impulses[] = {contact->impulse0, contact->impulse1};
            for (std::size_t i = 0; i < points.size(); ++i) {
                EXPECT_EQ(points[i].separation, separations[i]);
                EXPECT_EQ(points[i].impulse, std::fabs(impulses[i]));
                // The point is near both shapes, up to their motion in the last step.
                if ((contact->flags & kTriggered) != 0) continue;
                for (const std::uint32_t shape : {contact->shapeA, contact->shapeB})
                    EXPECT_TRUE(contains(grown(world.shapes.bounds[shape], 0.4f), toVec2(points[i].point)));
            }
        }
    }
}

TEST(Lists, boundsContainAllShapesWithTheirMargin) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Random random = Random::seeded(seed);
        World world;
        AABB all{{1e9f, 1e9f}, {-1e9f, -1e9f}};
        std::vector<ShapeId> shapes;
        for (int i = 0; i < 3; ++i) {
            const Vec2 place = test::randomPoint(random, 20.0f);
            const BodyId body = addBody(world, BodyKind::Static, WorldPosition{place});
            AABB own{{1e9f, 1e9f}, {-1e9f, -1e9f}};
            for (int n = 0; n < 2; ++n) {
                const Vec2 middle = test::randomPoint(random, 3.0f);
                const float radius = random.between(0.1f, 1.0f);
                shapes.push_back(*createShape(world, body, circle(radius, middle)));
                const Vec2 side{radius, radius};
                own = {min(own.min, place + middle - side), max(own.max, place + middle + side)};
            }
            const AABB found = boundsOf(world, body);
            EXPECT_NEAR(length(found.min - own.min), 0.0f, 0.2f);
            EXPECT_NEAR(length(found.max - own.max), 0.0f, 0.2f);
            all = {min(all.min, own.min), max(all.max, own.max)};
        }
        EXPECT_NEAR(length(boundsOf(world).min - all.min), 0.0f, 0.2f);
        EXPECT_NEAR(length(boundsOf(world).max - all.max), 0.0f, 0.2f);
        const BodyId bare = addBody(world, BodyKind::Static, {500.0, 0.0});
        EXPECT_EQ(boundsOf(world, bare), AABB{});
        EXPECT_LT(boundsOf(world).max.x, 100.0f);
        for (const ShapeId shape : shapes) destroyShape(world, shape);
        EXPECT_EQ(boundsOf(world), AABB{});
    }
}
