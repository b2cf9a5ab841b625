#pragma once

#include <plumb.hpp>

// The recipes of docs/code.md, each in a namespace of its own between `// doc` and `// end`: a test compares
// them with the document.

namespace plumb {
namespace pickups {
// doc
struct Coin {
    int value = 1;  ///< points

    static void describe(TypeBuilder<Coin>& type) {
        type.name("Coin").doc(
            "Collected by a Collector that touches it; needs a collider that is a trigger.");
        type.field<&Coin::value>("value").range(0.0f, 1000.0f).doc("Points.");
    }
};
struct Collector {
    int points = 0;

    static void describe(TypeBuilder<Collector>& type) {
        type.name("Collector").doc("Collects coins. A Label shows the points with {points}.");
        type.field<&Collector::points>("points").transient();
    }
};

struct CoinSystem {
    void update(World& world, float) {
        forEachTouch<TriggerEntered, Coin, Collector>(world, [&](EntityId coin, EntityId by) {
            Collector& collector = world.get<Collector>(by);
            collector.points += world.get<const Coin>(coin).value;
            world.destroy(coin);
        });
        for (auto [entity, collector] : world.query<const Collector>())
            showText(world, "points", format("{}", collector.points));
    }
};

void addCoins(Module& module) {
    module.components<Coin, Collector>();
    module.system<CoinSystem, Collector>();
}
// end
}  // namespace pickups

namespace waves {
// doc
struct Waves {
    PrefabId enemy;
    int first = 3;          ///< enemies of the first wave; each has one more than the one before
    float interval = 5.0f;  ///< s, between two waves
    float width = 640.0f;   ///< px, of the row in which they appear, from the Transform on
    int wave = 0;           ///< number of waves so far

    static void describe(TypeBuilder<Waves>& type) {
        type.name("Waves").doc("Sends enemies, one wave after the other.");
        type.field<&Waves::enemy>("enemy").doc("Prefab of an enemy.");
        type.field<&Waves::first>("first").range(1.0f, 100.0f).doc("Enemies of the first wave.");
        type.field<&Waves::interval>("interval").unit(Unit::Seconds).range(0.1f, 600.0f);
        type.field<&Waves::width>("width").unit(Unit::Pixels).doc("Width of the row of enemies, px.");
        type.field<&Waves::wave>("wave").transient();
    }
};
/// Event: the next wave begins.
struct WaveDue {
    EntityId waves;
};

/// Begins a wave, and asks for the next one: a timer that sets itself again.
void beginWave(World& world, const WaveDue& due) {
    Waves* waves = world.find<Waves>(due.waves);
    if (waves == nullptr) return;  // destroyed since
    const Vec2 place = worldPose(world, due.waves).position;
    const int count = waves->first + waves->wave++;
    emitAfter(world, due.waves, waves->interval, due);
    for (int i = 0; i < count; ++i)
        spawn(world, waves->enemy, place + Vec2{randomOf(world).between(0.0f, waves->width), 0.0f});
}

/// Begins the first wave.
struct WaveSystem {
    void update(World& world, float) {
        for (auto [entity, waves] : world.query<const Waves>())
            if (waves.wave == 0) beginWave(world, {entity});
    }
};

void addWaves(Module& module) {
    module.components<Waves>();
    module.system<WaveSystem, Waves>();
    module.on<WaveDue, beginWave>();
}
// end
}  // namespace waves

namespace health {
// doc
struct Hero {
    int lives = 3;
    float mercy = 1.0f;  ///< s after a hit in which no other one counts
    float safe = 0.0f;   ///< s, rest of `mercy`

