#pragma once

#include <concepts>

#include "math/portable.hpp"
#include "math/vec2.hpp"

namespace plumb {

/// A rotation from x towards y, as the cosine and sine of its angle: applying it needs no trigonometry.
struct Rot {
    float cos = 1.0f;
    float sin = 0.0f;

    friend constexpr bool operator==(Rot, Rot) = default;
};

inline Rot rotFromAngle(float angle) {
    const SinCos parts = sinCos(angle);
    return {parts.cos, parts.sin};
}
inline float angleOf(Rot q) { return arcTangent(q.sin, q.cos); }  ///< rad, -pi..pi

constexpr Vec2 rotate(Rot q, Vec2 v) { return {q.cos * v.x - q.sin * v.y, q.sin * v.x + q.cos * v.y}; }
constexpr Vec2 unrotate(Rot q, Vec2 v) { return {q.cos * v.x + q.sin * v.y, q.cos * v.y - q.sin * v.x}; }
/// Rotates first by `b`, then by `a`.
constexpr Rot operator*(Rot a, Rot b) {
    return {a.cos * b.cos - a.sin * b.sin, a.sin * b.cos + a.cos * b.sin};
}
/// The rotation that leads from `from` to `to`.
constexpr Rot between(Rot from, Rot to) {
    return {from.cos * to.cos + from.sin * to.sin, from.cos * to.sin - from.sin * to.cos};
}
constexpr Rot inverse(Rot q) { return {q.cos, -q.sin}; }
/// A template, so that normalized({x, y}) is that of a Vec2: no type is deduced from braces.
template <std::same_as<Rot> R>
R normalized(R q) {
    const float size = std::sqrt(q.cos * q.cos + q.sin * q.sin);
    return size > 0.0f ? Rot{q.cos / size, q.sin / size} : Rot{};
}

constexpr Vec2 cross(float s, Vec2 v) { return {-s * v.y, s * v.x}; }  ///< velocity of v, rotating at s rad/s

}  // namespace plumb
