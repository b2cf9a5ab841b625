#include "physics/shapes/shape_types.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "tests/physics/support/random_shapes.hpp"

namespace plumb::physics {
namespace {

using namespace test;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(ShapeTypes, kindsHaveUniqueNames) {
    std::vector<std::string_view> names;
    for (int kind = 0; kind < static_cast<int>(ShapeKind::Count); ++kind) {
        const ShapeType& type = shapeTypeOf(static_cast<ShapeKind>(kind));
        EXPECT_FALSE(type.name.empty());
        for (const std::string_view other : names) EXPECT_NE(type.name, other);
        names.push_back(type.name);
    }
}

TEST(MassProperties, ofSimpleOutlinesFollowTheFormulas) {
    const MassProperties disc = massProperties(circle(2.0f, {5.0f, 1.0f}), {}, 3.0f);
    EXPECT_NEAR(disc.mass, 3.0f * kPi * 4.0f, 1e-5f);
    EXPECT_NEAR(disc.inertia, 0.5f * disc.mass * 4.0f, 1e-4f);
    EXPECT_EQ(disc.centre, (Vec2{5.0f, 1.0f}));

    const MassProperties block =
        massProperties(box({0.5f, 1.5f}, {-2.0f, 0.0f}, rotFromAngle(0.3f)), {}, 2.0f);
    EXPECT_NEAR(block.mass, 6.0f, 1e-5f);
    EXPECT_NEAR(block.inertia, block.mass * (1.0f + 9.0f) / 12.0f, 1e-5f);
    EXPECT_NEAR(block.centre.x, -2.0f, 1e-6f);

    // A box of 2 x 1 m between two half discs of radius 0.5 m, whose centroids are 4 r / (3 pi) from their
    // flat sides.
    const MassProperties pill = massProperties(capsule({0.0f, 1.0f}, {2.0f, 1.0f}, 0.5f), {}, 1.0f);
    const float half = kPi * 0.125f;
    const float out = 4.0f * 0.5f / (3.0f * kPi);
    const float ends = 2.0f * (half * (0.125f - out * out) + half * (1.0f + out) * (1.0f + out));
    EXPECT_NEAR(pill.mass, 2.0f + 2.0f * half, 1e-5f);
    EXPECT_NEAR(pill.inertia, 2.0f * (4.0f + 1.0f) / 12.0f + ends, 1e-5f);
    EXPECT_NEAR(pill.centre.x, 1.0f, 1e-6f);

    const Outline hexagon = regularPolygon(6, 1.0f);
    const MassProperties six = massProperties(hexagon.geometry, hexagon.corners, 1.0f);
    EXPECT_NEAR(six.mass, 2.5980762f, 1e-6f);
    EXPECT_NEAR(six.inertia, 1.0825318f, 1e-5f);  // 5 sqrt(3) / 8 for a regular hexagon

    EXPECT_EQ(massProperties(segment({0, 0}, {2, 2}), {}, 1.0f).mass, 0.0f);
    EXPECT_EQ(massProperties(segment({0, 0}, {2, 2}), {}, 1.0f).centre, (Vec2{1, 1}));
    EXPECT_EQ(massProperties(circle(1.0f), {}, -1.0f).mass, 0.0f);
    EXPECT_EQ(massProperties(circle(1.0f), {}, kNan).mass, 0.0f);
}

/// Computes mass properties by integration over horizontal slices, each between the hits of rays from the
/// left and from the right.
MassProperties sliced(const Outline& outline, int slices) {
    const AABB box = boundsOf(outline.geometry, outline.corners, {});
    const double height = static_cast<double>(box.size().y) / slices;
    const float wide = box.size().x + 2.0f;
    double area = 0.0, x = 0.0, y = 0.0, second = 0.0;
    for (int i = 0; i < slices; ++i) {
        const double at = static_cast<double>(box.min.y) + (i + 0.5) * height;
        const float left = box.min.x - 1.0f;
        const auto enter = castRay(outline.geometry, outline.corners, {{left, float(at)}, {wide, 0.0f}});
        const auto leave =
            castRay(outline.geometry, outline.corners, {{left + wide, float(at)}, {-wide, 0.0f}});
        if (!enter || !leave) continue;
        const double from = static_cast<double>(left + enter->fraction * wide);
        const double to = static_cast<double>(left + wide - leave->fraction * wide);
        area += (to - from) * height;
        x += (to * to - from * from) / 2.0 * height;
        y += (to - from) * at * height;
        second += ((to * to * to - from * from * from) / 3.0 + (to - from) * at * at) * height;
    }
    const Vec2 centre{static_cast<float>(x / area), static_cast<float>(y / area)};
    return {static_cast<float>(area), centre, static_cast<float>(second - (x * x + y * y) / area)};
}

TEST(MassPropertiesProperty, equalAnIntegrationOverSlices) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Outline outline = randomOutline(random, kSolidKinds[seed % 4], 1.0f);
        const MassProperties exact = massProperties(outline.geometry, outline.corners, 1.0f);
        const MassProperties sum = sliced(outline, 4000);
        EXPECT_NEAR(exact.mass, sum.mass, 2e-3f * sum.mass);
        EXPECT_NEAR(exact.inertia, sum.inertia, 3e-3f * sum.inertia);
        EXPECT_LT(distance(exact.centre, sum.centre), 1e-3f);
        EXPECT_GT(exact.inertia, 0.0f);
    }
}

