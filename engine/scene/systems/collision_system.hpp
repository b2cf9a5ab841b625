#pragma once

#include <string_view>

namespace plumb {

class World;

/// Calls for contacts: solid bodies stop and push each other, triggers report. The step itself runs once a
/// tick, in the last of the physics systems.
struct CollisionSystem {
    static constexpr std::string_view kName = "collision";

    void update(World& world, float dt);
};

}  // namespace plumb
