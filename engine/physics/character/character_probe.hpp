#pragma once

#include "core/fixed_list.hpp"
#include "physics/character/character.hpp"
#include "physics/queries/shape_cast.hpp"

namespace plumb::physics {

[[nodiscard]] inline CharacterTouch touchOf(const CastHit& hit) {
    return {hit.shape, hit.body, hit.normal, hit.point};
}
/// @param normal  of the ground below it
[[nodiscard]] inline CharacterTouch touchOf(const CastHit& hit, Vec2 normal) {
    return {hit.shape, hit.body, normal, hit.point};
}

/// The world as a character collides with it: kinematic bodies up to 60 m/s are where the next step takes
/// them, and one-way shapes stop only what is in front of them.
class CharacterProbe {
public:
    /// @param dt  s, of the next step
    CharacterProbe(World& world, const CharacterDefinition& definition, float dt);

    QueryFilter filter;
    bool oneWay = true;  ///< collides with one-way shapes
    ShapeId floor;       ///< the one-way shape that it stands on: supports it however deep it sank in
    BodyId carrier;      ///< a body that carries the character, and does not collide with it meanwhile

    /// First hit of a straight displacement. After its fraction of that the character still keeps its gap.
    [[nodiscard]] std::optional<CastHit> cast(WorldPosition from, Vec2 displacement) const {
        return cast(definition_.outline, from, displacement);
    }
    /// The same for another outline.
    [[nodiscard]] std::optional<CastHit> cast(const Geometry& outline, WorldPosition from,
                                              Vec2 displacement) const;
    /// The shape with the deepest overlap, or else the nearest one, within a distance of `within` (m).
    [[nodiscard]] std::optional<CastHit> nearest(WorldPosition at, float within) const;
    /// Collision with a body that the next step moves, while the character moves by itself.
    struct Push {
        BodyId body;
        ShapeId shape;
        Vec2 displacement;      ///< m: displacement that the character has to give way by
        float fraction = 0.0f;  ///< ratio of its own displacement until the collision
    };
    using Pushes = FixedList<Push, 16>;
    /// Collisions with moving bodies. Overlaps with shapes that move past the character are ignored until
    /// the next call.
    /// @param ride  m: displacement by its ground
    /// @param own  m: its own displacement
    /// @param except  its ground
    Pushes pushesAt(WorldPosition at, Vec2 ride, Vec2 own, BodyId except);

    /// Pose of a body after the next step, as far as it is known.
    [[nodiscard]] BodyPose poseOf(std::uint32_t body) const;
    [[nodiscard]] bool isCarried(std::uint32_t body) const;  ///< kinematic and moves in the next step

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
    // Shapes that move past it in this tick, and one-way shapes that it is inside or behind of.
    FixedList<std::uint32_t, 8> passed_;
    FixedList<std::uint32_t, 8> behind_;
};

}  // namespace plumb::physics
