#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "physics/model/fields.hpp"
#include "physics/ranges.hpp"
#include "physics/shapes/shape_types.hpp"
#include "tests/physics/support/random_shapes.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

// The limits of a range are accepted; the next floating-point number outside is rejected.

using namespace plumb;
using namespace plumb::physics;

namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();

template <class Take>
void expectRange(const char* name, float low, float high, Take take) {
    SCOPED_TRACE(name);
    EXPECT_TRUE(take(low));
    EXPECT_TRUE(take(high));
    EXPECT_FALSE(low > -kInfinite && take(std::nextafter(low, -kInfinite)));
    EXPECT_FALSE(high < kInfinite && take(std::nextafter(high, kInfinite)));
    EXPECT_FALSE(take(std::numeric_limits<float>::quiet_NaN()));
}

struct OneBody {
    World world;
    BodyId body = addBody(world, BodyKind::Dynamic, {});
    BodyId other = addBody(world, BodyKind::Static, {});

    bool takes(const Geometry& geometry) { return createShape(world, other, geometry).ok(); }
};

template <class Definition, class Member>
struct Range {
    const char* name;
    Member Definition::*member;
    float low, high;
};

std::vector<Corner> cornersOf(const test::Outline& outline) { return outline.corners; }

bool isGood(const std::vector<Corner>& corners, float radius = 0.0f) {
    Geometry geometry;
    geometry.kind = ShapeKind::Polygon;
    geometry.count = static_cast<std::uint8_t>(corners.size());
    geometry.radius = radius;
    geometry.a = corners.empty() ? Vec2{} : corners[0].point;
    return checkGeometry(geometry, corners).ok();
}

}  // namespace

TEST(RangeLimits, ofBodiesAreAccepted) {
    constexpr Range<BodyDefinition, float> kRanges[] = {
        {"linearDrag", &BodyDefinition::linearDrag, 0.0f, kFastest},
        {"angularDrag", &BodyDefinition::angularDrag, 0.0f, kFastest},
        {"sleepSpeed", &BodyDefinition::sleepSpeed, 0.0f, kFastest},
        {"angularVelocity", &BodyDefinition::angularVelocity, -kFastest, kFastest},
    };
    for (const auto& range : kRanges) {
        expectRange(range.name, range.low, range.high, [&](float value) {
            World world;
            BodyDefinition definition;
            definition.*range.member = value;
            return createBody(world, definition).ok();
        });
    }
    OneBody one;
    expectRange("velocity.x", -kFastest, kFastest, [&](float value) {
        return setVelocity(one.world, one.body, {value, 0.0f}).ok();
    });
    expectRange("velocity.y", -kFastest, kFastest, [&](float value) {
        return setVelocity(one.world, one.body, {0.0f, value}).ok();
    });
    expectRange("force", -kStrongest, kStrongest, [&](float value) {
        return applyForce(one.world, one.body, {value, 0.0f}).ok();
    });
    for (const double end : {-kFarthest, kFarthest}) {
        const double beyond = std::nextafter(end, 2.0 * end);
        EXPECT_TRUE(setPosition(one.world, one.body, {end, end}, 0.0f).ok());
        EXPECT_FALSE(setPosition(one.world, one.body, {beyond, 0.0}, 0.0f).ok());
        EXPECT_FALSE(setPosition(one.world, one.body, {0.0, beyond}, 0.0f).ok());
    }
    for (int quality = -3; quality < 9; ++quality)
        EXPECT_EQ(setQuality(one.world, one.body, static_cast<Quality>(quality)).ok(),
                  quality >= -1 && quality <= 6);
}

TEST(RangeLimits, ofFieldsAreAccepted) {
    constexpr Range<FieldDefinition, float> kRanges[] = {
        {"radius", &FieldDefinition::radius, 0.0f, 1.0e9f},
        {"strength", &FieldDefinition::strength, -1.0e12f, 1.0e12f},
        {"damping", &FieldDefinition::damping, 0.0f, 1.0e12f},
        {"length", &FieldDefinition::length, 0.0f, 1.0e9f},
        {"density", &FieldDefinition::density, 0.0f, 1.0e9f},
        {"linearDrag", &FieldDefinition::linearDrag, 0.0f, kFastest},
        {"angularDrag", &FieldDefinition::angularDrag, 0.0f, kFastest},
        {"gust", &FieldDefinition::gust, 0.0f, kFastest},
    };
    for (const auto& range : kRanges) {
        expectRange(range.name, range.low, range.high, [&](float value) {
            World world;
            FieldDefinition definition{.kind = FieldKind::Wind};
            definition.*range.member = value;
            return createField(world, definition).ok();
        });
    }
    World world;
    FieldDefinition wind{.kind = FieldKind::Wind};
    wind.gustSteps = 0;
    EXPECT_FALSE(createField(world, wind).ok());
    wind.gustSteps = 1;
    EXPECT_TRUE(createField(world, wind).ok());
    wind.kind = FieldKind::Count;
    EXPECT_FALSE(createField(world, wind).ok());
    wind.kind = FieldKind::Wind;
    wind.region = RegionKind::Count;
    EXPECT_FALSE(createField(world, wind).ok());
}

