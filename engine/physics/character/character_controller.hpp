#pragma once

#include "physics/character/character_mover.hpp"

namespace plumb::physics {

/// A game character that walks, jumps, rides on platforms and pushes bodies, without a body in the world.
/// Plain data: a copy, together with a copy of the world, is a snapshot. Allocates nothing.
class CharacterController {
public:
    /// Without a shape; for lists that are read from a file.
    CharacterController() = default;
    /// @error a number that is not finite or out of range, or an outline that is not a box, circle or capsule
    static Result<CharacterController> create(const CharacterDefinition& definition, WorldPosition position);

    /// Advances by one tick: moves with its ground, is displaced by moving bodies, then walks or flies by its
    /// own velocity. Call it before step(world, dt), after setting the velocities or targets of kinematic
    /// bodies. Applies impulses to the bodies that it pushes or stands on.
    /// @param dt  s, above 0 and up to 1; for other values the call does nothing
    CharacterMotion update(World& world, float dt);
    /// Adds an upward speed (m/s). A character on the ground leaves it; the ground's velocity is then added.
    Result<Done> jump(float speed);
    /// Makes it fall through the one-way shapes that it stands on.
    /// @return false if it also stands on another shape, or is not on the ground
    bool dropThrough(World& world);

    [[nodiscard]] WorldPosition position() const { return position_; }  ///< m
    /// Teleports the character, which is in the air afterwards.
    Result<Done> setPosition(WorldPosition position);
    /// Returns its velocity (m/s), relative to the ground while on the ground, else relative to the world.
    [[nodiscard]] Vec2 velocity() const { return velocity_; }
    /// Sets the velocity (m/s). An upward component makes a character leave the ground.
    Result<Done> setVelocity(Vec2 velocity);
    [[nodiscard]] bool grounded() const { return static_cast<bool>(ground_); }
    [[nodiscard]] const CharacterTouch& ground() const { return ground_; }
    [[nodiscard]] Vec2 groundVelocity() const { return groundVelocity_; }  ///< m/s, in the last tick
    [[nodiscard]] const CharacterDefinition& definition() const { return definition_; }
    /// @error the same errors as create()
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
    void leaveGround() {
        if (ground_) velocity_ += groundVelocity_;
        ground_ = {};
        groundVelocity_ = {};
    }
    void holdOn(const CharacterProbe& probe);

    CharacterDefinition definition_;
    WorldPosition position_;
    Vec2 velocity_;
    CharacterTouch ground_;
    Vec2 groundVelocity_;
    WorldPosition hold_;   // m: point of the ground below the character, in the frame of the ground's body
    float height_ = 0.0f;  // m: height of position_ above the point hold_
    bool placed_ = true;   // true if it was created, changed or teleported since the last tick
};

}  // namespace plumb::physics
