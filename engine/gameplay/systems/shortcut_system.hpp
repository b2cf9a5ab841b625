#pragma once

#include <string_view>

namespace plumb {

class World;

/// Performs the actions of SceneKey and ToggleKey: changes scenes, shows and hides entities.
/// Reads: Input, SceneKey, ToggleKey. Writes: SceneRequests, Hidden.
/// When: after physics.
struct ShortcutSystem {
    static constexpr std::string_view kName = "shortcuts";

    void update(World& world, float dt);
};

}  // namespace plumb
