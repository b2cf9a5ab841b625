#pragma once

#include "core/fixed_list.hpp"
#include "physics/character/character.hpp"
#include "physics/queries/shape_cast.hpp"

namespace plumb::physics {

/// @param ground  normal of the ground, which replaces that of the hit
[[nodiscard]] inline CharacterTouch touchOf(const CastHit& hit, std::optional<Vec2> ground = {}) {
    return {hit.shape, hit.body, ground.value_or(hit.normal), hit.point};
}

/// Collision queries of a character. Kinematic bodies up to 60 m/s are tested at their poses after the next
/// step, and one-way shapes stop the character only if it is in front of them.
class CharacterProbe {
public:
    /// @param dt  s, length of the next step
    CharacterProbe(World& world, const CharacterDefinition& definition, float dt)
        : filter{definition.filter}, world_{world}, definition_{definition}, dt_{dt} {}

    QueryFilter filter;
    bool oneWay = true;  ///< whether the character collides with one-way shapes
    ShapeId floor;       ///< the one-way shape that it stands on; supports it even if they overlap deeply
    BodyId carrier;      ///< the body that carries the character: it is ignored in collisions

    /// Returns the first hit of a straight displacement. At its fraction the character keeps its gap.
    [[nodiscard]] std::optional<CastHit> cast(WorldPosition from, Vec2 displacement) const {
        return cast(definition_.outline, from, displacement);
    }
    /// Casts another outline than that of the character.
    [[nodiscard]] std::optional<CastHit> cast(const Geometry& outline, WorldPosition from,
                                              Vec2 displacement) const;
    /// Returns the shape with the deepest overlap, else the nearest one up to a distance of `within` (m).
    [[nodiscard]] std::optional<CastHit> nearest(WorldPosition at, float within) const;
    /// Collision with a body that moves in the next step, while the character also moves.
    struct Push {
        BodyId body;
        ShapeId shape;
        Vec2 displacement;      ///< m: displacement that moves the character out of the body's path
        float fraction = 0.0f;  ///< fraction of the character's own displacement before the collision
    };
    using Pushes = FixedList<Push, 16>;
    /// Finds collisions with moving bodies. Until the next call, shapes that move past it are ignored.
    /// @param ride  m: displacement by the motion of its ground
    /// @param own  m: the character's own displacement
    /// @param except  body of its ground, which is ignored
    Pushes pushesAt(WorldPosition at, Vec2 ride, Vec2 own, BodyId except);

    /// Returns the pose of a kinematic body after the next step; for other bodies the current pose.
    [[nodiscard]] BodyPose poseOf(std::uint32_t body) const;
    [[nodiscard]] bool isCarried(std::uint32_t body) const;  ///< kinematic and moving in the next step

    [[nodiscard]] const CharacterDefinition& definition() const { return definition_; }
    [[nodiscard]] World& world() const { return world_; }

private:
    [[nodiscard]] std::span<const std::uint32_t> around(const AABB& bounds, WorldPosition from,
                                                        Vec2 displacement) const;
    [[nodiscard]] bool ignores(std::uint32_t shape) const;
    [[nodiscard]] bool stops(const CastHit& hit, const BodyPose& pose, const MovingOutline& moving) const;
    [[nodiscard]] std::optional<CastHit> apart(std::uint32_t shape, WorldPosition at, float within) const;

    World& world_;
    const CharacterDefinition& definition_;
    float dt_;
    // Shapes that move past the character in this tick; one-way shapes that it is inside of or behind.
    FixedList<std::uint32_t, 8> passed_;
    FixedList<std::uint32_t, 8> behind_;
};

}  // namespace plumb::physics
