#include <limits>

#include <gtest/gtest.h>

#include "physics/narrowphase/collide.hpp"
#include "physics/narrowphase/distance.hpp"
#include "tests/physics/support/random_shapes.hpp"

namespace plumb::physics {
namespace {

using namespace test;

constexpr float kFar = 0.02f;  // maximum gap at which contact points are created, m

/// Builds the chain segments between successive points; closed chains end at their first point.
std::vector<Geometry> chainOf(const std::vector<Vec2>& points, bool closed) {
    std::vector<Geometry> chain;
    const std::size_t n = points.size();
    for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
        const Vec2 before = i > 0 || closed ? points[(i + n - 1) % n] : points[0];
        const Vec2 after = i + 2 < n || closed ? points[(i + 2) % n] : points[(i + 1) % n];
        chain.push_back(chainSegment(before, points[i], points[(i + 1) % n], after));
    }
    return chain;
}

struct Touch {
    Vec2 normal;  ///< points out of the chain
    float separation = 0.0f;
    std::size_t segment = 0;
};

/// Returns all contact points of an outline, placed at a frame, with a chain. They are computed in both
/// argument orders, which must agree.
std::vector<Touch> touches(const std::vector<Geometry>& chain, const Outline& outline, const Frame& frame) {
    std::vector<Touch> all;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const Manifold there = collide(chain[i], outline.geometry, outline.corners, frame, kFar);
        const Manifold back = collide(outline.geometry, chain[i], outline.corners, inverse(frame), kFar);
        EXPECT_EQ(there.count, back.count);
        for (int k = 0; k < there.count; ++k) {
            EXPECT_NEAR(length(there.normal), 1.0f, 1e-5f);
            all.push_back({there.normal, there.points[k].separation, i});
        }
    }
    return all;
}

float least(const std::vector<Touch>& all) {
    float least = std::numeric_limits<float>::infinity();
    for (const Touch& touch : all) least = std::fmin(least, touch.separation);
    return least;
}

bool isBetween(Vec2 from, Vec2 direction, Vec2 to) {
    return cross(from, direction) > -1e-3f && cross(direction, to) > -1e-3f;
}

TEST(CollideChainProperty, aClosedConvexChainIsTouchedLikeTheSolidPolygon) {
    int touching = 0;
    for (std::uint64_t seed = 1; seed <= 5000; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Outline ground = randomPolygon(random, 2.0f);
        std::vector<Vec2> points;
        for (const Corner& corner : ground.corners) points.push_back(corner.point);
        const std::vector<Geometry> chain = chainOf(points, true);
        const Outline outline = randomOutline(random, kConvexKinds[seed % 5], 1.0f);
        const Convex solid = convexOf(ground.geometry, ground.corners);
        const Convex other = convexOf(outline.geometry, outline.corners);
        Frame frame = randomFrame(random, 4.0f);
        const Distance apart = distanceBetween(solid, other, frame);
        if (apart.distance < 0.0f) continue;
        frame.position -= apart.normal * (apart.distance - random.between(-0.02f, 0.025f));
        if (containsPoint(ground.geometry, ground.corners, apply(frame, other.centre)))
            continue;  // the shape is behind the chain
        const float distance = distanceBetween(solid, other, frame).distance;
        const std::vector<Touch> all = touches(chain, outline, frame);
        if (distance > kFar + 1e-4f) {
            EXPECT_TRUE(all.empty());
            continue;
        }
        if (distance > kFar - 2e-3f || std::fabs(distance) < 2e-5f) continue;
        ++touching;
        EXPECT_NEAR(least(all), distance, 1e-3f);  // tolerance: the chain's own face is preferred over others
        for (const Touch& touch : all) {
            const Geometry& segment = chain[touch.segment];
            const Vec2 before = chain[(touch.segment + chain.size() - 1) % chain.size()].a;
            const Vec2 own = normalOfChain(segment);
            const Vec2 previous = normalized(Vec2{segment.a.y - before.y, before.x - segment.a.x});
            EXPECT_TRUE(isBetween(previous, touch.normal, own));
        }
    }
    EXPECT_GT(touching, 1000);
}

