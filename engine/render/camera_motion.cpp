#include "render/camera_motion.hpp"

#include <algorithm>

#include "math/portable.hpp"

namespace plumb {
namespace {

float keptNear(float camera, float followed, float reach) {
    return std::clamp(camera, followed - reach, followed + reach);
}

float keptBetween(float center, float size, float low, float length) {
    if (size >= length) return low + length * 0.5f;
    return std::clamp(center, low + size * 0.5f, low + length - size * 0.5f);
}

}  // namespace

Vec2 keptInDeadZone(Vec2 camera, Vec2 followed, Vec2 deadZone) {
    const Vec2 reach = max(deadZone, {}) * 0.5f;
    return {keptNear(camera.x, followed.x, reach.x), keptNear(camera.y, followed.y, reach.y)};
}

Vec2 approached(Vec2 from, Vec2 to, float seconds, float dt) {
    if (seconds <= 0.0f) return to;
    constexpr float kTimeConstants = 3.0f;  // e^-3 is 5 %
    return to + (from - to) * exponential(-kTimeConstants * dt / seconds);
}

Vec2 keptInLimits(Vec2 center, Vec2 size, const Rect& limits) {
    if (limits.empty()) return center;
    return {keptBetween(center.x, size.x, limits.x, limits.width),
            keptBetween(center.y, size.y, limits.y, limits.height)};
}

Vec2 shakeOffset(float strength, float seconds, float time) {
    if (seconds <= 0.0f || time < 0.0f || time >= seconds) return {};
    const float left = 1.0f - time / seconds;
    // Two frequencies per axis without a common period: it does not look like a regular oscillation.
    const float x = 0.6f * sine(time * 71.0f) + 0.4f * sine(time * 113.0f + 1.0f);
    const float y = 0.6f * sine(time * 83.0f + 2.0f) + 0.4f * sine(time * 131.0f + 4.0f);
    return Vec2{x, y} * (strength * left * left);
}

}  // namespace plumb
