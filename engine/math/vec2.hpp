#pragma once

#include <cmath>

namespace plumb {

/// Two numbers: a position, a direction or a size. y points down on screen.
struct Vec2 {
    float x = 0.0f;
    float y = 0.0f;

    constexpr Vec2& operator+=(Vec2 b) { return x += b.x, y += b.y, *this; }
    constexpr Vec2& operator-=(Vec2 b) { return x -= b.x, y -= b.y, *this; }
    constexpr Vec2& operator*=(float s) { return x *= s, y *= s, *this; }

    friend constexpr bool operator==(Vec2, Vec2) = default;
};

constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
constexpr Vec2 operator*(Vec2 a, float s) { return {a.x * s, a.y * s}; }
constexpr Vec2 operator*(float s, Vec2 a) { return {a.x * s, a.y * s}; }
constexpr Vec2 operator/(Vec2 a, float s) { return {a.x / s, a.y / s}; }

constexpr float dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
constexpr float cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
constexpr float lengthSquared(Vec2 a) { return dot(a, a); }
inline float length(Vec2 a) { return std::sqrt(lengthSquared(a)); }
inline float distance(Vec2 a, Vec2 b) { return length(b - a); }

/// The direction, with length 1; {0, 0} stays {0, 0}.
inline Vec2 normalized(Vec2 a) {
    const float size = length(a);
    return size > 0.0f ? a / size : Vec2{};
}

/// Rotated by 90 degrees, clockwise on screen.
constexpr Vec2 perpendicular(Vec2 a) { return {-a.y, a.x}; }
constexpr Vec2 scaled(Vec2 a, Vec2 b) { return {a.x * b.x, a.y * b.y}; }
constexpr Vec2 lerp(Vec2 a, Vec2 b, float t) { return a + (b - a) * t; }
constexpr float lerp(float a, float b, float t) { return a + (b - a) * t; }
constexpr Vec2 min(Vec2 a, Vec2 b) { return {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y}; }
constexpr Vec2 max(Vec2 a, Vec2 b) { return {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y}; }
inline bool isFinite(Vec2 a) { return std::isfinite(a.x) && std::isfinite(a.y); }

}  // namespace plumb
