#pragma once

#include <optional>

#include "ecs/world.hpp"
#include "math/rect.hpp"
#include "scene/physics_queries.hpp"

namespace plumb {

/// What a character met on its way through one tick.
struct CharacterMotion {
    bool landed = false;  ///< came down on ground it can stand on
    bool hitWall = false;
    bool hitCeiling = false;
    EntityId ground;  ///< of `landed`
    Vec2 groundNormal{0.0f, -1.0f};
    EntityId wall;  ///< of `hitWall`
};

/// Moves an upright box through the solid world as a character moves: along ground, down slopes without
/// hops, around corners that it only grazes. It changes nothing but its own box.
class CharacterMover {
public:
    /// @param steepest  cosine of the steepest ground that can be stood on
    CharacterMover(World& world, const AABB& box, const QueryFilter& filter, float steepest)
        : world_{world}, box_{box}, filter_{filter}, steepest_{steepest} {}

    [[nodiscard]] const AABB& box() const { return box_; }
    QueryFilter& filter() { return filter_; }

    /// Leaves whatever overlaps the box, e.g. a platform that was moved into it.
    void pushOut();
    /// Goes where a platform takes it, as far as nothing is in the way.
    void carry(Vec2 way);
    /// Walks dx (px), up and down with the ground. The speed along x is the same on every slope.
    CharacterMotion walk(float dx, Vec2 groundNormal);
    /// Flies along a way (px); slides along what it meets.
    /// @param correction  px: a ceiling's corner that the head misses by this little is passed
    CharacterMotion fly(Vec2 way, float correction);
    /// Finds ground within `reach` px below and comes down to it.
    CharacterMotion snapDown(float reach);
    /// True when there is ground within `reach` px below, nothing is moved.
    [[nodiscard]] bool standsOn(float reach) const;

private:
    [[nodiscard]] std::optional<QueryHit> cast(Vec2 way) const { return castBox(world_, box_, way, filter_); }
    [[nodiscard]] bool isGround(Vec2 normal) const { return -normal.y >= steepest_; }
    void shift(Vec2 way) { box_ = {box_.min + way, box_.max + way}; }
    bool passCorner(float rise, float correction, float preferred);

    World& world_;
    AABB box_;
    QueryFilter filter_;
    float steepest_;
};

}  // namespace plumb
