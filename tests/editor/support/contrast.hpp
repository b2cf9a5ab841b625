#pragma once

#include <algorithm>
#include <cmath>

#include <imgui.h>

namespace plumb::editor::ui {

inline float channel(ImU32 color, int shift) { return static_cast<float>((color >> shift) & 0xff) / 255.0f; }

/// Returns the opaque color that results from drawing `top` over the opaque color `below`.
inline ImU32 over(ImU32 top, ImU32 below) {
    const float alpha = channel(top, IM_COL32_A_SHIFT);
    const auto mix = [&](int shift) {
        return static_cast<ImU32>(
            std::lround((channel(top, shift) * alpha + channel(below, shift) * (1.0f - alpha)) * 255.0f));
    };
    return IM_COL32(mix(IM_COL32_R_SHIFT), mix(IM_COL32_G_SHIFT), mix(IM_COL32_B_SHIFT), 255);
}

/// Returns the relative luminance as defined by WCAG 2.1, 0 to 1.
inline float luminance(ImU32 color) {
    const auto linear = [&](int shift) {
        const float value = channel(color, shift);
        return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
    };
    return 0.2126f * linear(IM_COL32_R_SHIFT) + 0.7152f * linear(IM_COL32_G_SHIFT) +
           0.0722f * linear(IM_COL32_B_SHIFT);
}
inline float contrast(ImU32 a, ImU32 b) {
    const float brighter = std::max(luminance(a), luminance(b));
    const float darker = std::min(luminance(a), luminance(b));
    return (brighter + 0.05f) / (darker + 0.05f);
}

}  // namespace plumb::editor::ui
