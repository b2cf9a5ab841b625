#pragma once

#include <cstdint>

namespace plumb {

/// Red, green, blue and opacity, 0..255 each, not premultiplied.
struct Color {
    std::uint8_t r = 255;
    std::uint8_t g = 255;
    std::uint8_t b = 255;
    std::uint8_t a = 255;

    friend constexpr bool operator==(Color, Color) = default;
};

constexpr std::uint8_t multiplied(std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>((a * b + 127) / 255);
}
constexpr Color operator*(Color a, Color b) {
    return {multiplied(a.r, b.r), multiplied(a.g, b.g), multiplied(a.b, b.b), multiplied(a.a, b.a)};
}
constexpr Color withOpacity(Color color, float opacity) {
    const float kept = opacity < 0.0f ? 0.0f : opacity > 1.0f ? 1.0f : opacity;
    color.a = static_cast<std::uint8_t>(static_cast<float>(color.a) * kept + 0.5f);
    return color;
}

}  // namespace plumb
