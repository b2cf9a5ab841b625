#pragma once

#include "physics/character/character_mover.hpp"

namespace plumb::physics {

/// A game character that walks, jumps, rides on platforms, pushes and is pushed, without a body in the
/// world's step. Plain data: a copy together with a copy of the world is a snapshot. Allocates nothing.
class CharacterController {
public:
    /// @error a number that is not finite or out of range, or an outline that is not a box, circle or capsule
    static Result<CharacterController> create(const CharacterDefinition& definition, WorldPosition position);

    /// Advances by one tick: rides on its ground, gives way to moving bodies, then walks or flies by its own
    /// velocity. Call it before step(world, dt), when kinematic bodies have their velocities or targets.
    /// Applies impulses to the bodies that it pushes or stands on.
    /// @param dt  s, up to 1; other values do nothing
    CharacterMotion update(World& world, float dt);
    /// Adds an upward speed (m/s). On the ground this leaves it, with the ground's velocity added.
    Result<Done> jump(float speed);
    /// Falls through the one-way shapes that it stands on.
    /// @return false if it also stands on something else
    bool dropThrough(World& world);

    [[nodiscard]] WorldPosition position() const { return position_; }  ///< m
    /// Teleports; it is in flight afterwards.
    Result<Done> setPosition(WorldPosition position);
    /// m/s: relative to its ground while it stands, else relative to the world.
    [[nodiscard]] Vec2 velocity() const { return velocity_; }
    /// On the ground, an upward component leaves it.
    Result<Done> setVelocity(Vec2 velocity);
    [[nodiscard]] bool grounded() const { return static_cast<bool>(ground_); }
    [[nodiscard]] const CharacterTouch& ground() const { return ground_; }
    [[nodiscard]] Vec2 groundVelocity() const { return groundVelocity_; }  ///< m/s, in the last tick
    [[nodiscard]] const CharacterDefinition& definition() const { return definition_; }
    /// @error as create()
    Result<Done> setDefinition(const CharacterDefinition& definition);

private:
    CharacterController(const CharacterDefinition& definition, WorldPosition position)
        : definition_{definition}, position_{position} {}

    [[nodiscard]] float rise(Vec2 displacement) const { return dot(displacement, definition_.up); }
    [[nodiscard]] float along(Vec2 displacement) const {
        return dot(displacement, perpendicular(definition_.up));
    }
    [[nodiscard]] WorldPosition heldPlace(const CharacterProbe& probe) const;
    bool ride(CharacterMover& mover, WorldPosition held);
    CharacterMotion walk(CharacterMover& mover, float dx) const;
    void stopAt(World& world, const CharacterTouch& touch, float dt);
    void leaveGround();
    void holdOn(const CharacterProbe& probe);

    CharacterDefinition definition_;
    WorldPosition position_;
    Vec2 velocity_;
    CharacterTouch ground_;
    Vec2 groundVelocity_;
    WorldPosition hold_;   // m: point of the ground below it, in the frame of the ground's body
    float height_ = 0.0f;  // m: its position above that point
    bool placed_ = true;   // teleported since the last tick
};

}  // namespace plumb::physics
