#pragma once

#include <string_view>

namespace plumb {

class World;

/// Calls for motion: bodies move by their velocity. The step itself runs once a tick, in the last of the
/// physics systems.
struct MovementSystem {
    static constexpr std::string_view kName = "movement";

    void update(World& world, float dt);
};

}  // namespace plumb
