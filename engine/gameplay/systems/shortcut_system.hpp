#pragma once

#include <string_view>

namespace plumb {

class World;

/// Actions that change scenes, or show and hide things.
/// Reads: Input, SceneKey, ToggleKey. Writes: SceneRequests, Hidden.
/// When: after physics.
struct ShortcutSystem {
    static constexpr std::string_view kName = "shortcuts";

    void update(World& world, float dt);
};

}  // namespace plumb
