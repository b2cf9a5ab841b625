#include "physics/settings.hpp"

#include <algorithm>
#include <cmath>

#include "physics/ranges.hpp"

namespace plumb::physics {

namespace {

constexpr float kMost = 1.0e9f;  // upper limit of every setting but gravity, whatever its unit

float usable(float value, float low, float high, float usual) {
    return std::isnan(value) ? usual : std::clamp(value, low, high);
}

}  // namespace

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
        settings.*member = usable(settings.*member, 0.0f, kMost, usual.*member);
    }
}

}  // namespace plumb::physics
