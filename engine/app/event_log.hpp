#pragma once

#include <string>

#include "ecs/world.hpp"

namespace plumb {

/// What a person calls an entity in the log: its Name, else its picture's name with its number among those
/// that share it, "Platform[3]".
std::string displayName(const World& world, EntityId entity);

/// Writes what the last tick brought for the player's character, in the form
/// `[Physics] Player grounded: true` and `[Collision] Player <-> Platform[3]`.
class EventLog {
public:
    void write(const World& world);

private:
    EntityId player_;
    bool grounded_ = false;
};

}  // namespace plumb
