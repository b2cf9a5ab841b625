#include "physics/model/checks.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace plumb::physics {

namespace {

constexpr float kMaxSetting = 1.0e9f;  // upper limit of every setting except gravity, in its unit

float usable(float value, float low, float high, float usual) {
    return std::isnan(value) ? usual : std::clamp(value, low, high);
}

/// Prints values that are floats as such, to avoid the digits of the conversion to double.
std::string textOf(double value) {
    const auto near = static_cast<float>(value);
    return double{near} == value ? shortestText(near) : shortestText(value);
}

}  // namespace

Result<Done> checkNumber(const char* where, double value, double low, double high) {
    if (value >= low && value <= high) return Done{};
    return usageError(
        where, "expected a number from " + textOf(low) + " to " + textOf(high) + ", found " + textOf(value),
        "check the computation of this value");
}

Result<Done> checkKind(const char* where, BodyKind kind) {
    if (kind != BodyKind::None && kind <= BodyKind::Dynamic) return Done{};
    return usageError(where, "expected Static, Kinematic or Dynamic, found another kind",
                      "pass one of these");
}

Result<Done> checkOutside(const char* where, const World& world) {
    if (!world.work.isInCallback) return Done{};
    return usageError(where, "called from a callback during a step", "apply the change after the step");
}

Error staleIdError(const char* where, const std::string& what) {
    return usageError(where, "expected an existing " + what + ", found a null or stale id",
                      "check alive() first, or reset the id when its object is destroyed");
}

void bringIntoRange(Settings& settings) {
    const Settings usual;
    settings.gravity = {usable(settings.gravity.x, -kFastest, kFastest, usual.gravity.x),
                        usable(settings.gravity.y, -kFastest, kFastest, usual.gravity.y)};
    settings.quality = std::clamp(settings.quality, Quality{0}, kMaxQuality);
    settings.iterations = static_cast<std::uint8_t>(std::clamp<int>(settings.iterations, 1, kMaxIterations));
    for (float Settings::*const member :
         {&Settings::contactStiffness, &Settings::jointStiffness, &Settings::contactDampingRatio,
          &Settings::jointDampingRatio, &Settings::pushSpeed, &Settings::deepPushRate, &Settings::slop,
          &Settings::speculativeDistance, &Settings::recycleDistance, &Settings::boundsMargin,
          &Settings::bounceSpeed, &Settings::sleepTime, &Settings::maxSpeed, &Settings::tolerance}) {
        settings.*member = usable(settings.*member, 0.0f, kMaxSetting, usual.*member);
    }
}

}  // namespace plumb::physics
