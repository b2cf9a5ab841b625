#pragma once

#include <span>
#include <vector>

#include "core/random.hpp"
#include "tests/accuracy/families/blueprint.hpp"

namespace plumb::families {

/// Straight rods with hinges to each other and to the ground wherever they have a point in common.
struct Mechanism {
    struct Rod {
        std::vector<std::size_t> points;  ///< along it, from end to end
        float density = 1.0f;             ///< kg/m2
    };

    std::vector<Vec2> points;           ///< m
    std::vector<std::size_t> grounded;  ///< points with a hinge to the ground
    std::vector<Rod> rods;
    float width = 0.1f;  ///< m, of rods

    std::size_t point(Vec2 at);
    void rod(std::vector<std::size_t> along, float density);
    [[nodiscard]] Vec2 start(const Rod& rod) const { return points[rod.points.front()]; }
    [[nodiscard]] Vec2 end(const Rod& rod) const { return points[rod.points.back()]; }
    [[nodiscard]] float length(const Rod& rod) const { return distance(start(rod), end(rod)); }

    /// Adds its rods, which collide with nothing, and its hinges.
    /// @return the body of the first rod; those of the others follow
    [[nodiscard]] std::uint32_t addTo(Blueprint& plan) const;
};

/// The intersection of two circles that is to the left of the line from a to b.
Vec2 knee(Vec2 a, float reachA, Vec2 b, float reachB);
/// A box between two points that collides with nothing.
std::uint32_t addRod(Blueprint& plan, Vec2 from, Vec2 to, float width, float density);

}  // namespace plumb::families
