#pragma once

#include "physics/character/character_probe.hpp"

namespace plumb::physics {

/// Moves a character's outline through a world: along the ground, up steps, down slopes without hops, around
/// corners that it only grazes. Changes only its own position. Used for one tick, before step(); it treats
/// kinematic bodies as if they were already at their poses after that step.
class CharacterMover {
public:
    /// @param definition  must outlive the mover
    /// @param position  m
    /// @param dt  s, length of the next step; 0: use the current poses of all bodies
    CharacterMover(World& world, const CharacterDefinition& definition, WorldPosition position, float dt);

    [[nodiscard]] WorldPosition position() const { return position_; }
    void setPosition(WorldPosition position) { position_ = position; }
    /// The collision queries of this character.
    [[nodiscard]] CharacterProbe& probe() { return probe_; }
    /// True if the surface can be stood on.
    [[nodiscard]] bool isGround(Vec2 normal) const { return rise(normal) >= steepest_; }

    /// Moves the outline out of all overlaps.
    /// @return a shape that still overlaps it, in which case it has not moved; without a shape on success
    CharacterTouch pushOut();
    /// Moves to free space nearby if it is stuck, e.g. after a teleport. Returns false if there is none.
    bool escape();
    /// Moves to the position to which a platform carries it, sliding along obstacles.
    /// @return true if it reached that position
    bool carryTo(WorldPosition place);
    void carry(Vec2 displacement) { carryTo(position_ + displacement); }
    /// Moves out of the paths of bodies that the next step moves, as found by CharacterProbe::pushesAt().
    /// @param own  m: its own displacement; it first moves by the part of it before the collision
    /// @return the remaining part of `own`
    Vec2 giveWay(const CharacterProbe::Pushes& pushes, Vec2 own);
    /// Walks horizontally by dx (m, positive to the right of `up`), follows the ground up and climbs steps.
    CharacterMotion walk(float dx, Vec2 groundNormal);
    /// Flies by a displacement (m); slides along surfaces that it hits.
    CharacterMotion fly(Vec2 displacement);
    /// Finds ground within `reach` (m) below it, moves down to it and returns it.
    CharacterTouch snapDown(float reach);
    /// Walks like walk(), but stays on the ground: over crests, down slopes and down steps up to `snap`.
    /// Moves in pieces that are short enough to distinguish a slope from a ledge.
    CharacterMotion walkOnGround(float dx, Vec2 groundNormal);
    /// True if there is ground within `reach` (m) below. Does not change the position.
    [[nodiscard]] bool standsOn(float reach) const {
        const auto hit = cast(definition_.up * -reach);
        return hit && groundNormalOf(*hit);
    }
    /// Adjusts the height to ground that rotates below the character, without a horizontal displacement.
    void settle(float reach);

private:
    [[nodiscard]] std::optional<CastHit> cast(Vec2 displacement) const {
        return probe_.cast(position_, displacement);
    }
    [[nodiscard]] std::optional<Vec2> groundNormalOf(const CastHit& hit) const;
    [[nodiscard]] float rise(Vec2 displacement) const { return dot(displacement, definition_.up); }
    [[nodiscard]] float along(Vec2 displacement) const { return dot(displacement, right_); }
    [[nodiscard]] float slopeOf(Vec2 normal) const { return -along(normal) / rise(normal); }
    [[nodiscard]] Vec2 onGround(float dx, Vec2 normal) const {
        if (definition_.evenSpeed) return right_ * dx + definition_.up * (dx * slopeOf(normal));
        return perpendicular(normal) * dx;
    }
    void note(CharacterMotion& motion, const CharacterTouch& touch) const;
    void shift(Vec2 displacement) { position_ = position_ + displacement; }
    /// Moves by a displacement, but only up to the first hit, and returns the hit.
    std::optional<CastHit> advance(Vec2 displacement) {
        const auto hit = cast(displacement);
        shift(displacement * (hit ? hit->fraction : 1.0f));
        return hit;
    }
    [[nodiscard]] float steepestSlope() const {
        return std::sqrt(std::max(1.0f - steepest_ * steepest_, 0.0f)) / std::max(steepest_, 0.01f);
    }
    bool stepUp(float dx);
    bool passCorner(Vec2 displacement);

    const CharacterDefinition& definition_;
    CharacterProbe probe_;
    WorldPosition position_;
    Vec2 right_;
    float steepest_;  // cosine of CharacterDefinition::steepest
    float feet_;      // m: distance from its position to its feet
};

}  // namespace plumb::physics
