#include "gameplay/systems/moving_platform_system.hpp"

#include <algorithm>

#include "ecs/world.hpp"
#include "gameplay/components/actors/moving_platform.hpp"
#include "math/portable.hpp"
#include "scene/components/transform.hpp"

namespace plumb {

namespace {

/// Returns the position of a platform on its path (0 initial position, 1 other end) at a time, s.
float progressAt(const MovingPlatform& platform, float seconds) {
    const float travel = std::max(platform.period * 0.5f, 1.0f / 60.0f);
    const float half = travel + platform.wait;
    float t = seconds + platform.phase * half * 2.0f;
    t -= half * 2.0f * static_cast<float>(floorToInt(t / (half * 2.0f)));
    const bool back = t >= half;
    const float part = std::min((back ? t - half : t) / travel, 1.0f);
    const float eased = platform.easing == Easing::Smooth ? part * part * (3.0f - 2.0f * part) : part;
    return back ? 1.0f - eased : eased;
}

}  // namespace

void MovingPlatformSystem::update(World& world, float dt) {
    for (auto [entity, platform, transform] : world.query<MovingPlatform, Transform>()) {
        const bool first = !platform.started;
        if (first) platform.started = true, platform.home = transform.position;
        // Computed from the tick count instead of accumulated, so that rounding errors do not add up.
        const std::uint32_t ticks = platform.ticks++;
        const float seconds = static_cast<float>(ticks) * dt;
        transform.position = platform.home + platform.way * progressAt(platform, seconds);
        if (first) teleport(transform, transform.position);  // to its initial phase, without interpolation
    }
}

}  // namespace plumb