/// Returns points on the boundary of an outline, found by rays from outside.
std::vector<Vec2> placesOnTheEdge(const Outline& outline) {
    const Vec2 middle = convexOf(outline.geometry, outline.corners).centre;
    std::vector<Vec2> places;
    for (int i = 0; i < 400; ++i) {
        const SinCos at = sinCos(kTau * static_cast<float>(i) / 400.0f);
        const Vec2 out = Vec2{at.cos, at.sin} * 10.0f;
        if (const auto hit = castRay(outline.geometry, outline.corners, {middle + out, -out})) {
            places.push_back(middle + out * (1.0f - hit->fraction));
        }
    }
    return places;
}

TEST(ClosestPointProperty, isTheNearestPointOfTheBoundary) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Outline outline = randomOutline(random, kSolidKinds[seed % 4], 1.0f);
        const std::vector<Vec2> edge = placesOnTheEdge(outline);
        ASSERT_EQ(edge.size(), 400u);
        for (int i = 0; i < 20; ++i) {
            const Vec2 place = randomPoint(random, 2.0f);
            const ClosestPoint closest = closestPoint(outline.geometry, outline.corners, place);
            EXPECT_NEAR(length(closest.normal), 1.0f, 1e-5f);
            EXPECT_LT(distance(closest.point + closest.normal * closest.distance, place), 1e-5f);
            EXPECT_NEAR(closestPoint(outline.geometry, outline.corners, closest.point).distance, 0.0f, 1e-5f);
            for (const Vec2 other : edge)
                EXPECT_GT(distance(other, place), std::fabs(closest.distance) - 1e-4f);
            EXPECT_EQ(containsPoint(outline.geometry, outline.corners, place), closest.distance <= 0.0f);
            EXPECT_EQ(coreOf(outline.geometry, outline.corners, place), std::fmax(0.0f, -closest.distance));
        }
    }
}

TEST(BoundsProperty, touchTheRotatedOutlineOnAllFourSides) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Outline outline = randomOutline(random, kConvexKinds[seed % 5], 1.0f);
        const Frame frame = randomFrame(random, 10.0f);
        const AABB box = boundsOf(outline.geometry, outline.corners, frame);
        const Convex convex = convexOf(outline.geometry, outline.corners);
        const auto extent = [&](Vec2 direction) {
            const Vec2 local = unrotate(frame.rotation, direction);
            const auto corner = static_cast<std::size_t>(farthest(convex.corners(), local));
            return dot(apply(frame, convex.corners()[corner].point), direction) + convex.radius;
        };
        EXPECT_NEAR(box.max.x, extent({1, 0}), 1e-5f);
        EXPECT_NEAR(-box.min.x, extent({-1, 0}), 1e-5f);
        EXPECT_NEAR(box.max.y, extent({0, 1}), 1e-5f);
        EXPECT_NEAR(-box.min.y, extent({0, -1}), 1e-5f);
    }
}

TEST(ReachProperty, isTheDistanceOfTheFarthestBoundaryPoint) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Outline outline = randomOutline(random, kSolidKinds[seed % 4], 1.0f);
        const Vec2 from = randomPoint(random, 3.0f);
        float farthest = 0.0f;
        for (const Vec2 place : placesOnTheEdge(outline))
            farthest = std::fmax(farthest, distance(place, from));
        const float reach = reachOf(outline.geometry, outline.corners, from);
        EXPECT_GE(reach, farthest - 1e-5f);
        EXPECT_LT(reach, farthest + 0.05f);  // tolerance: the points are some centimeters apart
    }
}

