#pragma once

#include <string_view>

namespace plumb {

class World;

/// Runs the components Bob, Spin and Lifetime.
/// Reads: Bob, Spin, Lifetime. Writes: Sprite, Transform, Lifetime.
/// When: any time.
struct MotionDecorSystem {
    static constexpr std::string_view kName = "decor";

    void update(World& world, float dt);
};

}  // namespace plumb
