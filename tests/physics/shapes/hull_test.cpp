#include "physics/shapes/hull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/physics/support/random_shapes.hpp"

namespace plumb::physics {
namespace {

using namespace test;

TEST(HullProperty, aHullContainsAllPointsAndIsConvex) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const float size = random.between(0.001f, 1000.0f);
        std::vector<Vec2> points;
        for (std::uint32_t i = 0; i < 3 + random.below(200); ++i) points.push_back(randomPoint(random, size));
        const auto hull = makeHull(points);
        ASSERT_TRUE(hull.ok()) << hull.error().text();
        for (std::size_t i = 0; i < hull->corners.size(); ++i) {
            const Corner& corner = hull->corners[i];
            const Vec2 next = hull->corners[(i + 1) % hull->corners.size()].point;
            const Vec2 after = hull->corners[(i + 2) % hull->corners.size()].point;
            EXPECT_GT(cross(next - corner.point, after - next), 0.0f);
            EXPECT_NEAR(lengthSquared(corner.normal), 1.0f, 1e-6f);
            EXPECT_NEAR(dot(corner.normal, next - corner.point), 0.0f, 1e-6f * size);
            for (const Vec2 point : points) {
                EXPECT_LT(dot(corner.normal, point - corner.point),
                          3e-5f * size);  // smaller protrusions may be omitted
            }
        }
    }
}

TEST(HullProperty, theOrderOfThePointsDoesNotMatter) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        std::vector<Vec2> points;
        for (int i = 0; i < 20; ++i) points.push_back(randomPoint(random, 1.0f));
        const auto hull = makeHull(points);
        for (std::uint32_t i = 19; i > 0; --i) std::swap(points[i], points[random.below(i + 1)]);
        const auto again = makeHull(points);
        ASSERT_TRUE(hull.ok() && again.ok());
        EXPECT_EQ(hull->corners, again->corners);
    }
}

TEST(Hull, duplicatesAndPointsOnASideAreNoCorners) {
    const Vec2 points[] = {{0, 0}, {1, 0},     {2, 0},     {2, 2}, {0, 2}, {0, 2},
                           {1, 2}, {2, 1e-6f}, {1e-6f, 0}, {1, 1}, {0, 1}, {2.000001f, 2}};
    const auto hull = makeHull(points);

    ASSERT_TRUE(hull.ok());
    EXPECT_EQ(hull->corners.size(), 4u);
    EXPECT_NEAR(hull->area, 4.0f, 1e-5f);
    EXPECT_NEAR(hull->centroid.x, 1.0f, 1e-5f);
    EXPECT_NEAR(hull->centroid.y, 1.0f, 1e-5f);
    for (const Corner& corner : hull->corners) EXPECT_GT(dot(corner.normal, corner.point - Vec2{1, 1}), 0.9f);
}

TEST(Hull, aHullFarFromTheOriginKeepsItsAreaAndCentroid) {
    const Vec2 at{4096.0f, -2048.0f};
    const Vec2 points[] = {at, at + Vec2{0.5f, 0.0f}, at + Vec2{0.5f, 0.25f}, at + Vec2{0.0f, 0.25f}};
    const auto hull = makeHull(points);

    ASSERT_TRUE(hull.ok());
    EXPECT_EQ(hull->area, 0.125f);
    EXPECT_EQ(hull->centroid, (at + Vec2{0.25f, 0.125f}));
}

TEST(Hull, invalidPolygonsAreRejectedWithTheirReason) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const auto refusal = [](std::vector<Vec2> points) {
        const auto hull = makeHull(points);
        return hull.ok() ? std::string{} : hull.error().text();
    };
    EXPECT_NE(refusal({}).find("form no area"), std::string::npos);
    EXPECT_NE(refusal({{0, 0}, {1, 0}}).find("form no area"), std::string::npos);
    EXPECT_NE(refusal({{1, 1}, {1, 1}, {1, 1}, {2, 2}}).find("form no area"), std::string::npos);
    EXPECT_NE(refusal({{0, 0}, {1, 1}, {2, 2}, {3, 3}}).find("form no area"), std::string::npos);
    EXPECT_NE(refusal({{0, 0}, {1, 0}, {2, 1e-6f}}).find("too thin"), std::string::npos);
    EXPECT_NE(refusal({{0, 0}, {1, nan}, {2, 1}}).find("point 1 is (1, nan)"), std::string::npos);
    EXPECT_NE(refusal({{0, 0}, {1, 0}, {infinity, 1}}).find("point 2"), std::string::npos);
    EXPECT_NE(refusal({{0, 0}, {2e6f, 0}, {0, 1}}).find("further than"), std::string::npos);
    EXPECT_NE(refusal({{0, 0}, {2e-5f, 0}, {0, 2e-5f}}).find("large"), std::string::npos);

    std::vector<Vec2> circle;
    for (int i = 0; i < 40; ++i) {
        const SinCos at = sinCos(kTau * static_cast<float>(i) / 40.0f);
        circle.push_back({at.cos, at.sin});
    }
    EXPECT_NE(refusal(circle).find("found 40 corners, expected at most 32"), std::string::npos);
}

TEST(HullProperty, anyFloatsGiveAHullOrAnError) {
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Vec2 pool[] = {{0, 0},  {1e-30f, 1},   {1, 1e-7f},     {1, 0},
                             {-1, 1}, {1e6f, -1e6f}, {1e-5f, 1e-5f}, {1, 1}};
        std::vector<Vec2> points;
        for (std::uint32_t i = 0; i < random.below(8); ++i) points.push_back(pool[random.below(8)]);
        const auto hull = makeHull(points);
        if (!hull) continue;
        EXPECT_GE(hull->corners.size(), 3u);
        EXPECT_GT(hull->area, 0.0f);
        EXPECT_TRUE(isFinite(hull->centroid));
        const Outline outline = outlineOf(*hull);
        EXPECT_TRUE(checkGeometry(outline.geometry, outline.corners).ok());
    }
}

}  // namespace
}  // namespace plumb::physics
