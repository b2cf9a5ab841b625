#pragma once

#include <cmath>
#include <limits>

#include "physics/model/body.hpp"

namespace plumb::reference {

/// 2D vector in double precision.
struct Point {
    double x = 0.0;
    double y = 0.0;
};

constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
constexpr Point operator-(Point a) { return {-a.x, -a.y}; }
constexpr Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
constexpr double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
constexpr Point perpendicular(Point a) { return {-a.y, a.x}; }
inline double length(Point a) { return std::hypot(a.x, a.y); }
inline Point normalized(Point a) {
    const double size = length(a);
    return size > 0.0 ? Point{a.x / size, a.y / size} : Point{};
}
inline Point toPoint(Vec2 v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }

/// Three components for the degrees of freedom of a body: a pose
/// (m, rad), a velocity (m/s, rad/s), or the gradient of a scalar.
struct Triple {
    double x = 0.0;
    double y = 0.0;
    double turn = 0.0;  ///< rotational component: angle, angular velocity or derivative by the angle
};

constexpr Triple operator+(Triple a, Triple b) { return {a.x + b.x, a.y + b.y, a.turn + b.turn}; }
constexpr Triple operator-(Triple a, Triple b) { return {a.x - b.x, a.y - b.y, a.turn - b.turn}; }
constexpr Triple operator*(double s, Triple a) { return {s * a.x, s * a.y, s * a.turn}; }
constexpr double dot(Triple a, Triple b) { return a.x * b.x + a.y * b.y + a.turn * b.turn; }
constexpr Triple scaled(Triple a, Triple b) { return {a.x * b.x, a.y * b.y, a.turn * b.turn}; }
constexpr Point placeOf(Triple pose) { return {pose.x, pose.y}; }
inline double largest(Triple a) {
    return std::fmax(std::fabs(a.x), std::fmax(std::fabs(a.y), std::fabs(a.turn)));
}

/// A rotation, stored as cosine and sine.
struct Turn {
    double cos = 1.0;
    double sin = 0.0;

    explicit Turn(double angle) : cos{std::cos(angle)}, sin{std::sin(angle)} {}
};

inline Point rotate(Turn q, Point v) { return {q.cos * v.x - q.sin * v.y, q.sin * v.x + q.cos * v.y}; }
inline Point apply(Triple pose, Point local) { return placeOf(pose) + rotate(Turn{pose.turn}, local); }

inline constexpr double kEndless = std::numeric_limits<double>::infinity();  ///< no limit, or never

}  // namespace plumb::reference
