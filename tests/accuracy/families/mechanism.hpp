#pragma once

#include <span>
#include <vector>

#include "core/random.hpp"
#include "tests/accuracy/families/blueprint.hpp"

namespace plumb::families {

/// Straight rods with hinges to each other and to the ground at each common point.
struct Mechanism {
    struct Rod {
        std::vector<std::size_t> points;  ///< indices of points along the rod, from end to end
        float density = 1.0f;             ///< kg/m2
    };

    std::vector<Vec2> points;           ///< positions, m
    std::vector<std::size_t> grounded;  ///< indices of points with a hinge to the ground
    std::vector<Rod> rods;
    float width = 0.1f;  ///< width of all rods, m

    std::size_t point(Vec2 at);                               ///< adds a point; returns its index
    void rod(std::vector<std::size_t> along, float density);  ///< adds a rod
    [[nodiscard]] Vec2 start(const Rod& rod) const { return points[rod.points.front()]; }
    [[nodiscard]] Vec2 end(const Rod& rod) const { return points[rod.points.back()]; }
    [[nodiscard]] float length(const Rod& rod) const { return distance(start(rod), end(rod)); }

    /// Adds the rods, which do not collide, and the hinges to a blueprint.
    /// @return the body index of the first rod; the other rods follow in order
    [[nodiscard]] std::uint32_t addTo(Blueprint& plan) const;
};

/// Returns the intersection of circles with radii reachA around a and reachB around b, left of a -> b.
Vec2 knee(Vec2 a, float reachA, Vec2 b, float reachB);
/// Adds a box between two points that does not collide.
std::uint32_t addRod(Blueprint& plan, Vec2 from, Vec2 to, float width, float density);

}  // namespace plumb::families
