#include "physics/narrowphase/collide.hpp"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "physics/narrowphase/distance.hpp"
#include "tests/physics/support/random_shapes.hpp"

namespace plumb::physics {
namespace {

using namespace test;

constexpr float kFar = 0.02f;    // maximum gap at which contact points are created, m
constexpr float kTie = 1.6e-3f;  // three times the maximum error by preferring a face, m

float least(const Manifold& manifold) {
    float least = std::numeric_limits<float>::infinity();
    for (int i = 0; i < manifold.count; ++i) least = std::fmin(least, manifold.points[i].separation);
    return least;
}

/// Two outlines whose corners are in one list.
struct Couple {
    Geometry a, b;
    std::vector<Corner> corners;
    Frame frame;  ///< pose of B in the frame of A

    [[nodiscard]] Manifold collided(float speculative) const {
        return collide(a, b, corners, frame, speculative);
    }
    [[nodiscard]] Manifold turned(float speculative) const {
        return collide(b, a, corners, inverse(frame), speculative);
    }
    [[nodiscard]] Distance distance() const {
        return distanceBetween(convexOf(a, corners), convexOf(b, corners), frame);
    }
};

Couple coupled(const Outline& a, const Outline& b, const Frame& frame) {
    Couple couple{a.geometry, b.geometry, a.corners, frame};
    couple.b.first += static_cast<std::uint32_t>(couple.corners.size());
    couple.corners.insert(couple.corners.end(), b.corners.begin(), b.corners.end());
    return couple;
}

/// Creates two outlines that overlap or are separated with equal probability, mostly close to touching.
Couple randomCouple(Random& random, ShapeKind kindA, ShapeKind kindB, float size) {
    const Outline a = randomOutline(random, kindA, size);
    const Outline b = randomOutline(random, kindB, size);
    Couple couple = coupled(a, b, randomFrame(random, 2.0f * size));
    if (random.below(3) > 0) {  // in two of three cases nearly touching
        const Distance found = couple.distance();
        couple.frame.position -= found.normal * (found.distance - random.between(-0.02f, 0.025f) * size);
    }
    return couple;
}

class EveryPair : public testing::TestWithParam<std::tuple<ShapeKind, ShapeKind>> {
protected:
    [[nodiscard]] Couple couple(std::uint64_t seed, float size = 1.0f) const {
        Random random = Random::seeded(seed);
        return randomCouple(random, std::get<0>(GetParam()), std::get<1>(GetParam()), size);
    }
};

TEST_P(EveryPair, hasTheSeparationOfGjkAndEpa) {
    int touching = 0;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        SCOPED_TRACE(seed);
        const Couple pair = couple(seed);
        const Manifold manifold = pair.collided(kFar);
        const Distance found = pair.distance();
        if (found.distance > kFar + 1e-4f) {
            EXPECT_EQ(manifold.count, 0);
            continue;
        }
        if (found.distance > kFar - 1e-4f) continue;
        ++touching;
        ASSERT_GE(manifold.count, 1);
        EXPECT_NEAR(length(manifold.normal), 1.0f, 1e-5f);
        // A corner just beyond the end of a face may be assigned to the face: error up to 0.016 % of the
        // distance of the cores.
        const float cores = found.distance + pair.a.radius + pair.b.radius;
        const float rounded = pair.a.radius + pair.b.radius > 0.0f ? kTie / 3.0f : 0.0f;
        EXPECT_LE(least(manifold), found.distance + 2e-5f + 1.6e-4f * std::fmax(cores, 0.0f) + rounded);
        const bool coresApart = cores > 0.0f;
        EXPECT_GE(least(manifold), found.distance - (coresApart ? 1e-4f : kTie));
        if (cores > 0.001f) {
            EXPECT_GT(dot(manifold.normal, found.normal), 0.999f);
        }
    }
    EXPECT_GT(touching, 300);
}

TEST_P(EveryPair, touchesMidwayBetweenTheSurfaces) {
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        SCOPED_TRACE(seed);
        const Couple pair = couple(seed);
        const Manifold manifold = pair.collided(kFar);
        for (int i = 0; i < manifold.count; ++i) {
            const ManifoldPoint& point = manifold.points[i];
            const Vec2 half = manifold.normal * (0.5f * point.separation);
            const ClosestPoint onA = closestPoint(pair.a, pair.corners, point.point - half);
            const ClosestPoint onB =
                closestPoint(pair.b, pair.corners, applyInverse(pair.frame, point.point + half));
            // One of the points is on a face or a corner; the other is a corner or a clipped point of an
            // edge.
            EXPECT_LT(std::fmin(std::fabs(onA.distance), std::fabs(onB.distance)), 2e-5f);
            if (pair.a.radius == 0.0f && pair.b.radius == 0.0f) {
                EXPECT_LT(std::fmax(onA.distance, onB.distance), 2e-5f);
            }
        }
        if (manifold.count == 2) {
            EXPECT_NE(manifold.points[0].id, manifold.points[1].id);
        }
    }
}

