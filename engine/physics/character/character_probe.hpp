#pragma once

#include <array>
#include <optional>
#include <span>

#include "physics/character/character.hpp"
#include "physics/queries/moving_outline.hpp"

namespace plumb::physics {

/// What a character would hit.
struct CharacterHit {
    CharacterTouch touch;
    float fraction = 0.0f;    ///< ratio of the displacement after which it still keeps its gap
    float separation = 0.0f;  ///< m, at the start; negative: overlap
};

/// m: extent of an outline along a direction, from its own origin.
[[nodiscard]] float reachAlong(const Convex& outline, Vec2 direction);

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

    /// First hit of a straight displacement.
    [[nodiscard]] std::optional<CharacterHit> cast(WorldPosition from, Vec2 displacement) const;
    /// The same for a small disc.
    [[nodiscard]] std::optional<CharacterHit> castDisc(WorldPosition from, float radius,
                                                       Vec2 displacement) const;
    /// The shape with the deepest overlap, or else the nearest one, within a distance of `within` (m).
    [[nodiscard]] std::optional<CharacterHit> nearest(WorldPosition at, float within) const;
    /// Collision with a body that the next step moves, while the character moves by itself.
    struct Push {
        BodyId body;
        ShapeId shape;
        Vec2 displacement;      ///< m: displacement that the character has to give way by
        float fraction = 0.0f;  ///< ratio of its own displacement until the collision
    };
    /// Collisions with moving bodies. Overlaps with shapes that move past the character are ignored until
    /// the next call.
    /// @param ride  m: displacement by its ground
    /// @param own  m: its own displacement
    /// @param except  its ground
    /// @param room  receives the results
    /// @return their number
    std::size_t pushesAt(WorldPosition at, Vec2 ride, Vec2 own, BodyId except, std::span<Push> room);

    /// Pose of a body after the next step, as far as it is known.
    [[nodiscard]] BodyPose poseOf(std::uint32_t body) const;
    [[nodiscard]] bool isCarried(std::uint32_t body) const;  ///< kinematic and moves in the next step

    [[nodiscard]] const CharacterDefinition& definition() const { return definition_; }
    [[nodiscard]] World& world() const { return world_; }

private:
    [[nodiscard]] std::span<const std::uint32_t> around(const AABB& bounds, WorldPosition from,
                                                        Vec2 displacement) const;
    [[nodiscard]] std::optional<CharacterHit> first(const Geometry& outline, WorldPosition from,
                                                    Vec2 displacement) const;
    [[nodiscard]] bool hasPassed(std::uint32_t shape) const;
    [[nodiscard]] bool ignores(std::uint32_t shape) const;
    [[nodiscard]] bool stops(const CastHit& hit, const BodyPose& pose, const MovingOutline& moving) const;
    [[nodiscard]] std::optional<CharacterHit> apart(std::uint32_t shape, WorldPosition at,
                                                    float within) const;

    World& world_;
    const CharacterDefinition& definition_;
    float dt_;
    // Shapes that move past it in this tick, and one-way shapes that it is inside or behind of.
    std::array<std::uint32_t, 8> passed_{};
    std::size_t passedCount_ = 0;
    std::array<std::uint32_t, 8> behind_{};
    std::size_t behindCount_ = 0;
};

}  // namespace plumb::physics
