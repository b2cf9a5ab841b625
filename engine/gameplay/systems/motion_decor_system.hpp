#pragma once

#include <string_view>

namespace plumb {

class World;

/// Bobs, spins and ends what is only there to be seen.
/// Reads: Bob, Spin, Lifetime. Writes: Sprite, Transform, Lifetime.
/// When: any time.
struct MotionDecorSystem {
    static constexpr std::string_view kName = "decor";

    void update(World& world, float dt);
};

}  // namespace plumb
