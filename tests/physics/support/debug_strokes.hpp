#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "physics/model/fields.hpp"
#include "physics/model/joints.hpp"
#include "physics/model/shapes.hpp"
#include "random_shapes.hpp"
#include "recording_canvas.hpp"
#include "world_of_bodies.hpp"

namespace plumb::physics {

inline void expectNear(Vec2 found, Vec2 wanted, float tolerance = 1e-5f) {
    EXPECT_NEAR(found.x, wanted.x, tolerance);
    EXPECT_NEAR(found.y, wanted.y, tolerance);
}

inline void expectLine(const Stroke& stroke, Vec2 from, Vec2 to, float tolerance = 1e-5f) {
    ASSERT_EQ(stroke.points.size(), 2u);
    expectNear(stroke.points[0], from, tolerance);
    expectNear(stroke.points[1], to, tolerance);
}

inline float areaOf(std::span<const Vec2> points) {
    float twice = 0.0f;
    for (std::size_t i = 0; i < points.size(); ++i)
        twice += cross(points[i], points[(i + 1) % points.size()]);
    return 0.5f * twice;
}

/// Returns the distance of a point from a convex outline, m; 0 inside the outline.
inline float distanceFrom(std::span<const Vec2> corners, Vec2 point) {
    float nearest = std::numeric_limits<float>::max();
    bool isInside = true;
    const float orientation = areaOf(corners) > 0.0f ? 1.0f : -1.0f;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 from = corners[i], side = corners[(i + 1) % corners.size()] - from;
        const float part = std::clamp(dot(point - from, side) / dot(side, side), 0.0f, 1.0f);
        nearest = std::min(nearest, length(point - from - part * side));
        if (orientation * cross(side, point - from) < 0.0f) isInside = false;
    }
    return isInside ? 0.0f : nearest;
}

/// Two bodies at random poses, connected by a joint. The world is never stepped.
struct Pair {
    World world;
    BodyId a, b;
    Rot rotationA, rotationB;
    Vec2 anchorA, anchorB;  // m, world space

    Pair(Random& random, JointDefinition joint) {
        world.settings.gravity = {};
        const auto add = [&] {
            const BodyId body =
                addBody(world, BodyKind::Dynamic, WorldPosition{test::randomPoint(random, 3.0f)},
                        random.between(-3.0f, 3.0f));
            // The offset of the shape makes the center of mass differ from the position of the body.
            static_cast<void>(createShape(world, body, circle(0.5f, test::randomPoint(random, 0.5f))));
            return body;
        };
        a = joint.a = add();
        b = joint.b = add();
        rotationA = rotationOf(world, a);
        rotationB = rotationOf(world, b);
        anchorA = toVec2(worldPoint(world, a, joint.anchorA));
        anchorB = toVec2(worldPoint(world, b, joint.anchorB));
        EXPECT_TRUE(createJoint(world, joint));
    }
    [[nodiscard]] std::vector<Stroke> strokes(DebugRole role) {
        return strokesOf(drawn(world, kDrawJoints), role);
    }
    /// Expects a stroke of 0.2 m, centered at `at` and perpendicular to `along`.
    static void expectTick(const Stroke& stroke, Vec2 at, Vec2 along) {
        const Vec2 half = 0.1f * perpendicular(along);
        expectLine(stroke, at - half, at + half);
    }
};

constexpr std::uint64_t kPairs = 20;  // number of random pairs that a test tries

}  // namespace plumb::physics
