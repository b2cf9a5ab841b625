#pragma once

#include <string>

#include "ecs/world.hpp"

namespace plumb {

/// Returns the name of an entity for the log: its Name, otherwise its texture's name with its index among the
/// entities that share the texture, e.g. "Platform[3]".
std::string displayName(const World& world, EntityId entity);

/// Logs new collisions and changes of `grounded` of the player's character, in the form
/// `[Collision] Player <-> Platform[3]` and `[Physics] Player grounded: true`.
class EventLog {
public:
    void write(const World& world);

private:
    EntityId player_;
    bool grounded_ = false;  // state of the player that was last logged
};

}  // namespace plumb
