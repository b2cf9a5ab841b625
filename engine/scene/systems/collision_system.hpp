#pragma once

#include <string_view>

namespace plumb {

class World;

/// Requests the effects of contacts and triggers. The physics step runs once per tick, in the last of the
/// physics systems that are present.
struct CollisionSystem {
    static constexpr std::string_view kName = "collision";

    void update(World& world, float dt);
};

}  // namespace plumb