TEST(CollideChainProperty, jointsOfAFlatFloorHaveNoEffect) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const float tilt = random.between(-1.0f, 1.0f);
        const Rot rotation = rotFromAngle(tilt);
        std::vector<Vec2> points;
        for (float x = -20.0f; x < 20.0f; x += random.between(0.05f, 3.0f))
            points.push_back(rotate(rotation, {-x, 0.0f}));
        const std::vector<Geometry> floor = chainOf(points, false);
        const Vec2 up = normalOfChain(floor[0]);
        const Outline outline = randomOutline(random, kConvexKinds[seed % 5], 1.0f);
        const Convex convex = convexOf(outline.geometry, outline.corners);
        const Rot posture = randomRotation(random);
        const float depth = random.between(0.0f, 0.01f);
        for (float x = -10.0f; x < 10.0f; x += 0.037f) {
            // Lower the outline until its lowest corner is `depth` deep in the floor.
            Frame frame{rotate(rotation, {x, 0.0f}), posture};
            const auto lowest = static_cast<std::size_t>(farthest(convex.corners(), -unrotate(posture, up)));
            const float height = dot(apply(frame, convex.corners()[lowest].point), up) - convex.radius;
            frame.position -= up * (height + depth);
            const std::vector<Touch> all = touches(floor, outline, frame);
            ASSERT_FALSE(all.empty());
            EXPECT_NEAR(least(all), -depth, 1e-4f);
            for (const Touch& touch : all) EXPECT_GT(dot(touch.normal, up), 0.99999f);
        }
    }
}

TEST(CollideChain, aBoxInAnInnerCornerTouchesOnlyFloorAndWall) {
    // In screen coordinates: the floor runs to the right, then the wall goes up.
    const std::vector<Geometry> room = chainOf({{-5, 0}, {-2, 0}, {0, 0}, {2, 0}, {2, -2}, {2, -5}}, false);
    const Outline crate{box({0.5f, 0.5f}), {}};
    EXPECT_EQ(normalOfChain(room[0]), (Vec2{0, -1}));
    EXPECT_EQ(normalOfChain(room[3]), (Vec2{-1, 0}));
    bool wall = false;
    for (float x = -4.0f; x < 1.508f; x += 0.013f) {
        bool floor = false;
        for (const Touch& touch : touches(room, crate, {{x, -0.497f}, {}})) {
            const bool upright = touch.normal == Vec2{0, -1};
            EXPECT_TRUE(upright || (touch.normal == Vec2{-1, 0} && touch.segment >= 3));
            EXPECT_NEAR(touch.separation, upright ? -0.003f : 1.5f - x, 1e-5f);
            floor = floor || upright;
            wall = wall || !upright;
        }
        EXPECT_TRUE(floor);
    }
    EXPECT_TRUE(wall);
}

TEST(CollideChainProperty, aBallOnAnyTerrainTouchesAtTheNearestPoint) {
    int touching = 0;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        std::vector<Vec2> points;
        for (float x = -5.0f; x < 5.0f; x += random.between(0.2f, 1.0f))
            points.push_back({x, random.between(-0.5f, 0.5f)});
        const std::vector<Geometry> ground = chainOf(points, false);
        const float radius = random.between(0.05f, 1.0f);
        const Vec2 centre{random.between(-4.0f, 4.0f), random.between(-2.0f, 0.5f)};
        float nearest = 1e9f;
        std::size_t closest = 0;
        Vec2 out;
        for (std::size_t i = 0; i < ground.size(); ++i) {
            const ClosestPoint place = closestPoint(ground[i], {}, centre);
            if (place.distance >= nearest) continue;
            nearest = place.distance;
            closest = i;
            out = place.normal;
        }
        if (dot(out, normalOfChain(ground[closest])) < 0.01f) continue;  // the ball is below the ground
        const std::vector<Touch> all = touches(ground, {circle(radius, centre), {}}, {});
        if (nearest - radius > kFar) {
            EXPECT_TRUE(all.empty());
            continue;
        }
        ++touching;
        EXPECT_NEAR(least(all), nearest - radius, 1e-5f);
        for (const Touch& touch : all) {
            EXPECT_TRUE(touch.separation > nearest - radius + 1e-6f || dot(touch.normal, out) > 0.999f);
        }
    }
    EXPECT_GT(touching, 300);
}