TEST(RangeLimits, ofJointsAreAccepted) {
    constexpr Range<JointDefinition, float> kRanges[] = {
        {"referenceAngle", &JointDefinition::referenceAngle, -1.0e5f, 1.0e5f},
        {"length", &JointDefinition::length, 0.0f, kLargest},
        {"ratio", &JointDefinition::ratio, -kLargest, kLargest},
        {"maxForce", &JointDefinition::maxForce, 0.0f, kInfinite},
        {"maxTorque", &JointDefinition::maxTorque, 0.0f, kInfinite},
        {"breakForce", &JointDefinition::breakForce, 0.0f, kInfinite},
        {"breakTorque", &JointDefinition::breakTorque, 0.0f, kInfinite},
        {"reportForce", &JointDefinition::reportForce, 0.0f, kInfinite},
        {"reportTorque", &JointDefinition::reportTorque, 0.0f, kInfinite},
        {"hertz", &JointDefinition::hertz, 0.0f, 1.0e4f},
        {"dampingRatio", &JointDefinition::dampingRatio, 0.0f, 1.0e4f},
    };
    OneBody one;
    for (const auto& range : kRanges) {
        expectRange(range.name, range.low, range.high, [&](float value) {
            JointDefinition definition{.a = one.other, .b = one.body};
            definition.*range.member = value;
            return createJoint(one.world, definition).ok();
        });
    }
    // The lower and upper limit may be equal, but not inverted.
    JointDefinition hinge{.a = one.other, .b = one.body, .limit = {true, 0.5f, 0.5f}};
    EXPECT_TRUE(createJoint(one.world, hinge).ok());
    hinge.limit.upper = std::nextafter(0.5f, 0.0f);
    EXPECT_FALSE(createJoint(one.world, hinge).ok());
}

TEST(RangeLimits, ofOutlinesAreAccepted) {
    OneBody one;
    expectRange("circle.radius", 0.5f * kSmallest, kLargest,
                [&](float value) { return one.takes(circle(value)); });
    expectRange("circle.a.x", -kLargest, kLargest, [&](float value) {
        return one.takes(circle(1.0f, {value, 0.0f}));
    });
    expectRange("circle.a.y", -kLargest, kLargest, [&](float value) {
        return one.takes(circle(1.0f, {0.0f, value}));
    });
    expectRange("capsule.radius", 0.5f * kSmallest, kLargest, [&](float value) {
        return one.takes(capsule({}, {1.0f, 0.0f}, value));
    });
    expectRange("capsule.b", -kLargest, kLargest, [&](float value) {
        return one.takes(capsule({}, {value, 1.0f}, 1.0f));
    });
    expectRange("capsule.a", -kLargest, kLargest, [&](float value) {
        return one.takes(capsule({1.0f, value}, {}, 1.0f));
    });
    expectRange("box.b.x", 0.5f * kSmallest, kLargest, [&](float value) {
        return one.takes(box({value, 1.0f}));
    });
    expectRange("box.b.y", 0.5f * kSmallest, kLargest, [&](float value) {
        return one.takes(box({1.0f, value}));
    });
    expectRange("box.radius", 0.0f, kLargest, [&](float value) {
        return one.takes(box({1.0f, 1.0f}, {}, {}, value));
    });
    for (const float good : {1.0f, 1.0004f, 0.9996f})
        EXPECT_TRUE(one.takes(box({1.0f, 1.0f}, {}, {0.6f * good, 0.8f * good})));
    for (const float bad : {0.0f, 0.999f, 1.001f, 2.0f, -0.5f})
        EXPECT_FALSE(one.takes(box({1.0f, 1.0f}, {}, {0.6f * bad, 0.8f * bad})));
    expectRange("segment", kSmallest, kLargest, [&](float value) {
        return one.takes(segment({}, {value, 0.0f}));
    });
    for (std::size_t point = 0; point < 4; ++point) {
        for (const bool vertical : {false, true}) {
            expectRange("chain", -kLargest, kLargest, [&](float value) {
                std::array<Vec2, 4> points{Vec2{-2.0f, 0.0f}, Vec2{-1.0f, 0.5f}, Vec2{1.0f, 0.25f},
                                           Vec2{2.0f, 0.0f}};
                (vertical ? points[point].y : points[point].x) = value;
                return one.takes(chainSegment(points[0], points[1], points[2], points[3])) ||
                       (std::fabs(value) == kLargest && length(points[1] - points[2]) > kLargest);
            });
        }
    }
    Geometry round = segment({}, {1.0f, 0.0f});
    round.radius = 0.1f;
    EXPECT_FALSE(one.takes(round));
}