TEST_P(EveryPair, isSymmetric) {
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        SCOPED_TRACE(seed);
        const Couple pair = couple(seed);
        const Manifold there = pair.collided(kFar);
        const Manifold back = swapped(pair.turned(kFar), pair.frame);
        if (std::fabs(least(there) - kFar) < kTie || std::fabs(least(back) - kFar) < kTie) continue;
        ASSERT_EQ(there.count > 0, back.count > 0);
        if (there.count == 0) continue;
        EXPECT_NEAR(least(there), least(back), kTie);
        // With a different normal, another face of the same depth was selected.
        if (dot(there.normal, back.normal) < 0.9999f) continue;
        if (there.count != back.count) continue;  // a point with a gap of nearly kFar
        ++compared;
        for (int i = 0; i < there.count; ++i) {
            const bool found =
                std::any_of(back.points, back.points + back.count, [&](const ManifoldPoint& other) {
                    return distance(other.point, there.points[i].point) < 0.02f;
                });
            EXPECT_TRUE(found);
        }
    }
    EXPECT_GT(compared, 150);
}

/// Returns the same outline transformed by a frame.
Geometry placed(const Geometry& geometry, const Frame& frame) {
    Geometry moved = geometry;
    moved.a = apply(frame, geometry.a);
    if (geometry.kind != ShapeKind::Box) moved.b = apply(frame, geometry.b);
    if (geometry.kind == ShapeKind::Box) moved.rotation = frame.rotation * geometry.rotation;
    return moved;
}

TEST_P(EveryPair, isInvariantUnderRotation) {
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(seed);
        const Couple pair = couple(seed);
        Random random = Random::seeded(seed + 1000);
        const Frame frame = randomFrame(random, 1.0f);
        Couple moved = pair;
        moved.a = placed(pair.a, frame);
        for (std::size_t i = 0; i < pair.a.count; ++i) moved.corners[i] = apply(frame, pair.corners[i]);
        moved.frame = frame * pair.frame;
        const Manifold here = pair.collided(kFar);
        const Manifold there = moved.collided(kFar);
        if (std::fabs(least(here) - kFar) < 1e-4f || std::fabs(least(there) - kFar) < 1e-4f) continue;
        ASSERT_EQ(here.count > 0, there.count > 0);
        if (here.count == 0) continue;
        EXPECT_NEAR(least(here), least(there), kTie);
        if (here.count != there.count || dot(rotate(frame.rotation, here.normal), there.normal) < 0.9999f)
            continue;
        for (int i = 0; i < here.count; ++i) {
            EXPECT_EQ(here.points[i].id, there.points[i].id);
            EXPECT_LT(distance(apply(frame, here.points[i].point), there.points[i].point), 0.02f);
        }
    }
}

TEST_P(EveryPair, isEquallyPreciseFromAMillimetreToAKilometre) {
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(seed);
        const float size = seed % 2 == 0 ? 0.001f : 1000.0f;
        const Couple pair = couple(seed, size);
        const Manifold manifold = pair.collided(kFar * size);
        const Distance found = pair.distance();
        if (std::fabs(found.distance - kFar * size) < 1e-3f * size) continue;
        ASSERT_EQ(manifold.count > 0, found.distance < kFar * size);
        if (manifold.count == 0) continue;
        EXPECT_LE(least(manifold), found.distance + 2e-4f * size);
        EXPECT_GE(least(manifold),
                  found.distance - 3.0f * std::fmin(0.0005f, 0.001f * 2.0f * size) - 1e-4f * size);
    }
}

INSTANTIATE_TEST_SUITE_P(Collide, EveryPair,
                         testing::Combine(testing::ValuesIn(kConvexKinds), testing::ValuesIn(kConvexKinds)),
                         [](const auto& which) {
                             const auto nameOf = [](ShapeKind kind) {
                                 return std::string{shapeTypeOf(kind).name};
                             };
                             return nameOf(std::get<0>(which.param)) + "And" +
                                    nameOf(std::get<1>(which.param));
                         });

