#include "gameplay/systems/respawn_system.hpp"

#include <utility>

#include "assets/asset_store.hpp"
#include "ecs/world.hpp"
#include "gameplay/components/actors/health.hpp"
#include "gameplay/components/actors/respawn.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/drawing/animator.hpp"
#include "scene/components/drawing/hidden.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/transform.hpp"

namespace plumb {

namespace {

constexpr int kBlinkTicks = 4;              // ticks between two changes of the opacity
constexpr std::uint8_t kBlinkOpacity = 90;  // lower opacity of a blinking sprite, of 255

/// True if the animation has a parameter "dead" and can show the death; other dead entities are hidden.
bool showsDeath(World& world, EntityId entity) {
    const auto* animator = std::as_const(world).find<Animator>(entity);
    const auto* assets = world.service<AssetStore>();
    if (animator == nullptr || assets == nullptr || animator->animation.empty()) return false;
    return assets->animation(animator->animation).findParameter("dead") >= 0;
}

void comeBack(World& world, EntityId entity, const Respawn& respawn) {
    teleport(world.get<Transform>(entity), respawn.place);
    if (auto* body = world.find<RigidBody>(entity)) {
        body->velocity = {};
        body->grounded = false;
    }
    if (auto* health = world.find<Health>(entity)) {
        health->points = health->most;
        health->safe = health->safeTicks;
    }
}

void blink(World& world, EntityId entity, const Health& health) {
    auto* sprite = world.find<Sprite>(entity);
    if (sprite == nullptr) return;
    const bool faint = health.safe / kBlinkTicks % 2 == 1;
    sprite->tint.a = faint ? kBlinkOpacity : std::uint8_t{255};
}

}  // namespace

void RespawnSystem::update(World& world, float) {
    for (auto [entity, health] : world.query<Health>()) {
        if (health.safe == 0) continue;
        --health.safe;
        blink(world, entity, health);
    }
    for (auto [entity, respawn] : world.query<Respawn>(with<Transform>)) {
        if (!respawn.placed) {
            respawn.placed = true;
            respawn.place = std::as_const(world).get<Transform>(entity).position;
        }
        if (respawn.waiting == 0) continue;
        if (--respawn.waiting == 0) {
            comeBack(world, entity, respawn);
            entity.removeComponent<Hidden>();
        } else if (!entity.hasComponent<Hidden>() && !showsDeath(world, entity)) {
            entity.addComponent<Hidden>();
        }
    }
}

}  // namespace plumb
