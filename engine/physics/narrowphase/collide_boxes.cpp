#include <cmath>

#include "physics/narrowphase/collide.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

template <class F>
F all(float s) {
    return s;
}
float abs(float a) { return a > -a ? a : -a; }
float min(float a, float b) { return a < b ? a : b; }
float max(float a, float b) { return a > b ? a : b; }
float sqrt(float a) { return std::sqrt(a); }
float select(bool condition, float a, float b) { return condition ? a : b; }
bool any(bool condition) { return condition; }

#include "physics/narrowphase/box_kernel.inl"

}  // namespace

Manifold collideBoxes(const Geometry& a, const Geometry& b, std::span<const Corner>, const Frame& bInA,
                      float speculative) {
    const Vec2 displacement = unrotate(a.turn, apply(bInA, b.a) - a.a);
    const Rot turn = between(a.turn, bInA.rotation * b.turn);
    const BoxTouch<float> touch =
        touchBoxes<float>({a.b.x, a.b.y, b.b.x, b.b.y, displacement.x, displacement.y, turn.cos, turn.sin,
                           a.radius, b.radius, speculative});
    Manifold manifold;
    if (!(touch.count > 0.0f)) return manifold;
    manifold.count = static_cast<int>(touch.count);
    manifold.normal = rotate(a.turn, {touch.normalX, touch.normalY});
    manifold.roundA = touch.roundA;
    manifold.roundB = touch.roundB;
    for (int i = 0; i < manifold.count; ++i) {
        manifold.points[i] = {a.a + rotate(a.turn, {touch.pointX[i], touch.pointY[i]}), touch.separation[i],
                              static_cast<std::uint16_t>(touch.id[i])};
    }
    return manifold;
}

}  // namespace plumb::physics
