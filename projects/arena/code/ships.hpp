#pragma once

#include "components.hpp"

// The systems of the ships: what the player does, what enemies do, and what happens when they meet.

/// Returns `from`, moved towards `to` by at most `step`.
inline Vec2 movedTowards(Vec2 from, Vec2 to, float step) {
    const Vec2 way = to - from;
    return length(way) <= step ? to : from + normalized(way) * step;
}

/// Takes points off a hull, unless it was hit a moment ago.
inline void damage(World& world, EntityId entity, int points) {
    Hull* hull = world.find<Hull>(entity);
    if (hull == nullptr || hull->points == 0 || hull->safe > 0.0f) return;
    hull->points = std::max(hull->points - points, 0);
    if (hull->points == 0) {
        world.emit(Destroyed{entity});
        return;
    }
    playSound(world, hull->hitSound);
    // A tween is a countdown, too.
    hull->safe = hull->mercy;
    tween(world, entity, &Hull::safe, 0.0f, hull->mercy, Ease::Linear);
    // The pictures are white, so a white tint shows them at their brightest.
    world.get<Sprite>(entity).tint = Color{};
    tween(world, entity, &Sprite::tint, hull->color, hull->flash, Ease::QuadOut);
}

/// Moves the ship and fires its gun.
struct PlayerSystem {
    void update(World& world, float dt) {
        for (auto [entity, player, gun, body, transform] :
             world.query<const Player, Gun, RigidBody, const Transform>()) {
            const Input& input = inputFor(world, entity);
            const Vec2 keys{input.getAxis(Axis{"MoveX"}), input.getAxis(Axis{"MoveY"})};
            // Two keys at once give a diagonal, which must not be faster than one key.
            const Vec2 way = length(keys) > 1.0f ? normalized(keys) : keys;
            body.velocity = movedTowards(body.velocity, way * player.speed, player.acceleration * dt);

            const bool isFiring = aim(world, input, gun, transform.position);
            if (Transform* barrel = world.find<Transform>(gun.barrel))
                barrel->rotation = arcTangent(gun.aim.y, gun.aim.x);
            gun.wait = std::max(gun.wait - dt, 0.0f);
            if (isFiring && gun.wait == 0.0f) shoot(world, gun, transform.position);
        }
    }

    /// @return true if the player wants to shoot
    static bool aim(World& world, const Input& input, Gun& gun, Vec2 at) {
        const Vec2 keys{input.getAxis(Axis{"AimX"}), input.getAxis(Axis{"AimY"})};
        const bool trigger = input.isHeld(Action{"Fire"});
        // A mouse that is not in use must not disturb a player with keys or a gamepad.
        const bool usesMouse = trigger || input.mouse() != input.previousFrame().mouse();
        const Vec2 wanted = keys != Vec2{} ? keys : usesMouse ? mouseInWorld(world) - at : Vec2{};
        if (wanted != Vec2{}) gun.aim = normalized(wanted);
        return trigger || keys != Vec2{};
    }

    static void shoot(World& world, Gun& gun, Vec2 at) {
        gun.wait = gun.interval;
        const Vec2 direction = rotated(gun.aim, randomOf(world).between(-gun.spread, gun.spread));
        const Entity bullet = spawn(world, gun.bullet, at + direction * gun.length);
        if (!bullet) return;  // the prefab is missing, which spawn() has reported
        bullet.get<Transform>().rotation = arcTangent(direction.y, direction.x);
        bullet.get<KinematicBody>().velocity = direction * gun.speed;
        playSound(world, gun.sound);
    }
};

/// Moves enemies towards the player.
struct EnemySystem {
    void update(World& world, float dt) {
        const Entity player = world.first<const Player>();
        if (!player) return;  // they have won, and drift on
        const Vec2 target = player.get<const Transform>().position;
        for (auto [entity, enemy, body, transform] : world.query<const Enemy, RigidBody, const Transform>()) {
            const Vec2 wanted = normalized(target - transform.position) * enemy.speed;
            body.velocity = movedTowards(body.velocity, wanted, enemy.acceleration * dt);
        }
    }
};

/// Reacts to what touched in this tick: bullets are triggers, ships collide.
struct HitSystem {
    void update(World& world, float) {
        for (const TriggerEntered& touch : world.events<TriggerEntered>())
            hit(world, touch.trigger, touch.other);
        for (const ContactBegan& contact : world.events<ContactBegan>()) {
            ram(world, contact.a, contact.b);
            ram(world, contact.b, contact.a);
        }
    }

    static void hit(World& world, EntityId bullet, EntityId target) {
        // Not there any more if it touched two enemies in this tick: the first one stops it.
        const Bullet* shot = world.find<const Bullet>(bullet);
        if (shot == nullptr) return;
        if (RigidBody* body = world.find<RigidBody>(target))
            body->velocity +=
                normalized(world.get<const KinematicBody>(bullet).velocity) * (shot->push / body->mass);
        spawn(world, shot->sparks, world.get<const Transform>(bullet).position);
        damage(world, target, shot->damage);
        world.destroy(bullet);
    }

    static void ram(World& world, EntityId ship, EntityId other) {
        const Enemy* enemy = world.find<const Enemy>(ship);
        if (enemy == nullptr || !world.has<Player>(other)) return;
        // The enemy first, so that it counts even if it ends the game.
        damage(world, ship, world.get<const Hull>(ship).points);
        damage(world, other, enemy->damage);
    }
};
