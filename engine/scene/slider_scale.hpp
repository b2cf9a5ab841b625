#pragma once

#include <algorithm>
#include <cmath>

#include "math/logarithm.hpp"
#include "math/portable.hpp"
#include "scene/components/slider.hpp"

namespace plumb {

inline constexpr float kSliderKnob = 9.0f;  ///< px, radius of the knob, and grab distance from the track

/// Returns the value at a knob position on the track (ratio, 0..1).
inline float valueAt(const Slider& slider, float part) {
    float place = slider.min + (slider.max - slider.min) * std::clamp(part, 0.0f, 1.0f);
    if (slider.step > 0.0f)
        place = slider.min + slider.step * std::floor((place - slider.min) / slider.step + 0.5f);
    return slider.powers ? exponential(place * 2.302585093f) : place;
}

/// Returns the knob position on the track (ratio, 0..1) for a value.
inline float partOf(const Slider& slider, float value) {
    const float place = slider.powers ? logarithm10(value) : value;
    const float way = slider.max - slider.min;
    return way != 0.0f ? std::clamp((place - slider.min) / way, 0.0f, 1.0f) : 0.0f;
}

}  // namespace plumb
