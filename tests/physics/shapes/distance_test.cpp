#include "physics/narrowphase/distance.hpp"

#include <gtest/gtest.h>

#include "tests/physics/support/random_shapes.hpp"

namespace plumb::physics {
namespace {

using namespace test;

/// Maximum gap over many directions and the normals of all faces: the exact distance (or overlap, if
/// negative) up to the angular resolution.
float widestGapOf(const Convex& a, const Convex& b, const Frame& bInA) {
    float widest = -1e30f;
    const auto look = [&](Vec2 direction) {
        const auto far = [](const Convex& convex, Vec2 along) {
            float most = -1e30f;
            for (const Corner& corner : convex.corners()) most = std::fmax(most, dot(corner.point, along));
            return most + convex.radius;
        };
        const float gap =
            dot(bInA.position, direction) - far(b, unrotate(bInA.rotation, -direction)) - far(a, direction);
        widest = std::fmax(widest, gap);
    };
    for (int i = 0; i < 2000; ++i) {
        const SinCos at = sinCos(kTau * static_cast<float>(i) / 2000.0f);
        look({at.cos, at.sin});
    }
    for (const Corner& corner : a.corners()) look(corner.normal);
    for (const Corner& corner : b.corners()) look(-rotate(bInA.rotation, corner.normal));
    return widest;
}

TEST(DistanceProperty, isTheMaximumGapOverAllDirections) {
    int apart = 0;
    int inside = 0;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Outline a = randomOutline(random, kConvexKinds[random.below(5)], 1.0f);
        const Outline b = randomOutline(random, kConvexKinds[random.below(5)], 1.0f);
        const Frame frame = randomFrame(random, 2.0f);
        const Convex convexA = convexOf(a.geometry, a.corners);
        const Convex convexB = convexOf(b.geometry, b.corners);
        const Distance found = distanceBetween(convexA, convexB, frame);
        const float gap = widestGapOf(convexA, convexB, frame);
        // Error of a direction that is wrong by half a step.
        EXPECT_GE(found.distance, gap - 1e-5f);
        EXPECT_LE(found.distance, gap + 2e-5f + 4.0f * 1.3e-6f * std::fabs(gap));
        EXPECT_NEAR(length(found.normal), 1.0f, 1e-5f);
        EXPECT_LT(distance(found.pointA + found.normal * found.distance, found.pointB), 1e-4f);
        EXPECT_LE(found.iterations, 20);
        (found.distance > 0.0f ? apart : inside) += 1;
    }
    EXPECT_GT(apart, 500);
    EXPECT_GT(inside, 500);
}

TEST(DistanceProperty, theClosestPointsAreOnBothSurfaces) {
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Outline a = randomOutline(random, kSolidKinds[random.below(4)], 1.0f);
        const Outline b = randomOutline(random, kSolidKinds[random.below(4)], 1.0f);
        const Frame frame = randomFrame(random, 3.0f);
        const Distance found =
            distanceBetween(convexOf(a.geometry, a.corners), convexOf(b.geometry, b.corners), frame);
        EXPECT_NEAR(closestPoint(a.geometry, a.corners, found.pointA).distance, 0.0f, 1e-5f);
        EXPECT_NEAR(closestPoint(b.geometry, b.corners, applyInverse(frame, found.pointB)).distance, 0.0f,
                    1e-5f);
    }
}

TEST(DistanceProperty, aCacheChangesOnlyTheRunningTime) {
    int cold = 0;
    int warm = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Outline a = randomPolygon(random, 1.0f);
        const Outline b = randomPolygon(random, 1.0f);
        const Convex convexA = convexOf(a.geometry, a.corners);
        const Convex convexB = convexOf(b.geometry, b.corners);
        // random invalid indices
        SimplexCache cache{static_cast<std::uint8_t>(random.below(256)), {200, 1, 7}, {0, 99, 3}};
        Frame frame{{2.5f, 0.0f}, randomRotation(random)};
        for (int i = 0; i < 20; ++i) {
            frame.position += {-0.05f, 0.01f};
            frame.rotation = frame.rotation * rotFromAngle(0.02f);
            const Distance with = distanceBetween(convexA, convexB, frame, &cache);
            const Distance without = distanceBetween(convexA, convexB, frame);
            EXPECT_NEAR(with.distance, without.distance, 2e-5f);
            if (i == 0) continue;
            warm += with.iterations;
            cold += without.iterations;
        }
    }
    EXPECT_LT(warm, cold);
}

TEST(DistanceProperty, isEquallyPreciseFromAMillimetreToAKilometre) {
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const float size = seed % 2 == 0 ? 0.001f : 1000.0f;
        const Outline a = randomOutline(random, kConvexKinds[random.below(5)], size);
        const Outline b = randomOutline(random, kConvexKinds[random.below(5)], size);
        const Frame frame = randomFrame(random, 2.0f * size);
        const Convex convexA = convexOf(a.geometry, a.corners);
        const Convex convexB = convexOf(b.geometry, b.corners);
        const Distance found = distanceBetween(convexA, convexB, frame);
        EXPECT_NEAR(found.distance / size, widestGapOf(convexA, convexB, frame) / size, 5e-5f);
    }
}

TEST(Distance, coincidingOutlinesHaveADepthAndANormal) {
    const Outline hexagon = regularPolygon(6, 1.0f);
    const Geometry all[] = {circle(1.0f), capsule({-1, 0}, {1, 0}, 0.5f), box({1, 2}), hexagon.geometry,
                            segment({-1, 0}, {1, 0})};
    const float depth[5][5] = {{2.0f, 1.5f, 2.0f, 1.8660254f, 1.0f},
                               {1.5f, 1.0f, 2.5f, 1.3660254f, 0.5f},
                               {2.0f, 2.5f, 2.0f, 2.0f, 2.0f},
                               {1.8660254f, 1.3660254f, 2.0f, 1.7320508f, 0.8660254f},
                               {1.0f, 0.5f, 2.0f, 0.8660254f, 0.0f}};
    for (int i = 0; i < 5; ++i) {
        for (int k = 0; k < 5; ++k) {
            SCOPED_TRACE(i * 10 + k);
            const Distance found =
                distanceBetween(convexOf(all[i], hexagon.corners), convexOf(all[k], hexagon.corners), {});
            EXPECT_NEAR(found.distance, -depth[i][k], 1e-5f);
            EXPECT_NEAR(length(found.normal), 1.0f, 1e-6f);
        }
    }
}

}  // namespace
}  // namespace plumb::physics
