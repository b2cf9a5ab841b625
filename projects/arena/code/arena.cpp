#include "ships.hpp"

// The rules of the game: waves, explosions, score. At the end, all parts are registered with the engine.

/// Sends the enemies of a wave, then waits until all are destroyed. Ends the game when the player is.
struct WaveSystem {
    void update(World& world, float dt) {
        for (auto [entity, waves] : world.query<Waves>()) {
            waves.wait -= dt;
            if (waves.wait > 0.0f) continue;
            if (!world.first<const Player>()) {
                showOverlay(world, "game_over");
            } else if (waves.left > 0) {
                send(world, waves);
            } else if (world.count<Enemy>() == 0) {
                begin(world, waves);
            }
        }
    }

    static void begin(World& world, Waves& waves) {
        Score& score = world.resource<Score>();
        if (waves.wave == 0) score.points = 0;  // the scene has been opened or restarted
        score.wave = ++waves.wave;
        waves.left = waves.first + waves.growth * (waves.wave - 1);
        waves.wait = waves.pause;
        if (Label* label = world.find<Label>(waves.banner)) {
            label->color.a = 255;
            tween(world, waves.banner, &Label::color, withOpacity(label->color, 0.0f), waves.pause,
                  Ease::QuadIn);
        }
    }

    static void send(World& world, Waves& waves) {
        if (waves.kinds.empty()) return;
        Random& random = randomOf(world);
        const auto known = std::min(static_cast<std::uint32_t>(waves.wave), waves.kinds.count);
        const Entity enemy =
            spawn(world, waves.kinds[random.below(known)], placeOnBorder(waves.area, random));
        if (enemy) enemy.get<Enemy>().speed *= 1.0f + waves.speedUp * static_cast<float>(waves.wave - 1);
        waves.wait = waves.interval;
        --waves.left;
    }

    static Vec2 placeOnBorder(const Rect& area, Random& random) {
        Vec2 place{random.between(area.x, area.x + area.width), random.between(area.y, area.y + area.height)};
        switch (random.below(4)) {
            case 0: place.x = area.x; break;
            case 1: place.x = area.x + area.width; break;
            case 2: place.y = area.y; break;
            default: place.y = area.y + area.height;
        }
        return place;
    }
};

/// Fills in the labels. Runs in the menus, too, which show the best score.
struct ScoreSystem {
    void update(World& world, float) {
        const Score& score = world.resource<Score>();
        showText(world, "score", format("{}", score.points));
        showText(world, "best", format("{}", score.best));
        showText(world, "wave", format("{}", score.wave));
        const Entity player = world.first<const Player>();
        for (auto [entity, bar, sprite] : world.query<const HullBar, Sprite>())
            sprite.width = player ? bar.cell * player.get<const Hull>().points : 0;
    }
};

/// Counts a destroyed ship: an enemy for the score, the player for the end of the game.
static void countScore(World& world, const Destroyed& event) {
    Score& score = world.resource<Score>();
    if (const Enemy* enemy = world.find<const Enemy>(event.entity)) score.points += enemy->worth;
    score.best = std::max(score.best, score.points);
    if (!world.has<Player>(event.entity)) return;
    for (auto [entity, waves] : world.query<Waves>()) waves.wait = waves.pause;  // for the explosion
    logNote("Arena", "Game over in wave {} with score {}", score.wave, score.points);
}

/// Replaces a destroyed ship by its explosion.
static void explode(World& world, const Destroyed& event) {
    const Hull& hull = world.get<const Hull>(event.entity);
    const Entity explosion = spawn(world, hull.explosion, world.get<const Transform>(event.entity).position);
    if (explosion) {
        explosion.get<ParticleEmitter>().colorStart = hull.color;
        // Its sprite is a ring that grows and fades.
        explosion.get<Sprite>().tint = hull.color;
        tween(world, explosion, &Sprite::tint, withOpacity(hull.color, 0.0f), 0.4f, Ease::QuadOut);
        tween(world, explosion, &Transform::scale, Vec2{1.0f, 1.0f}, 0.4f, Ease::QuadOut);
    }
    playSound(world, hull.endSound);
    if (const Entity camera = world.first<const Camera>()) shake(camera.get<Camera>(), hull.shake, 0.35f);
    world.destroy(event.entity);
}

PLUMB_MODULE(module) {
    module.components<Player, Gun, Bullet, Enemy, Hull, HullBar, Waves>();
    module.resources<Score>();

    // Ships choose their velocities before the physics moves them; hits are known after it.
    module.system<PlayerSystem, Player>(before<PhysicsSystem>());
    module.system<EnemySystem, Enemy>(before<PhysicsSystem>());
    module.system<HitSystem, Enemy>();
    module.on<Destroyed, countScore>();
    module.on<Destroyed, explode>();  // the last one, as it destroys the entity
    module.system<WaveSystem, Waves>();
    module.system<ScoreSystem>();
}
