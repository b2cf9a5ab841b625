#pragma once

#include "physics/character/character_mover.hpp"

namespace plumb::physics {

/// A character of a game: walks, jumps, rides, pushes and is pushed, without a body of its own in the world's
/// step. Plain data: copy it with the world, and both are a snapshot. Allocates nothing.
class CharacterController {
public:
    /// @error a number that is not finite or absurd, an outline that is no box, circle or capsule
    static Result<CharacterController> create(const CharacterDefinition& definition, Place position);

    /// One tick: goes along with its ground, gets out of the way of what moves, then walks or flies by its
    /// velocity. Call it before step(world, dt), when kinematic bodies have their velocities or targets.
    /// Bodies that it pushes or weighs on get impulses.
    /// @param dt  s; does nothing unless it is above 0 and at most 1
    CharacterMotion update(World& world, float dt);
    /// Leaves the ground with this speed (m/s) upwards and the ground's velocity, or adds to it in flight.
    Result<Done> jump(float speed);
    /// Falls through one-way shapes that it stands on. @return false when something else is there too
    bool dropThrough(World& world);

    [[nodiscard]] Place position() const { return position_; }  ///< m
    /// A jump to another place, in flight.
    Result<Done> setPosition(Place position);
    /// m/s; over its ground while it stands on one, over the world in flight.
    [[nodiscard]] Vec2 velocity() const { return velocity_; }
    /// On the ground, a part upwards leaves it.
    Result<Done> setVelocity(Vec2 velocity);
    [[nodiscard]] bool grounded() const { return static_cast<bool>(ground_); }
    [[nodiscard]] const CharacterTouch& ground() const { return ground_; }
    [[nodiscard]] Vec2 groundVelocity() const { return groundVelocity_; }  ///< m/s, in the last tick
    [[nodiscard]] const CharacterDefinition& definition() const { return definition_; }
    /// @error as create()
    Result<Done> setDefinition(const CharacterDefinition& definition);

private:
    CharacterController(const CharacterDefinition& definition, Place position)
        : definition_{definition}, position_{position} {}

    [[nodiscard]] float rise(Vec2 way) const { return dot(way, definition_.up); }
    [[nodiscard]] float along(Vec2 way) const { return dot(way, perpendicular(definition_.up)); }
    [[nodiscard]] Place heldPlace(const CharacterProbe& probe) const;
    bool ride(CharacterMover& mover, Place held);
    void walk(CharacterMover& mover, float dx, CharacterMotion& motion) const;
    void stopAt(World& world, const CharacterTouch& touch, float dt);
    void leaveGround();
    void holdOn(const CharacterProbe& probe);

    CharacterDefinition definition_;
    Place position_;
    Vec2 velocity_;
    CharacterTouch ground_;
    Vec2 groundVelocity_;
    Place hold_;           // where it stands on the ground's body, turned and seen from the body's centre
    float height_ = 0.0f;  // m: its position over that place
    bool placed_ = true;   // put somewhere since the last tick
};

}  // namespace plumb::physics
