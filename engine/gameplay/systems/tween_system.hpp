#pragma once

#include <string_view>

namespace plumb {

class World;

/// Changes fields of components over time (tween).
/// Reads and writes: Tweens and the components whose fields they change. When: after physics, before
/// animation.
struct TweenSystem {
    static constexpr std::string_view kName = "tweens";

    void update(World& world, float dt);
};

}  // namespace plumb
