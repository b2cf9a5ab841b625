#include "tests/bench/physics/overlap.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "math/portable.hpp"

namespace plumb::scenes {
namespace {

constexpr double kTolerance = 1e-6;  // m; outlines are stored as floats

Pose at(double x, double y, double angle = 0.0) { return {x, y, std::cos(angle), std::sin(angle)}; }

double overlap(const Outline& a, const Pose& poseA, const Outline& b, const Pose& poseB) {
    return overlapOf(place(a, poseA), place(b, poseB));
}

TEST(Overlap, theDepthOfABoxInABoxIsItsShortestWayOut) {
    const Outline unit = box({0.5f, 0.5f});

    EXPECT_NEAR(overlap(unit, at(0, 0), unit, at(0.9, 0.3)), 0.1, kTolerance);
    EXPECT_NEAR(overlap(unit, at(0, 0), unit, at(0.2, -0.75)), 0.25, kTolerance);
    EXPECT_EQ(overlap(unit, at(0, 0), unit, at(1.01, 0.0)), 0.0);
}

TEST(Overlap, roundOutlinesAreMeasuredBetweenTheirCores) {
    const Outline ball = circle(0.5f);
    const Outline pill = capsule({-1.0f, 0.0f}, {1.0f, 0.0f}, 0.25f);
    const Outline rounded = box({0.5f, 0.5f}, {}, 0.1f);

    EXPECT_NEAR(overlap(ball, at(0, 0), ball, at(0.6, 0.0)), 0.4, kTolerance);
    EXPECT_NEAR(overlap(ball, at(0, 0), ball, at(0.0, 0.0)), 1.0, kTolerance);
    EXPECT_NEAR(overlap(pill, at(0, 0), ball, at(0.3, 0.7)), 0.05, kTolerance);
    EXPECT_NEAR(overlap(pill, at(0, 0), ball, at(1.6, 0.0)), 0.15, kTolerance);
    // At a corner the distance to the corner counts, not that to a face.
    EXPECT_NEAR(overlap(rounded, at(0, 0), ball, at(0.9, 0.9)), 0.6 - std::hypot(0.4, 0.4), kTolerance);
    EXPECT_EQ(overlap(rounded, at(0, 0), ball, at(0.95, 0.95)), 0.0);
}

TEST(Overlap, capsulesInOneLineAreApartByTheirEnds) {
    const Outline pill = capsule({-0.5f, 0.0f}, {0.5f, 0.0f}, 0.1f);

    EXPECT_NEAR(overlap(pill, at(0, 0), pill, at(1.15, 0.0)), 0.05, kTolerance);
    EXPECT_EQ(overlap(pill, at(0, 0), pill, at(1.25, 0.0)), 0.0);
}

TEST(Overlap, aChainSegmentIsSolidOnItsLeftOnly) {
    Outline line = segment({-5.0f, 0.0f}, {5.0f, 0.0f});
    line.kind = OutlineKind::ChainSegment;  // y points up: it is solid above
    const Outline ball = circle(0.5f);

    EXPECT_NEAR(overlap(line, at(0, 0), ball, at(0.0, -0.4)), 0.1, kTolerance);
    EXPECT_NEAR(overlap(line, at(0, 0), ball, at(0.0, 0.3)), 0.8, kTolerance);
    EXPECT_EQ(overlap(line, at(0, 0), ball, at(0.0, -0.6)), 0.0);
}

/// Creates a convex outline whose corners are on a circle.
Outline randomOutline(Random& random) {
    if (random.below(4) == 0) return circle(random.between(0.1f, 0.6f));
    if (random.below(3) == 0)
        return capsule({random.between(-0.5f, 0.0f), 0.0f}, {random.between(0.1f, 0.5f), 0.2f},
                       random.between(0.05f, 0.3f));
    Vec2 points[6];
    float angle = 0.0f;
    for (Vec2& point : points) {
        angle += random.between(0.4f, 1.0f);
        point = random.between(0.6f, 0.7f) * Vec2{cosine(angle), sine(angle)};
    }
    return polygon(points, random.below(2) == 0 ? 0.0f : 0.1f);
}

// By definition: some displacement of this length separates the outlines, and no shorter one does.
TEST(Overlap, isTheShortestSeparatingDisplacement) {
    constexpr int kDirections = 720;
    int overlapping = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Outline a = randomOutline(random);
        const Outline b = randomOutline(random);
        const Pose pose = at(static_cast<double>(random.between(-0.9f, 0.9f)),
                             static_cast<double>(random.between(-0.9f, 0.9f)),
                             static_cast<double>(random.between(-3.0f, 3.0f)));
        const double depth = overlap(a, at(0, 0), b, pose);
        ASSERT_NEAR(depth, overlap(b, pose, a, at(0, 0)), kTolerance);
        if (depth == 0.0) continue;
        ++overlapping;
        bool parts = false;
        for (int i = 0; i < kDirections; ++i) {
            const double angle = 2.0 * 3.14159265358979 * i / kDirections;
            const auto moved = [&](double way) {
                return overlap(
                    a, at(0, 0), b,
                    {pose.x + way * std::cos(angle), pose.y + way * std::sin(angle), pose.cos, pose.sin});
            };
            ASSERT_GT(moved(0.99 * depth), 0.0);
            parts = parts || moved(1.01 * depth + kTolerance) == 0.0;
        }
        EXPECT_TRUE(parts);
    }
    EXPECT_GT(overlapping, 50);
}

}  // namespace
}  // namespace plumb::scenes
