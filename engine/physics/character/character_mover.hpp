#pragma once

#include "physics/character/character_probe.hpp"

namespace plumb::physics {

/// Moves a character's outline through a world as a character moves: along ground, up steps, down slopes
/// without hops, around corners that it only grazes. It changes nothing but its own place. Lives for one
/// tick, before step(): kinematic bodies are met where that step takes them.
class CharacterMover {
public:
    /// @param definition  outlives the mover
    /// @param position    m
    /// @param dt          s, of the step to come; 0 meets everything where it is now
    CharacterMover(World& world, const CharacterDefinition& definition, Place position, float dt);

    [[nodiscard]] Place position() const { return position_; }
    void setPosition(Place position) { position_ = position; }
    /// Whom it meets, and what it stands on or is carried by.
    [[nodiscard]] CharacterProbe& probe() { return probe_; }
    [[nodiscard]] bool isGround(Vec2 normal) const;

    /// Leaves whatever overlaps it. @return what it could not get out of, if anything: it stays then
    CharacterTouch pushOut();
    /// Finds room somewhere near when it is stuck in something, as after it was put there.
    bool escape();
    /// Goes where a platform takes it, or along what is in the way. @return whether it arrived
    bool carryTo(Place place);
    void carry(Vec2 way) { carryTo(position_ + way); }
    /// Gets out of the way of what the next step moves, as CharacterProbe::pushesAt() has it.
    /// @param own  m: what it goes by itself until they meet
    /// @return     what is left of `own`
    Vec2 giveWay(std::span<const CharacterProbe::Push> pushes, Vec2 own);
    /// Walks along the level by dx (m, to the right hand of `up`), up and down with the ground and up steps.
    CharacterMotion walk(float dx, Vec2 groundNormal);
    /// Flies along a way (m); slides along what it meets.
    CharacterMotion fly(Vec2 way);
    /// Finds ground within `reach` (m) below and comes down to it.
    CharacterMotion snapDown(float reach);
    /// walk(), but it keeps to the ground: over crests, down slopes, and down steps no higher than its snap.
    /// It goes in pieces that are short enough to tell a slope from a ledge.
    CharacterMotion walkOnGround(float dx, Vec2 groundNormal);
    /// True when there is ground within `reach` (m) below; nothing is moved.
    [[nodiscard]] bool standsOn(float reach) const;
    /// Stands anew on ground that turns under it, without going sideways.
    void settle(float reach);

private:
    [[nodiscard]] std::optional<CharacterHit> cast(Vec2 way) const { return probe_.cast(position_, way); }
    [[nodiscard]] std::optional<Vec2> groundNormalOf(const CharacterHit& hit) const;
    [[nodiscard]] float rise(Vec2 way) const { return dot(way, definition_.up); }
    [[nodiscard]] float along(Vec2 way) const { return dot(way, right_); }
    [[nodiscard]] float slopeOf(Vec2 normal) const { return -along(normal) / rise(normal); }
    [[nodiscard]] Vec2 onGround(float dx, Vec2 normal) const;
    void note(CharacterMotion& motion, const CharacterTouch& touch) const;
    void shift(Vec2 way) { position_ = position_ + way; }
    [[nodiscard]] float steepestSlope() const;
    CharacterMotion followDown(float walked, float climbed);
    bool stepUp(float dx);
    bool passCorner(Vec2 way);

    const CharacterDefinition& definition_;
    CharacterProbe probe_;
    Place position_;
    Vec2 right_;
    float steepest_;  // cosine
    float feet_;      // m: how far down it reaches
};

}  // namespace plumb::physics
