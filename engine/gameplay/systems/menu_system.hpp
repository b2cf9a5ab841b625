#pragma once

#include <string_view>

namespace plumb {

class World;

/// Handles the input of menus.
/// Reads: Input, MenuItem. Writes: Menu, Label, Transform of the cursor, SceneRequests. Emits: PlaySound.
/// When: after physics.
struct MenuSystem {
    static constexpr std::string_view kName = "menu";

    void update(World& world, float dt);
};

}  // namespace plumb