TEST(CollideChainProperty, theSeparationFromAnyTerrainIsThatOfTheNearestSegment) {
    int touching = 0;
    for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        std::vector<Vec2> points;
        for (float x = -5.0f; x < 5.0f; x += random.between(0.2f, 1.0f)) {
            points.push_back({x, random.between(-0.5f, 0.5f)});
        }
        const std::vector<Geometry> ground = chainOf(points, false);
        const Outline outline = randomOutline(random, kConvexKinds[seed % 5], 0.7f);
        const Convex convex = convexOf(outline.geometry, outline.corners);
        const auto nearest = [&](const Frame& frame) {
            float least = 1e9f;
            for (const Geometry& segment : ground) {
                least = std::fmin(least, distanceBetween(convexOf(segment, {}), convex, frame).distance);
            }
            return least;
        };
        // Lowers the outline from above (y points down) until the gap is as small as wanted.
        Frame frame{{random.between(-2.0f, 2.0f), -5.0f}, randomRotation(random)};
        const float gap = random.between(0.0f, 0.018f);
        for (int i = 0; i < 200; ++i) frame.position.y += std::fmax(0.0f, nearest(frame) - gap);
        const float distance = nearest(frame);
        if (distance > gap + 1e-3f) continue;
        ++touching;
        EXPECT_NEAR(least(touches(ground, outline, frame)), distance, 1e-3f);
    }
    EXPECT_GT(touching, 2000);
}

TEST(CollideChain, doesNotCollideFromBehind) {
    const std::vector<Geometry> floor = chainOf({{-2, 0}, {-1, 0}, {1, 0}, {2, 0}}, false);
    const Outline hexagon = regularPolygon(6, 0.5f);
    for (const Geometry& shape :
         {circle(0.5f), box({0.5f, 0.5f}), capsule({-0.2f, 0}, {0.2f, 0}, 0.4f), hexagon.geometry}) {
        const Outline outline{shape, hexagon.corners};
        // y points down, so the outline is above the floor.
        EXPECT_FALSE(touches(floor, outline, {{0.1f, -0.39f}, {}}).empty());
        EXPECT_TRUE(touches(floor, outline, {{0.1f, 0.45f}, {}}).empty());
        EXPECT_TRUE(touches(floor, outline, {{0.1f, 0.1f}, {}}).empty());
    }
}

TEST(CollideChain, aFreeEndActsAsASquareCorner) {
    const std::vector<Geometry> ledge = chainOf({{0, 0}, {1, 0}}, false);
    const Outline ball{circle(0.25f), {}};
    const std::vector<Touch> diagonal = touches(ledge, ball, {{1.15f, -0.2f}, {}});
    ASSERT_EQ(diagonal.size(), 1u);
    EXPECT_NEAR(diagonal[0].normal.x, 0.6f, 1e-5f);
    EXPECT_NEAR(diagonal[0].separation, 0.0f, 1e-6f);
    EXPECT_EQ(touches(ledge, ball, {{-0.15f, -0.2f}, {}}).size(), 1u);
    EXPECT_EQ(touches(ledge, ball, {{1.2f, 0.1f}, {}}).size(), 0u);

    // A crate at the edge tips over the corner as soon as its center has passed the edge.
    const Outline crate{box({0.5f, 0.5f}), {}};
    const std::vector<Touch> tipping = touches(ledge, crate, {{1.0f, -0.5f}, rotFromAngle(0.3f)});
    ASSERT_FALSE(tipping.empty());
    EXPECT_NEAR(tipping[0].normal.x, sine(0.3f), 1e-5f);
}

TEST(CollideChainProperty, aCrateTipsOverALedgeWithoutFallingThrough) {
    // As long as the crate stands on the ledge, its center is behind the plane of the ledge's side wall, so
    // the crate cannot touch this wall.
    const std::vector<Geometry> ledge = chainOf({{-3, 3}, {-3, 0}, {0, 0}, {0, 3}}, false);
    const Convex solid = convexOf(box({1.5f, 1.5f}, {-1.5f, 1.5f}), {});
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Outline crate{box({random.between(0.2f, 1.0f), random.between(0.2f, 1.0f)}, {}, {},
                                random.below(2) == 0 ? 0.0f : 0.05f),
                            {}};
        Frame frame{{random.between(-1.0f, 1.0f), -3.0f}, rotFromAngle(random.between(-1.5f, 1.5f))};
        const Convex convex = convexOf(crate.geometry, {});
        for (int i = 0; i < 20; ++i)
            frame.position.y += std::fmax(0.0f, distanceBetween(solid, convex, frame).distance);
        frame.position.y += random.between(0.0f, 0.008f);
        const float distance = distanceBetween(solid, convex, frame).distance;
        if (distance > 0.0f) continue;  // it falls past the ledge
        const std::vector<Touch> all = touches(ledge, crate, frame);
        ASSERT_FALSE(all.empty());
        EXPECT_NEAR(least(all), distance, 1e-3f);
    }
}

}  // namespace
}  // namespace plumb::physics
