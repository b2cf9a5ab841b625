#include "physics/narrowphase/time_of_impact.hpp"

#include <gtest/gtest.h>

#include "physics/narrowphase/shape_cast.hpp"
#include "tests/physics/random_shapes.hpp"

namespace plumb::physics {
namespace {

using namespace test;

constexpr float kNear = 2.0f * kImpactTolerance;

Sweep still(Vec2 at = {}) { return {.start = at, .end = at}; }

TEST(TimeOfImpact, ofTwoDiscsIsWhereTheirCentresAreBothRadiiApart) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Convex a = convexOf(circle(random.between(0.1f, 1.0f)), {});
        const Convex b = convexOf(circle(random.between(0.1f, 1.0f)), {});
        const Sweep sweepA{
            .start = randomPoint(random, 5.0f), .end = randomPoint(random, 5.0f), .turn = 3.0f};
        const Sweep sweepB{
            .start = randomPoint(random, 5.0f), .end = randomPoint(random, 5.0f), .turn = -2.0f};
        // |start + way * t| = radii: a quadratic equation.
        const Vec2 start = sweepB.start - sweepA.start;
        const Vec2 way = sweepB.end - sweepA.end - start;
        const float radii = a.radius + b.radius;
        const float half = dot(start, way);
        const float square = lengthSquared(way);
        const float root = half * half - square * (lengthSquared(start) - radii * radii);
        const float at = root >= 0.0f ? (-half - std::sqrt(root)) / square : 2.0f;
        const TimeOfImpact impact = timeOfImpact(a, sweepA, b, sweepB, 0.0f);
        if (length(start) < radii) {
            EXPECT_EQ(impact.state, SweepState::Overlapped);
        } else if (at >= 0.0f && at <= 1.0f && root > 0.01f) {
            ASSERT_EQ(impact.state, SweepState::Hit);
            const float speed = std::sqrt(root) / radii;  // at which they close in
            EXPECT_NEAR(impact.fraction, at, kNear / speed);
            EXPECT_LE(impact.fraction, at + 1e-5f);
        } else if (root < 0.0f || at > 1.0f || at < 0.0f) {
            EXPECT_EQ(impact.state, SweepState::Separated);
        }
    }
}

TEST(TimeOfImpact, ofASpinningBoxIsWhenItsCornerReachesTheFloor) {
    const Convex floor = convexOf(box({50.0f, 0.5f}, {0.0f, 0.5f}), {});
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Vec2 half{random.between(0.1f, 1.0f), random.between(0.1f, 1.0f)};
        const float angle = random.between(-3.0f, 3.0f);
        const Sweep sweep{.start = {0.0f, -length(half) - random.between(0.01f, 2.0f)},
                          .end = {random.between(-5.0f, 5.0f), 1.0f},
                          .rotation = rotFromAngle(angle),
                          .turn = random.between(-6.0f, 6.0f)};
        const TimeOfImpact impact = timeOfImpact(floor, still(), convexOf(box(half), {}), sweep, 0.0f);
        ASSERT_EQ(impact.state, SweepState::Hit);
        const auto lowest = [&](float fraction) {
            const float now = angle + sweep.turn * fraction;
            const float y = sweep.start.y + (sweep.end.y - sweep.start.y) * fraction;
            return -(y + half.x * std::fabs(sine(now)) + half.y * std::fabs(cosine(now)));
        };
        EXPECT_NEAR(lowest(impact.fraction), 0.0f, kNear);
        for (int i = 0; i < 100; ++i)
            EXPECT_GT(lowest(impact.fraction * static_cast<float>(i) / 100.0f), 0.0f);
        EXPECT_NEAR(impact.normal.y, -1.0f, 1e-5f);
    }
}

TEST(TimeOfImpactProperty, nothingTouchesBeforeAndAHitTouches) {
    int hits = 0;
    int most = 0;
    long sum = 0;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Outline a = randomOutline(random, kConvexKinds[random.below(5)], 1.0f);
        const Outline b = randomOutline(random, kConvexKinds[random.below(5)], 1.0f);
        const Convex convexA = convexOf(a.geometry, a.corners);
        const Convex convexB = convexOf(b.geometry, b.corners);
        const auto sweep = [&] {
            return Sweep{.start = randomPoint(random, 4.0f),
                         .end = randomPoint(random, 2.0f),
                         .localCentre = randomPoint(random, 0.5f),
                         .rotation = randomTurn(random),
                         .turn = random.between(-2.0f, 2.0f)};
        };
        const Sweep sweepA = sweep();
        const Sweep sweepB = sweep();
        const auto apart = [&](float fraction) {
            const Frame frame = inverse(frameAt(sweepA, fraction)) * frameAt(sweepB, fraction);
            return distanceBetween(convexA, convexB, frame).distance;
        };
        const TimeOfImpact impact = timeOfImpact(convexA, sweepA, convexB, sweepB, 0.0f);
        ASSERT_NE(impact.state, SweepState::Failed);
        most = std::max(most, impact.iterations);
        sum += impact.iterations;
        if (impact.state == SweepState::Overlapped) {
            EXPECT_LE(apart(0.0f), 0.0f);
            continue;
        }
        for (int i = 0; i <= 100; ++i)
            EXPECT_GT(apart(impact.fraction * static_cast<float>(i) / 100.0f), 0.0f);
        if (impact.state != SweepState::Hit) continue;
        ++hits;
        EXPECT_LT(apart(impact.fraction), kNear);
    }
    EXPECT_GT(hits, 300);
    EXPECT_LE(most, 40);
    EXPECT_LE(sum, 2000 * 5);
    RecordProperty("iterations", std::to_string(sum) + " in all, at most " + std::to_string(most));
}