    static void describe(TypeBuilder<Hero>& type) {
        type.name("Hero").doc("Loses a life with each Thorn it touches; {lives} shows them.");
        type.field<&Hero::lives>("lives").range(1.0f, 99.0f);
        type.field<&Hero::mercy>("mercy").unit(Unit::Seconds).doc("After a hit no other one counts, s.");
        type.field<&Hero::safe>("safe").unit(Unit::Seconds).transient();
    }
};
struct Thorn {
    static void describe(TypeBuilder<Thorn>& type) { type.name("Thorn").doc("Hurts a Hero."); }
};
/// Event: the hero has no lives left.
struct HeroDied {
    EntityId hero;
};

struct HealthSystem {
    void update(World& world, float dt) {
        for (auto [entity, hero] : world.query<Hero>()) {
            hero.safe = std::max(0.0f, hero.safe - dt);
            showText(world, "lives", format("{}", hero.lives));
        }
        for (const ContactBegan& contact : world.events<ContactBegan>()) {
            if (world.has<Thorn>(contact.a)) hit(world, contact.b);
            if (world.has<Thorn>(contact.b)) hit(world, contact.a);
        }
    }
    static void hit(World& world, EntityId entity) {
        Hero* hero = world.find<Hero>(entity);
        if (hero == nullptr || hero->safe > 0.0f || hero->lives == 0) return;
        hero->safe = hero->mercy;
        if (--hero->lives == 0) world.emit(HeroDied{entity});
    }
};

/// Shows scenes/game_over.scene.json over the game, which rests.
void endGame(World& world, const HeroDied&) { showOverlay(world, "game_over"); }

void addHealth(Module& module) {
    module.components<Hero, Thorn>();
    module.system<HealthSystem, Hero>();
    module.on<HeroDied, endGame>();
}
// end
}  // namespace health

namespace shooting {
// doc
struct Gun {
    PrefabId bullet;         ///< with a RigidBody or a KinematicBody, and a Lifetime
    float speed = 600.0f;    ///< px/s, of a bullet
    float interval = 0.2f;   ///< s, between two shots
    float distance = 20.0f;  ///< px, from the gun to a new bullet
    float wait = 0.0f;       ///< s, until the next shot is possible

    static void describe(TypeBuilder<Gun>& type) {
        type.name("Gun").doc("Shoots at the mouse while the action Attack is held.");
        type.field<&Gun::bullet>("bullet").doc("Prefab of a bullet.");
        type.field<&Gun::speed>("speed").unit(Unit::PixelsPerSecond).range(1.0f, 5000.0f);
        type.field<&Gun::interval>("interval").unit(Unit::Seconds).range(0.02f, 10.0f);
        type.field<&Gun::distance>("distance").unit(Unit::Pixels).range(0.0f, 1000.0f);
        type.field<&Gun::wait>("wait").unit(Unit::Seconds).transient();
    }
};

struct GunSystem {
    void update(World& world, float dt) {
        for (auto [entity, gun] : world.query<Gun>()) {
            gun.wait = std::max(0.0f, gun.wait - dt);
            if (gun.wait > 0.0f || !inputFor(world, entity).isHeld(Action::Attack)) continue;
            gun.wait = gun.interval;
            const Vec2 from = worldPose(world, entity).position;
            const Vec2 way = normalized(mouseInWorld(world) - from);
            const Entity bullet = spawn(world, gun.bullet, from + way * gun.distance);
            if (!bullet) continue;  // there is no such prefab, which spawn() has reported
            if (RigidBody* body = bullet.find<RigidBody>()) body->velocity = way * gun.speed;
            if (KinematicBody* body = bullet.find<KinematicBody>()) body->velocity = way * gun.speed;
        }
    }
};

void addGuns(Module& module) {
    module.components<Gun>();
    module.system<GunSystem, Gun>(before<PhysicsSystem>());
}
// end
}  // namespace shooting

namespace following {
// doc
/// Lets the camera follow an entity in a level of this size, px.
void follow(World& world, EntityId target, Vec2 level) {
    for (auto [entity, camera] : world.query<Camera>()) {
        camera.follow = target;
        camera.smoothing = 0.3f;           // s
        camera.deadZone = {40.0f, 24.0f};  // px: small movements do not move the camera
        camera.lookAhead = {0.25f, 0.0f};  // s: it is ahead of a target that runs
        camera.limits = {0.0f, 0.0f, level.x, level.y};
    }
}
// end
}  // namespace following

namespace animation {
// doc
struct Walking {
    static void describe(TypeBuilder<Walking>& type) {
        type.name("Walking").doc("Plays the clips idle, run and jump of the Animator, by the RigidBody.");
    }
};

struct WalkingSystem {
    void update(World& world, float) {
        for (auto [entity, walking, body, sprite] : world.query<const Walking, const RigidBody, Sprite>()) {
            const bool moves = std::abs(body.velocity.x) > 5.0f;  // px/s
            if (moves) sprite.flipX = body.velocity.x < 0.0f;
            playClip(world, entity, !body.grounded ? "jump" : moves ? "run" : "idle");
        }
    }
};

void addWalking(Module& module) {
    module.components<Walking>();
    module.system<WalkingSystem, Walking>();
}
// end
}  // namespace animation

namespace scores {
// doc
/// A resource: one value of the world, which changes of the scene do not end.
struct Score {
    int points = 0;
    int best = 0;  ///< highest number of points since the game was started

