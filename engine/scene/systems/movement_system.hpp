#pragma once

#include <string_view>

namespace plumb {

class World;

/// Requests motion: bodies move at their velocity. The physics step runs once per tick, in the last of the
/// physics systems that are present.
struct MovementSystem {
    static constexpr std::string_view kName = "movement";

    void update(World& world, float dt);
};

}  // namespace plumb