TEST(Collide, aBoxOnABoxTouchesInTwoPoints) {
    const Manifold manifold = collide(box({2.0f, 0.5f}), box({0.5f, 0.5f}), {}, {{0.3f, 0.99f}, {}}, kFar);

    ASSERT_EQ(manifold.count, 2);
    EXPECT_EQ(manifold.normal, (Vec2{0.0f, 1.0f}));
    const bool ordered = manifold.points[0].point.x < manifold.points[1].point.x;
    const ManifoldPoint& left = manifold.points[ordered ? 0 : 1];
    const ManifoldPoint& right = manifold.points[ordered ? 1 : 0];
    EXPECT_NEAR(left.point.x, -0.2f, 1e-6f);
    EXPECT_NEAR(right.point.x, 0.8f, 1e-6f);
    EXPECT_NEAR(left.point.y, 0.495f, 1e-6f);
    EXPECT_NEAR(left.separation, -0.01f, 1e-6f);
    EXPECT_NEAR(right.separation, -0.01f, 1e-6f);
    EXPECT_EQ(manifold.roundA, 0.0f);
    EXPECT_EQ(manifold.roundB, 0.0f);
}

TEST(Collide, stackedEqualBoxesKeepBothPointsUnderSmallRotations) {
    for (int i = -20; i <= 20; ++i) {
        SCOPED_TRACE(i);
        const Frame frame{{0.0f, 1.004f}, rotFromAngle(static_cast<float>(i) * 1e-5f)};
        const Manifold manifold = collide(box({0.5f, 0.5f}), box({0.5f, 0.5f}), {}, frame, kFar);
        EXPECT_EQ(manifold.count, 2);
        EXPECT_NEAR(manifold.normal.y, 1.0f, 1e-6f);
    }
}

TEST(Collide, idsPersistWhileABoxSlidesAndRocksOnAnother) {
    Manifold before;
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        const SinCos swing = sinCos(0.1f * static_cast<float>(i));
        const Frame frame{{0.5f * swing.cos, 0.995f}, rotFromAngle(0.004f * swing.sin)};
        const Manifold manifold = collide(box({2.0f, 0.5f}), box({0.5f, 0.5f}), {}, frame, kFar);
        ASSERT_EQ(manifold.count, 2);
        if (i > 0) {
            EXPECT_EQ(manifold.points[0].id, before.points[0].id);
            EXPECT_EQ(manifold.points[1].id, before.points[1].id);
        }
        before = manifold;
    }
}

TEST(Collide, roundedCornersTouchInOnePointAndReportTheirRadii) {
    const Geometry a = box({0.5f, 0.5f}, {}, {}, 0.1f);
    const Geometry b = box({0.5f, 0.5f}, {}, {}, 0.2f);
    const Vec2 direction = normalized(Vec2{1.0f, 1.5f});
    const Manifold corners = collide(a, b, {}, {Vec2{1.0f, 1.0f} + direction * 0.29f, {}}, kFar);
    ASSERT_EQ(corners.count, 1);
    EXPECT_GT(dot(corners.normal, direction), 0.99999f);
    EXPECT_NEAR(corners.points[0].separation, -0.01f, 1e-6f);
    EXPECT_EQ(corners.roundA, 0.1f);
    EXPECT_EQ(corners.roundB, 0.2f);

    const Manifold faces = collide(a, b, {}, {{0.2f, 1.29f}, {}}, kFar);
    EXPECT_EQ(faces.count, 2);
    EXPECT_EQ(faces.roundA, 0.0f);
    EXPECT_EQ(faces.roundB, 0.0f);

    const Manifold tipped = collide(a, b, {}, {{0.2f, 1.49f}, rotFromAngle(0.7f)}, kFar);
    ASSERT_EQ(tipped.count, 1);
    EXPECT_EQ(tipped.roundA, 0.0f);
    EXPECT_EQ(tipped.roundB, 0.2f);

    const Manifold ball = collide(circle(0.3f), a, {}, {{0.0f, 0.9f}, {}}, kFar);
    ASSERT_EQ(ball.count, 1);
    EXPECT_EQ(ball.roundA, 0.3f);
    EXPECT_EQ(ball.roundB, 0.0f);
}

