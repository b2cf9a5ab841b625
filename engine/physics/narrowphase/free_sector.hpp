#pragma once

#include <optional>

#include "physics/shapes/convex.hpp"

namespace plumb::physics {

/// The directions from a point that the outlines around it leave free. Outlines that abut have one border,
/// and only its normals are those of contacts there: not those of the edges between them.
class FreeSector {
public:
    /// @param inside     a free direction: to the middle of what touches the outlines at the point
    /// @param tolerance  m: outlines closer than this to the point cover a part of its surroundings
    FreeSector(Vec2 point, Vec2 inside, float tolerance)
        : point_{point}, inside_{inside}, tolerance_{tolerance} {}

    /// Takes away what an outline covers: first the one that the contact is with, then its neighbors.
    /// @return  false if it is not at the point
    bool cover(const Convex& outline, const Frame& frame);

    /// True where the outlines surround the point, or cover `inside`.
    [[nodiscard]] bool isClosed() const;
    /// True where the common border is straight.
    [[nodiscard]] bool isFlat() const;
    /// True for a normal of the common border, or one between its two normals at a corner.
    [[nodiscard]] bool allows(Vec2 normal) const;
    /// The normal of the first outline at the border that is nearest to the given one, if it has a part of
    /// it.
    [[nodiscard]] std::optional<Vec2> ownNormal(Vec2 normal) const;

private:
    /// A border of a covered sector.
    struct Border {
        float angle;  ///< from `inside`, counterclockwise, see angleFrom()
        Vec2 normal;  ///< outward
    };
    [[nodiscard]] float angleFrom(Vec2 direction) const;

    Vec2 point_;
    Vec2 inside_;
    float tolerance_;
    bool isCovered_ = false;  ///< `inside` is
    Border end_{4.0f, {}};    ///< of the free sector, and its other one: the borders of the nearest outlines
    Border start_{-1.0f, {}};
    std::optional<Border> ownEnd_, ownStart_;
};

}  // namespace plumb::physics
