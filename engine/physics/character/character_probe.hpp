#pragma once

#include <array>
#include <optional>
#include <span>

#include "physics/character/character.hpp"
#include "physics/queries/moving_outline.hpp"

namespace plumb::physics {

/// What a character would meet.
struct CharacterHit {
    CharacterTouch touch;
    float fraction = 0.0f;    ///< ratio of the way after which it keeps its gap
    float separation = 0.0f;  ///< m at the start; negative: overlap
};

/// m: how far an outline reaches along a direction, from its own origin.
[[nodiscard]] float reachAlong(const Convex& outline, Vec2 direction);

/// The world as a character feels it: kinematic bodies are where the next step takes them, if that is no
/// further than 60 m/s lead, and one-way shapes stop only who is before them.
class CharacterProbe {
public:
    /// @param dt  s, of the step to come
    CharacterProbe(World& world, const CharacterDefinition& definition, float dt);

    QueryFilter filter;
    bool oneWay = true;  ///< one-way shapes are felt
    ShapeId floor;       ///< a one-way shape that it stands on: holds it however deep it sank in
    BodyId carrier;      ///< a body that is not felt while it takes the character along

    /// The first shape on a straight way.
    [[nodiscard]] std::optional<CharacterHit> cast(Place from, Vec2 way) const;
    /// The same for a small disc.
    [[nodiscard]] std::optional<CharacterHit> castDisc(Place from, float radius, Vec2 way) const;
    /// The shape that is deepest inside, or else nearest, of those nearer than `within` (m).
    [[nodiscard]] std::optional<CharacterHit> nearest(Place at, float within) const;
    /// What a body that the next step moves does to a character that goes a way of its own meanwhile.
    struct Push {
        BodyId body;
        ShapeId shape;
        Vec2 way;               ///< m: by which the character has to give way
        float fraction = 0.0f;  ///< ratio of its own way, before they meet
    };
    /// Shapes that move without meeting it are not felt inside of it either, until the next tick.
    /// @param ride    m: where its ground takes it
    /// @param own     m: what it goes by itself
    /// @param except  its ground
    /// @param room    where to put them
    /// @return        how many
    std::size_t pushesAt(Place at, Vec2 ride, Vec2 own, BodyId except, std::span<Push> room);

    /// Where a body is after the next step, as far as that is known.
    [[nodiscard]] BodyPose poseOf(std::uint32_t body) const;
    [[nodiscard]] bool isCarried(std::uint32_t body) const;  ///< the next step moves it for sure

    [[nodiscard]] const CharacterDefinition& definition() const { return definition_; }
    [[nodiscard]] World& world() const { return world_; }

private:
    [[nodiscard]] std::span<const std::uint32_t> around(const AABB& bounds, Place from, Vec2 way) const;
    [[nodiscard]] std::optional<CharacterHit> first(const Geometry& outline, Place from, Vec2 way) const;
    [[nodiscard]] bool hasPassed(std::uint32_t shape) const;
    [[nodiscard]] bool ignores(std::uint32_t shape) const;
    [[nodiscard]] bool stops(const CastHit& hit, const BodyPose& pose, const MovingOutline& moving) const;
    [[nodiscard]] std::optional<CharacterHit> apart(std::uint32_t shape, Place at, float within) const;

    World& world_;
    const CharacterDefinition& definition_;
    float dt_;
    // Shapes that move past it in this tick, and one-way shapes that it is inside of or behind.
    std::array<std::uint32_t, 8> passed_{};
    std::size_t passedCount_ = 0;
    std::array<std::uint32_t, 8> behind_{};
    std::size_t behindCount_ = 0;
};

}  // namespace plumb::physics