TEST(TimeOfImpact, aBulletNeverPassesAThinWall) {
    const Convex wall = convexOf(segment({0.0f, -5.0f}, {0.0f, 5.0f}), {});
    for (const float speed : {10.0f, 100.0f, 1000.0f, 10000.0f}) {
        for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
            SCOPED_TRACE(seed);
            Random random = Random::seeded(seed);
            const Outline bullet = randomOutline(random, kSolidKinds[seed % 4], 0.05f);
            const Convex convex = convexOf(bullet.geometry, bullet.corners);
            const float distance = speed / 60.0f;
            const float from = random.between(0.2f, 0.9f) * distance + 0.15f;
            const Sweep sweep{.start = {-from, 0.0f},
                              .end = {distance - from + 0.3f, random.between(-2.0f, 2.0f)},
                              .rotation = randomTurn(random),
                              .turn = random.between(-3.0f, 3.0f)};
            const TimeOfImpact impact = timeOfImpact(wall, still(), convex, sweep, 0.0f);
            ASSERT_EQ(impact.state, SweepState::Hit);
            const float gap = distanceBetween(wall, convex, frameAt(sweep, impact.fraction)).distance;
            EXPECT_LT(std::fabs(gap), kNear + 4e-7f * distance);
            EXPECT_LE(dot(impact.normal, {1.0f, 0.0f}), -0.9f);
        }
    }
}

TEST(TimeOfImpact, theTargetIsAGapOrADepth) {
    const Convex floor = convexOf(box({5.0f, 0.5f}, {0.0f, 0.5f}), {});
    const Convex crate = convexOf(box({0.5f, 0.5f}), {});
    const Sweep fall{.start = {0.0f, -1.5f}, .end = {0.0f, 0.5f}};  // 2 m down, 1 m above the floor
    EXPECT_NEAR(timeOfImpact(floor, still(), crate, fall, 0.0f).fraction, 0.5f, kNear);
    EXPECT_NEAR(timeOfImpact(floor, still(), crate, fall, 0.1f).fraction, 0.45f, kNear);
    EXPECT_NEAR(timeOfImpact(floor, still(), crate, fall, -0.1f).fraction, 0.55f, kNear);
    const Sweep resting{.start = {0.0f, -0.5f}, .end = {0.0f, -0.4f}};
    EXPECT_EQ(timeOfImpact(floor, still(), crate, resting, 0.0f).state, SweepState::Overlapped);
    EXPECT_EQ(timeOfImpact(floor, still(), crate, resting, -0.05f).state, SweepState::Hit);
    EXPECT_EQ(
        timeOfImpact(floor, still(), crate, {.start = {0, -2}, .end = {9, -2}, .turn = 50.0f}, 0.0f).state,
        SweepState::Separated);
}

TEST(CastShapeProperty, stopsWhereItFirstTouches) {
    int hits = 0;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Outline a = randomOutline(random, kConvexKinds[random.below(5)], 1.0f);
        const Outline b = randomOutline(random, kConvexKinds[random.below(5)], 1.0f);
        const Convex convexA = convexOf(a.geometry, a.corners);
        const Convex convexB = convexOf(b.geometry, b.corners);
        const Frame start = randomFrame(random, 4.0f);
        const Vec2 way = randomPoint(random, 2.0f) - start.position;
        const auto apart = [&](float fraction) {
            return distanceBetween(convexA, convexB, {start.position + way * fraction, start.rotation});
        };
        const auto hit = castShape(convexA, convexB, start, way);
        if (apart(0.0f).distance < 0.0f) {
            ASSERT_TRUE(hit.has_value());
            EXPECT_EQ(hit->fraction, 0.0f);
            EXPECT_NEAR(hit->separation, apart(0.0f).distance, 1e-6f);
            continue;
        }
        const float until = hit ? hit->fraction : 1.0f;
        for (int i = 0; i < 100; ++i)
            EXPECT_GT(apart(until * static_cast<float>(i) / 100.0f).distance, -1e-5f);
        if (!hit) continue;
        ++hits;
        EXPECT_NEAR(apart(until).distance, 0.0f, 5e-5f);
        EXPECT_NEAR(closestPoint(a.geometry, a.corners, hit->point).distance, 0.0f, 2e-5f);
        EXPECT_LT(dot(hit->normal, way), 0.0f);
    }
    EXPECT_GT(hits, 500);
}

TEST(CastShape, ofADiscIsACastRayAtALargerDisc) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const float radius = random.between(0.1f, 1.0f);
        const float target = random.between(0.1f, 1.0f);
        const Ray ray{randomPoint(random, 6.0f), randomPoint(random, 12.0f)};
        const auto cast =
            castShape(convexOf(circle(target), {}), convexOf(circle(radius), {}), {ray.from, {}}, ray.way);
        const auto hit = castRay(circle(target + radius), {}, ray);
        const ClosestPoint pass = closestPoint(segment(ray.from, ray.from + ray.way), {}, {});
        if (std::fabs(pass.distance - target - radius) < 1e-3f) continue;  // grazes
        ASSERT_EQ(cast.has_value(), hit.has_value());
        if (!hit) continue;
        EXPECT_NEAR(cast->fraction * length(ray.way), hit->fraction * length(ray.way), 2e-3f);
    }
}

}  // namespace
}  // namespace plumb::physics