    static void describe(TypeBuilder<Score>& type) {
        type.name("Score");
        type.field<&Score::points>("points");
        type.field<&Score::best>("best");
    }
    /// Makes it part of the world's hash, so that replays check it.
    void addTo(Hasher& hasher) const {
        for (const int value : {points, best}) hasher.add(static_cast<std::uint64_t>(value));
    }
};

/// Call it where points are won; labels show them with {score} and {best}.
void addPoints(World& world, int points) {
    Score& score = world.resource<Score>();
    score.points += points;
    score.best = std::max(score.best, score.points);
    showText(world, "score", format("{}", score.points));
    showText(world, "best", format("{}", score.best));
}

void addScore(Module& module) { module.resources<Score>(); }
// end
}  // namespace scores

namespace menus {
// doc
struct GameKeys {
    SceneId menu;  ///< scene of the main menu

    static void describe(TypeBuilder<GameKeys>& type) {
        type.name("GameKeys").doc("R begins the scene again, Escape returns to the menu.");
        type.field<&GameKeys::menu>("menu").doc("Scene of the main menu.");
    }
};

struct GameKeySystem {
    void update(World& world, float) {
        for (auto [entity, keys] : world.query<const GameKeys>()) {
            const Input& input = inputFor(world, entity);
            if (input.isPressed(Key::R)) restartScene(world);
            if (input.isPressed(Key::Escape)) changeScene(world, keys.menu);
        }
    }
};

void addGameKeys(Module& module) {
    module.components<GameKeys>();
    module.system<GameKeySystem, GameKeys>();
}
// end
}  // namespace menus

namespace patrols {
// doc
struct Shuttle {
    Vec2 way = {100.0f, 0.0f};  ///< px, from the initial position to the other end
    float speed = 60.0f;        ///< px/s
    Vec2 home;                  ///< px, initial position
    int direction = 0;          ///< 1: to the other end, -1: back, 0: not started

    static void describe(TypeBuilder<Shuttle>& type) {
        type.name("Shuttle").doc("Moves a KinematicBody back and forth.");
        type.field<&Shuttle::way>("way").unit(Unit::Pixels).doc("To the other end, px.");
        type.field<&Shuttle::speed>("speed").unit(Unit::PixelsPerSecond).range(0.0f, 2000.0f);
        type.field<&Shuttle::home>("home").unit(Unit::Pixels).transient();
        type.field<&Shuttle::direction>("direction").transient();
    }
};

struct ShuttleSystem {
    void update(World& world, float) {
        for (auto [entity, shuttle, body, transform] :
             world.query<Shuttle, KinematicBody, const Transform>()) {
            if (shuttle.direction == 0) shuttle.home = transform.position, shuttle.direction = 1;
            const float done = dot(transform.position - shuttle.home, normalized(shuttle.way));  // px
            if (done >= length(shuttle.way)) shuttle.direction = -1;
            if (done <= 0.0f) shuttle.direction = 1;
            const auto sign = static_cast<float>(shuttle.direction);
            body.velocity = normalized(shuttle.way) * (sign * shuttle.speed);
        }
    }
};

void addShuttles(Module& module) {
    module.components<Shuttle>();
    module.system<ShuttleSystem, Shuttle>(before<PhysicsSystem>());
}
// end
}  // namespace patrols

namespace sparks {
// doc
struct Sparks {
    SoundId sound;
    float impulse = 100.0f;  ///< kg px/s, of the weakest hit that counts

    static void describe(TypeBuilder<Sparks>& type) {
        type.name("Sparks").doc("Emits sparks and a sound where something hits it hard.");
        type.field<&Sparks::sound>("sound").doc("Sound of a hit.");
        type.field<&Sparks::impulse>("impulse").range(0.0f, 1e6f).doc("Of the weakest hit, kg px/s.");
    }
};

struct SparkSystem {
    void update(World& world, float) {
        for (const ContactBegan& contact : world.events<ContactBegan>()) {
            for (const EntityId entity : {contact.a, contact.b}) {
                const Sparks* sparks = world.find<const Sparks>(entity);
                if (sparks == nullptr || contact.impulse < sparks->impulse) continue;
                burst(world, contact.point, 12, {.spread = kTau, .speed = 90.0f});
                if (!sparks->sound.empty()) playSound(world, sparks->sound, 0.6f);
            }
        }
    }
};

void addSparks(Module& module) {
    module.components<Sparks>();
    module.system<SparkSystem, Sparks>();
}
// end
}  // namespace sparks

namespace pausing {
// doc
struct PauseSystem {
    void update(World& world, float) {
        // The whole game's input, not that of an entity: the overlay takes the input of the scene below.
        if (!world.resource<Input>().isPressed(Action::Pause)) return;
        const bool isPaused = world.resource<LoadedScenes>().scenes.size() > 1;
        isPaused ? hideOverlay(world) : showOverlay(world, "pause");
    }
};

void addPause(Module& module) { module.system<PauseSystem>(); }
// end
}  // namespace pausing
}  // namespace plumb
