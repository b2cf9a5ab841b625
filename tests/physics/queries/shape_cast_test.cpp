#include "physics/queries/shape_cast.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "physics/narrowphase/distance.hpp"
#include "tests/physics/support/strewn_world.hpp"

using namespace plumb;
using namespace plumb::physics;

namespace {

/// Distance between an outline, after a fraction `part` of its displacement, and another shape, m.
float gapAt(const World& world, const QueryShape& shape, Vec2 displacement, float part, std::uint32_t other) {
    const WorldPosition position = shape.position + displacement * part;
    const Frame theirs = inverse(Frame{{}, shape.rotation}) * frameAt(world, other, position);
    return distanceBetween(convexOf(shape.geometry, world.shapes.corners),
                           convexOf(world.shapes.geometry[other], world.shapes.corners), theirs)
        .distance;
}

}  // namespace

TEST(CastShape, stopsAtTheFirstTouch) {
    int met = 0, free = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        const double origin = seed % 2 == 0 ? 0.0 : kFar;
        World world = scatterShapes(seed, origin);
        Random random = Random::seeded(seed);
        std::vector<CastHit> hits;
        for (int i = 0; i < 10; ++i) {
            const Vec2 half{random.between(0.05f, 1.0f), random.between(0.05f, 1.0f)};
            QueryShape shape;
            shape.geometry = i % 3 == 0   ? circle(half.x)
                             : i % 3 == 1 ? box(half)
                                          : capsule(-half, half, 0.1f);
            shape.position = {origin + static_cast<double>(random.between(-12.0f, 12.0f)),
                              static_cast<double>(random.between(-12.0f, 12.0f))};
            shape.rotation = rotFromAngle(random.between(-3.0f, 3.0f));
            const Vec2 displacement{random.between(-9.0f, 9.0f), random.between(-9.0f, 9.0f)};
            const QueryFilter filter = randomFilter(world, random);
            const auto hit = castShape(world, shape, displacement, filter);
            castShapeAll(world, shape, displacement, filter, hits);
            ASSERT_EQ(hit.has_value(), !hits.empty());
            for (const CastHit& one : hits) {
                ASSERT_TRUE(wanted(world, one.shape.index, filter));
                ASSERT_LE(gapAt(world, shape, displacement, one.fraction, one.shape.index), 2.0e-4f);
                if (one.fraction > 0.0f) {
                    EXPECT_LE(dot(one.normal, displacement), 0.0f);
                    EXPECT_GE(gapAt(world, shape, displacement, one.fraction, one.shape.index), -1.0e-4f);
                }
            }
            const float last = hit ? hit->fraction : 1.0f;
            for (std::uint32_t s = 0; s < world.shapes.size(); ++s) {
                if (!wanted(world, s, filter)) continue;
                for (int part = 0; part < 20; ++part)
                    ASSERT_GT(gapAt(world, shape, displacement, last * static_cast<float>(part) / 20.0f, s),
                              hit && hit->fraction == 0.0f ? -1.0e9f : 0.0f);
            }
            ++(hit ? met : free);
        }
    }
    EXPECT_GT(met, 200);
    EXPECT_GT(free, 50);
}

TEST(CastShape, hasTheResultsOfSimpleCases) {
    World world;
    const BodyId wall = addBody(world, BodyKind::Static, {10.0, 0.0});
    const ShapeId slab = *createShape(world, wall, box({1.0f, 5.0f}));
    const auto hit = castShape(world, {circle(0.5f), {}, {}}, {20.0f, 0.0f});
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->shape, slab);
    EXPECT_NEAR(hit->distance, 8.5f, 2.0e-4f);
    EXPECT_NEAR(hit->normal.x, -1.0f, 1.0e-5f);
    EXPECT_NEAR(hit->point.x, 9.0, 1.0e-4);
    EXPECT_FALSE(castShape(world, {circle(0.5f), {}, {}}, {8.0f, 0.0f}).has_value());
    EXPECT_FALSE(castShape(world, {circle(0.5f), {}, {}}, {0.0f, 20.0f}).has_value());
    EXPECT_EQ(castShape(world, {box({1.0f, 1.0f}), {9.0, 0.0}, {}}, {0.0f, 1.0f})->fraction, 0.0f);
}

TEST(CastShape, hitsChainsOnlyFromTheirSolidSide) {
    World world;
    const BodyId ground = addBody(world, BodyKind::Static, {});
    const std::array<Vec2, 4> points{Vec2{-20.0f, 0.0f}, Vec2{-5.0f, 0.0f}, Vec2{5.0f, 0.0f},
                                     Vec2{20.0f, 0.0f}};
    ASSERT_TRUE(createChain(world, ground, points, false));
    const Vec2 front = normalOfChain(world.shapes.geometry[0]);
    EXPECT_TRUE(
        castShape(world, {circle(0.2f), WorldPosition{} + front * 3.0f, {}}, front * -6.0f).has_value());
    EXPECT_FALSE(
        castShape(world, {circle(0.2f), WorldPosition{} + front * -3.0f, {}}, front * 6.0f).has_value());
}

TEST(CastShape, invalidNumbersHitNothing) {
    World world = scatterShapes(3, 0.0);
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    for (const float bad : {nan, inf, -inf}) {
        EXPECT_FALSE(castShape(world, {circle(bad), {}, {}}, {1.0f, 0.0f}).has_value());
        EXPECT_FALSE(
            castShape(world, {circle(1.0f), {static_cast<double>(bad), 0.0}, {}}, {1.0f, 0.0f}).has_value());
        EXPECT_FALSE(castShape(world, {circle(1.0f), {}, {}}, {bad, 0.0f}).has_value());
        EXPECT_FALSE(castShape(world, {circle(1.0f), {}, {bad, bad}}, {1.0f, 0.0f}).has_value());
    }
    EXPECT_FALSE(castShape(world, {circle(0.0f), {}, {}}, {1.0f, 0.0f}).has_value());
}