TEST(CastRayProperty, hitsTheBoundaryAndNothingBefore) {
    int hits = 0;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Outline outline = randomOutline(random, kSolidKinds[seed % 4], 1.0f);
        const Vec2 from = randomPoint(random, 3.0f);
        const Ray ray{from, (randomPoint(random, 1.0f) - from) * 1.5f};
        const auto hit = castRay(outline.geometry, outline.corners, ray);
        if (hit && hit->fraction == 0.0f) {
            EXPECT_TRUE(containsPoint(outline.geometry, outline.corners, ray.from));
            continue;
        }
        const float until = hit ? hit->fraction : 1.0f;
        for (int i = 0; i < 50; ++i) {
            const float fraction = until * static_cast<float>(i) / 50.0f;
            const Vec2 place = ray.from + ray.displacement * fraction;
            EXPECT_GT(closestPoint(outline.geometry, outline.corners, place).distance, -1e-4f);
        }
        if (!hit) continue;
        ++hits;
        const ClosestPoint closest =
            closestPoint(outline.geometry, outline.corners, ray.from + ray.displacement * until);
        EXPECT_NEAR(closest.distance, 0.0f, 1e-5f);
        EXPECT_NEAR(length(hit->normal), 1.0f, 1e-5f);
        EXPECT_LT(dot(hit->normal, ray.displacement), 0.0f);
    }
    EXPECT_GT(hits, 300);
}

TEST(CastRay, startingInsideHasFractionZeroAndChainsAreOneSided) {
    EXPECT_EQ(castRay(box({1, 1}), {}, {{0.9f, 0.0f}, {5, 0}})->fraction, 0.0f);
    EXPECT_EQ(castRay(box({1, 1}), {}, {{0.9f, 0.0f}, {5, 0}})->normal, (Vec2{1, 0}));
    EXPECT_FALSE(castRay(circle(1.0f), {}, {{2, 0}, {}}).has_value());

    Geometry chain = segment({0, 0}, {2, 0});
    EXPECT_TRUE(castRay(chain, {}, {{1, -1}, {0, 2}}).has_value());
    EXPECT_TRUE(castRay(chain, {}, {{1, 1}, {0, -2}}).has_value());
    chain.kind = ShapeKind::ChainSegment;
    EXPECT_EQ(normalOfChain(chain), (Vec2{0, -1}));
    ASSERT_TRUE(castRay(chain, {}, {{1, -1}, {0, 2}}).has_value());
    EXPECT_EQ(castRay(chain, {}, {{1, -1}, {0, 2}})->normal, (Vec2{0, -1}));
    EXPECT_EQ(castRay(chain, {}, {{1, -1}, {0, 2}})->fraction, 0.5f);
    EXPECT_FALSE(castRay(chain, {}, {{1, 1}, {0, -2}}).has_value());
}

TEST(CastRay, aRayOfAHundredKilometresHitsAPea) {
    const auto hit = castRay(circle(0.005f, {1000.0f, 0.002f}), {}, {{}, {1.0e5f, 0.0f}});
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->fraction * 1.0e5f, 1000.0f - 0.0045826f, 1e-3f);
    EXPECT_NEAR(hit->normal.y, -0.4f, 1e-3f);
}

TEST(CheckGeometry, acceptsValidOutlinesAndNamesTheInvalidMember) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Outline outline = randomOutline(random, kConvexKinds[seed % 5], random.between(0.01f, 1000.0f));
        const auto checked = checkGeometry(outline.geometry, outline.corners);
        EXPECT_TRUE(checked.ok()) << checked.error().text();
    }
    const auto refusal = [](const Geometry& geometry, std::span<const Corner> corners = {}) {
        const auto checked = checkGeometry(geometry, corners);
        return checked.ok() ? std::string{} : checked.error().where;
    };
    EXPECT_EQ(refusal(circle(kNan)), "circle.radius");
    EXPECT_EQ(refusal(circle(0.0f)), "circle.radius");
    EXPECT_EQ(refusal(circle(-1.0f)), "circle.radius");
    EXPECT_EQ(refusal(circle(1.0f, {0.0f, kNan})), "circle.a");
    EXPECT_EQ(refusal(capsule({}, {1e7f, 0}, 1.0f)), "capsule.b");
    EXPECT_EQ(refusal(box({1.0f, 0.0f})), "box.b.y");
    EXPECT_EQ(refusal(box({1.0f, 1.0f}, {}, {0.0f, 0.0f})), "box.rotation");
    EXPECT_EQ(refusal(box({1.0f, 1.0f}, {}, {}, -0.1f)), "box.radius");
    EXPECT_EQ(refusal(segment({1, 1}, {1, 1})), "segment length");
    Outline hexagon = regularPolygon(6, 1.0f);
    EXPECT_EQ(refusal(hexagon.geometry), "polygon.first");
    std::swap(hexagon.corners[0], hexagon.corners[3]);
    EXPECT_EQ(refusal(hexagon.geometry, hexagon.corners), "polygon.corners");
    hexagon.geometry.count = 2;
    EXPECT_EQ(refusal(hexagon.geometry, hexagon.corners), "polygon.count");
}

}  // namespace
}  // namespace plumb::physics