TEST(RangeLimits, polygonsAreAcceptedIfTheyAreHulls) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        for (const float size : {0.01f, 1.0f, 1000.0f}) {
            const std::vector<Corner> good =
                cornersOf(test::regularPolygon(3 + static_cast<int>(random.below(6)), size));
            const auto at = random.below(static_cast<std::uint32_t>(good.size()));
            EXPECT_TRUE(isGood(good));
            const auto spoiled = [&](auto&& spoil) {
                std::vector<Corner> corners = good;
                spoil(corners[at]);
                return corners;
            };
            const auto turned = [&](float angle) {
                return spoiled([&](Corner& c) { c.normal = rotate(rotFromAngle(angle), c.normal); });
            };
            const auto scaled = [&](float by) {
                return spoiled([&](Corner& c) { c.normal = by * c.normal; });
            };
            for (const float side : {-1.0f, 1.0f}) {
                EXPECT_FALSE(isGood(turned(0.05f * side)));
                EXPECT_TRUE(isGood(turned(1.0e-4f * side)));
                EXPECT_FALSE(isGood(turned(kPi * side)));
                EXPECT_FALSE(isGood(scaled(1.0f + 2.0e-4f * side)));
                EXPECT_TRUE(isGood(scaled(1.0f + 1.0e-5f * side)));
            }
            EXPECT_FALSE(isGood(spoiled([](Corner& c) { c.point = -0.1f * c.point; })));
            EXPECT_FALSE(isGood(spoiled([](Corner& c) { c.point = 1.5f * c.point; })));
            EXPECT_FALSE(isGood({good.rbegin(), good.rend()}));
            std::vector<Corner> shifted = good;  // the same polygon, starting at another corner
            std::rotate(shifted.begin(), shifted.begin() + at, shifted.end());
            EXPECT_TRUE(isGood(shifted));
            EXPECT_FALSE(isGood({good[0], good[1]}));
        }
    }
    expectRange("polygon.radius", 0.0f, kLargest,
                [](float value) { return isGood(cornersOf(test::regularPolygon(5, 1.0f)), value); });
    EXPECT_TRUE(isGood(cornersOf(test::regularPolygon(kMaxCorners, 1.0f))));
    // Squares at and beyond the smallest and largest size.
    const auto square = [](float side) {
        return std::vector<Corner>{{{0.0f, 0.0f}, {0.0f, -1.0f}},
                                   {{side, 0.0f}, {1.0f, 0.0f}},
                                   {{side, side}, {0.0f, 1.0f}},
                                   {{0.0f, side}, {-1.0f, 0.0f}}};
    };
    EXPECT_TRUE(isGood(square(kSmallest)));
    EXPECT_FALSE(isGood(square(std::nextafter(kSmallest, 0.0f))));
    EXPECT_TRUE(isGood(square(kLargest)));
    EXPECT_FALSE(isGood(square(std::nextafter(kLargest, kInfinite))));
    // A long strip is large enough, because its size is that of its longer side.
    const std::vector<Corner> strip{{{0.0f, 0.0f}, {0.0f, -1.0f}},
                                    {{1.0f, 0.0f}, {1.0f, 0.0f}},
                                    {{1.0f, 1.0e-4f}, {0.0f, 1.0f}},
                                    {{0.0f, 1.0e-4f}, {-1.0f, 0.0f}}};
    EXPECT_TRUE(isGood(strip));
    Geometry polygon;
    polygon.kind = ShapeKind::Polygon;
    polygon.count = 4;
    const std::vector<Corner> pool = square(1.0f);
    EXPECT_TRUE(checkGeometry(polygon, pool).ok());
    polygon.first = 1;
    EXPECT_FALSE(checkGeometry(polygon, pool).ok()) << "its last corner is not in the pool";
    polygon.first = 5;
    EXPECT_FALSE(checkGeometry(polygon, pool).ok());
    // The index must not exceed the pool even if the memory behind it contains valid corners.
    std::vector<Corner> twice = pool;
    twice.insert(twice.end(), pool.begin(), pool.end());
    for (std::uint32_t first = 0; first <= 4; ++first) {
        polygon.first = first;
        EXPECT_EQ(checkGeometry(polygon, std::span{twice}.first(6)).ok(), first <= 2) << first;
    }
    std::vector<Corner> doubled = pool;  // a side of zero length
    doubled.insert(doubled.begin() + 1, doubled[1]);
    EXPECT_FALSE(isGood(doubled));
}