TEST(Collide, aLyingCapsuleHasTwoPointsAndAStandingOneHasOne) {
    const Geometry floor = box({5.0f, 0.5f});
    const Geometry pill = capsule({-1.0f, 0.0f}, {1.0f, 0.0f}, 0.25f);
    EXPECT_EQ(collide(floor, pill, {}, {{0.0f, 0.75f}, {}}, kFar).count, 2);
    EXPECT_EQ(collide(floor, pill, {}, {{0.0f, 1.75f}, rotFromAngle(1.57f)}, kFar).count, 1);
    EXPECT_EQ(collide(pill, pill, {}, {{0.5f, 0.5f}, {}}, kFar).count, 2);
    EXPECT_EQ(collide(pill, pill, {}, {{2.5f, 0.0f}, {}}, kFar).count, 1);
    const Geometry ball = capsule({1.0f, 0.0f}, {1.0f, 0.0f}, 0.25f);  // a capsule of zero length is a disc
    const Manifold onFloor = collide(floor, ball, {}, {{0.0f, 0.75f}, {}}, kFar);
    ASSERT_EQ(onFloor.count, 1);
    EXPECT_NEAR(onFloor.points[0].point.x, 1.0f, 1e-6f);
    EXPECT_EQ(onFloor.roundB, 0.25f);
}

TEST(Collide, coincidingOutlinesHaveANormal) {
    const Outline hexagon = regularPolygon(6, 1.0f);
    const Geometry all[] = {circle(1.0f), capsule({-1, 0}, {1, 0}, 0.5f), box({1, 2}), hexagon.geometry,
                            segment({-1, 0}, {1, 0})};
    for (const Geometry& a : all) {
        for (const Geometry& b : all) {
            const Manifold manifold = collide(a, b, hexagon.corners, {}, kFar);
            ASSERT_GE(manifold.count, 1);
            EXPECT_NEAR(length(manifold.normal), 1.0f, 1e-6f);
        }
    }
}

TEST(CollideProperty, extremeShapesGiveFiniteResults) {
    const float sizes[] = {1e-4f, 1e-3f, 0.03f, 1.0f, 40.0f, 1e3f, 1e5f};
    for (std::uint64_t seed = 1; seed <= 20000; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const auto any = [&] {
            const float x = sizes[random.below(7)];
            const float y = sizes[random.below(7)];
            switch (random.below(5)) {
                case 0: return Outline{circle(x), {}};
                case 1: return Outline{capsule({-x, 0}, {x, 0}, y), {}};
                case 2: return Outline{box({x, y}, {}, {}, random.below(2) == 0 ? 0.0f : 0.1f), {}};
                case 3: return Outline{segment({-x, y}, {x, -y}), {}};
                default: break;
            }
            const auto hull = makeHull(std::vector<Vec2>{{0, 0}, {x, y}, {x, -y}, {-x, 1e-3f * y}});
            return hull.ok() ? outlineOf(*hull) : Outline{circle(x), {}};
        };
        const Outline a = any();
        const Outline b = any();
        const Vec2 places[] = {
            {}, {sizes[random.below(7)], 0}, {0, sizes[random.below(7)]}, randomPoint(random, 1.0f)};
        const Rot turns[] = {{}, {0, 1}, {-1, 0}, randomRotation(random), {std::sqrt(0.5f), std::sqrt(0.5f)}};
        const Couple pair = coupled(a, b, {places[random.below(4)], turns[random.below(5)]});
        const Manifold manifold = pair.collided(kFar);
        ASSERT_GE(manifold.count, 0);
        ASSERT_LE(manifold.count, 2);
        for (int i = 0; i < manifold.count; ++i) {
            ASSERT_TRUE(isFinite(manifold.points[i].point));
            ASSERT_LE(manifold.points[i].separation, kFar);
            ASSERT_NEAR(length(manifold.normal), 1.0f, 1e-4f);
        }
        ASSERT_TRUE(std::isfinite(pair.distance().distance));
    }
}

TEST(Collide, aNonFinitePositionGivesNoContact) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Outline hexagon = regularPolygon(6, 1.0f);
    const Geometry all[] = {
        circle(1.0f),     capsule({-1, 0}, {1, 0}, 0.5f), box({1, 2}),
        hexagon.geometry, segment({-1, 0}, {1, 0}),       chainSegment({-2, 0}, {-1, 0}, {1, 0}, {2, 0})};
    for (const Geometry& a : all) {
        for (const Geometry& b : all) {
            EXPECT_EQ(collide(a, b, hexagon.corners, {{nan, 0.0f}, {}}, kFar).count, 0);
            EXPECT_EQ(collide(a, b, hexagon.corners, {{0.0f, nan}, {}}, kFar).count, 0);
            EXPECT_EQ(collide(a, b, hexagon.corners, {{nan, nan}, {nan, nan}}, kFar).count, 0);
        }
    }
}

}  // namespace
}  // namespace plumb::physics
