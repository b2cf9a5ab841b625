#include "gameplay/systems/motion_decor_system.hpp"

#include "ecs/world.hpp"
#include "gameplay/components/actors/bob.hpp"
#include "gameplay/components/actors/spin.hpp"
#include "gameplay/components/triggers/lifetime.hpp"
#include "math/angle.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/transform.hpp"

namespace plumb {

namespace {

/// Moves the sprite by its pivot, so that the collider is not moved, which would be slower.
void showAt(Sprite& sprite, Bob& bob, Vec2 offset) {
    const Vec2 size{static_cast<float>(sprite.width), static_cast<float>(sprite.height)};
    if (size.x <= 0.0f || size.y <= 0.0f) return;
    const Vec2 change = bob.shown - offset;
    sprite.pivot += {change.x / size.x, change.y / size.y};
    bob.shown = offset;
}

}  // namespace

void MotionDecorSystem::update(World& world, float dt) {
    world.each<Bob, Sprite>([dt](Bob& bob, Sprite& sprite) {
        bob.time += dt;
        if (bob.time >= bob.period) bob.time = bob.time < 2.0f * bob.period ? bob.time - bob.period : 0.0f;
        const float turns = bob.period > 0.0f ? bob.time / bob.period + bob.phase : bob.phase;
        showAt(sprite, bob, bob.amplitude * sine(wrapAngle(turns * kTau)));
    });
    world.each<const Spin, Transform>([dt](const Spin& spin, Transform& transform) {
        transform.rotation = wrapAngle(transform.rotation + spin.rate * dt);
    });
    for (auto [entity, lifetime] : world.query<Lifetime>()) {
        lifetime.seconds -= dt;
        if (lifetime.seconds <= 0.0f) entity.destroy();
    }
}

}  // namespace plumb
