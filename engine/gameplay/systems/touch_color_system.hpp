#pragma once

#include <string_view>

namespace plumb {

class World;

/// Changes the tint of sprites with a TouchColor while they are in triggers.
/// Reads: trigger events. Writes: TouchColor, Sprite.
/// When: after physics.
struct TouchColorSystem {
    static constexpr std::string_view kName = "touch color";

    void update(World& world, float dt);
};

}  // namespace plumb
