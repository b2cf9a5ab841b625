#pragma once

#include "physics/shapes/convex.hpp"

namespace plumb::physics {

/// A vertex of the Minkowski difference B - A, and the corners of A and B that it comes from.
struct Way {
    Vec2 displacement;
    Vec2 a, b;
    std::uint8_t indexA = 0;
    std::uint8_t indexB = 0;

    friend bool operator==(const Way& left, const Way& right) {
        return left.indexA == right.indexA && left.indexB == right.indexB;
    }
};

/// The Minkowski difference B - A: the outlines overlap if it contains the origin. In A's frame.
struct Displacements {
    const Convex& a;
    const Convex& b;
    const Frame& bInA;

    [[nodiscard]] Way at(int indexA, int indexB) const {
        Way displacement;
        displacement.a = a.corners()[static_cast<std::size_t>(indexA)].point;
        displacement.b = apply(bInA, b.corners()[static_cast<std::size_t>(indexB)].point);
        displacement.displacement = displacement.b - displacement.a;
        displacement.indexA = static_cast<std::uint8_t>(indexA);
        displacement.indexB = static_cast<std::uint8_t>(indexB);
        return displacement;
    }
    [[nodiscard]] Way farthestAlong(Vec2 direction) const {
        return at(farthest(a.corners(), -direction),
                  farthest(b.corners(), unrotate(bInA.rotation, direction)));
    }
};

/// The point of the Minkowski difference nearest to the origin, on the edge between two vertices: `part` is 0
/// at the first, 1 at the second.
struct DisplacementBetween {
    Way first, second;
    float part = 0.0f;
    Vec2 normal;            ///< unit length, from A to B
    float distance = 0.0f;  ///< m along it; negative: overlap
    int iterations = 0;
};

/// The shortest displacement that separates two overlapping cores.
DisplacementBetween deepestOverlap(const Displacements& displacements);

}  // namespace plumb::physics
