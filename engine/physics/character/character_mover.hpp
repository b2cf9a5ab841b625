#pragma once

#include "physics/character/character_probe.hpp"

namespace plumb::physics {

/// Moves a character's outline through a world: along ground, up steps, down slopes without hops, around
/// corners that it only grazes. Changes nothing but its own position. Lives for one tick, before step():
/// kinematic bodies are where that step takes them.
class CharacterMover {
public:
    /// @param definition  must outlive the mover
    /// @param position  m
    /// @param dt  s, of the next step; 0: all bodies are where they are now
    CharacterMover(World& world, const CharacterDefinition& definition, WorldPosition position, float dt);

    [[nodiscard]] WorldPosition position() const { return position_; }
    void setPosition(WorldPosition position) { position_ = position; }
    /// What it collides with, and what carries it.
    [[nodiscard]] CharacterProbe& probe() { return probe_; }
    [[nodiscard]] bool isGround(Vec2 normal) const;

    /// Moves out of all overlaps.
    /// @return what it could not get out of, if anything; then it has not moved
    CharacterTouch pushOut();
    /// Finds free space nearby if it is stuck, e.g. after a teleport.
    bool escape();
    /// Moves to where a platform takes it, or along what is in between.
    /// @return whether it arrived
    bool carryTo(WorldPosition place);
    void carry(Vec2 displacement) { carryTo(position_ + displacement); }
    /// Gives way to what the next step moves, given by CharacterProbe::pushesAt().
    /// @param own  m: its own displacement, of which the part before the collision is taken
    /// @return the rest of `own`
    Vec2 giveWay(const CharacterProbe::Pushes& pushes, Vec2 own);
    /// Walks horizontally by dx (m, positive to the right of `up`), follows the ground up and climbs steps.
    CharacterMotion walk(float dx, Vec2 groundNormal);
    /// Flies by a displacement (m); slides along what it hits.
    CharacterMotion fly(Vec2 displacement);
    /// Finds ground within `reach` (m) below it and moves down to it.
    CharacterMotion snapDown(float reach);
    /// walk() that stays on the ground: over crests, down slopes, and down steps up to its snap. It moves in
    /// pieces that are short enough to distinguish a slope from a ledge.
    CharacterMotion walkOnGround(float dx, Vec2 groundNormal);
    /// True if there is ground within `reach` (m) below. Moves nothing.
    [[nodiscard]] bool standsOn(float reach) const;
    /// Adjusts its height to ground that rotates under it, without a horizontal displacement.
    void settle(float reach);

private:
    [[nodiscard]] std::optional<CastHit> cast(Vec2 displacement) const {
        return probe_.cast(position_, displacement);
    }
    [[nodiscard]] std::optional<Vec2> groundNormalOf(const CastHit& hit) const;
    [[nodiscard]] float rise(Vec2 displacement) const { return dot(displacement, definition_.up); }
    [[nodiscard]] float along(Vec2 displacement) const { return dot(displacement, right_); }
    [[nodiscard]] float slopeOf(Vec2 normal) const { return -along(normal) / rise(normal); }
    [[nodiscard]] Vec2 onGround(float dx, Vec2 normal) const;
    void note(CharacterMotion& motion, const CharacterTouch& touch) const;
    void shift(Vec2 displacement) { position_ = position_ + displacement; }
    std::optional<CastHit> advance(Vec2 displacement);
    [[nodiscard]] float steepestSlope() const;
    bool stepUp(float dx);
    bool passCorner(Vec2 displacement);

    const CharacterDefinition& definition_;
    CharacterProbe probe_;
    WorldPosition position_;
    Vec2 right_;
    float steepest_;  // cosine
    float feet_;      // m: distance from its position to its feet
};

}  // namespace plumb::physics
