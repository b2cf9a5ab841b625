#pragma once

#include <plumb.hpp>

// The data of the game. The inspector edits all described fields, also while the game runs; `transient` ones
// are state, which is not saved. The files in prefabs/ and scenes/ contain the values that differ from those
// here.

using namespace plumb;

/// The ship that the player flies.
struct Player {
    float speed = 430.0f;          ///< px/s, maximum speed
    float acceleration = 3000.0f;  ///< px/s^2, with which it reaches that speed, and brakes

    static void describe(TypeBuilder<Player>& type) {
        type.name("Player").doc("The ship that the player flies.");
        type.field<&Player::speed>("speed").unit(Unit::PixelsPerSecond).range(0.0f, 2000.0f);
        type.field<&Player::acceleration>("acceleration")
            .unit(Unit::PixelsPerSecondSquared)
            .range(0.0f, 20000.0f)
            .doc("Acceleration and braking, px/s2; a low one makes the ship slide.");
    }
};

/// Shoots bullets, aimed by keys, a stick or the mouse.
struct Gun {
    PrefabId bullet;
    EntityId barrel;          ///< the child that points at the target
    SoundId sound;            ///< of a shot
    float interval = 0.13f;   ///< s, between two shots
    float speed = 900.0f;     ///< px/s, of a bullet
    float spread = 0.04f;     ///< rad, maximum deviation of a shot from the aim
    float length = 30.0f;     ///< px, from the middle of the ship to new bullets
    Vec2 aim = {1.0f, 0.0f};  ///< direction, length 1
    float wait = 0.0f;        ///< s, until the next shot is possible

    static void describe(TypeBuilder<Gun>& type) {
        type.name("Gun").doc("Shoots bullets, aimed by keys, a stick or the mouse.");
        type.field<&Gun::bullet>("bullet").doc("Prefab of a bullet.");
        type.field<&Gun::barrel>("barrel").doc("The child that points at the target.");
        type.field<&Gun::sound>("sound").doc("Sound of a shot.");
        type.field<&Gun::interval>("interval")
            .unit(Unit::Seconds)
            .range(0.02f, 5.0f)
            .doc("Between shots, s.");
        type.field<&Gun::speed>("speed").unit(Unit::PixelsPerSecond).range(1.0f, 3000.0f);
        type.field<&Gun::spread>("spread").unit(Unit::Radians).range(0.0f, 3.1f).doc("Inaccuracy, degrees.");
        type.field<&Gun::length>("length").unit(Unit::Pixels).doc("From the ship to new bullets, px.");
        type.field<&Gun::aim>("aim").transient();
        type.field<&Gun::wait>("wait").unit(Unit::Seconds).transient();
    }
};

/// Damages the first enemy that it touches.
struct Bullet {
    int damage = 1;      ///< points of the enemy's hull
    float push = 60.0f;  ///< kg px/s, impulse on the enemy: light ones are thrown back further
    PrefabId sparks;     ///< appear where it hits

    static void describe(TypeBuilder<Bullet>& type) {
        type.name("Bullet").doc("Damages the first enemy that it touches.");
        type.field<&Bullet::damage>("damage").range(0.0f, 100.0f).doc("Points of the enemy's hull.");
        type.field<&Bullet::push>("push").range(0.0f, 10000.0f).doc("Impulse on the enemy, kg px/s.");
        type.field<&Bullet::sparks>("sparks").doc("Prefab that appears where it hits.");
    }
};

/// Flies at the player, and is destroyed when it rams it.
struct Enemy {
    float speed = 130.0f;         ///< px/s, maximum speed
    float acceleration = 400.0f;  ///< px/s^2: a low one lets it overshoot
    int damage = 1;               ///< points of the player's hull that ramming costs
    int worth = 10;               ///< points of the score

    static void describe(TypeBuilder<Enemy>& type) {
        type.name("Enemy").doc("Flies at the player, and is destroyed when it rams it.");
        type.field<&Enemy::speed>("speed").unit(Unit::PixelsPerSecond).range(0.0f, 2000.0f);
        type.field<&Enemy::acceleration>("acceleration")
            .unit(Unit::PixelsPerSecondSquared)
            .range(0.0f, 20000.0f)
            .doc("Acceleration towards the player, px/s2; a low one lets it overshoot.");
        type.field<&Enemy::damage>("damage").range(0.0f, 100.0f).doc("Points that ramming costs the player.");
        type.field<&Enemy::worth>("worth").range(0.0f, 10000.0f).doc("Points of the score.");
    }
};

/// Makes a ship destructible: the player's and those of enemies.
struct Hull {
    int points = 1;       ///< hits that it bears; at 0 it is Destroyed
    float mercy = 0.0f;   ///< s after a hit in which no other one counts
    float flash = 0.15f;  ///< s after a hit in which it returns from white to its color
    Color color;          ///< of the sprite and of the explosion
    PrefabId explosion;   ///< takes its place
    float shake = 4.0f;   ///< px, amplitude by which the explosion shakes the camera
    SoundId hitSound;     ///< of a hit that it survives
    SoundId endSound;     ///< of its explosion
    float safe = 0.0f;    ///< s, rest of `mercy`

    static void describe(TypeBuilder<Hull>& type) {
        type.name("Hull").doc("Makes a ship destructible: the player's and those of enemies.");
        type.field<&Hull::points>("points").range(0.0f, 1000.0f).doc("Hits that it bears.");
        type.field<&Hull::mercy>("mercy").unit(Unit::Seconds).doc("After a hit no other one counts, s.");
        type.field<&Hull::flash>("flash").unit(Unit::Seconds).doc("From white to its color, after a hit, s.");
        type.field<&Hull::color>("color").doc("Color of the sprite and of the explosion.");
        type.field<&Hull::explosion>("explosion").doc("Prefab that takes its place.");
        type.field<&Hull::shake>("shake").unit(Unit::Pixels).doc("Shakes the camera at its end, px.");
        type.field<&Hull::hitSound>("hitSound").doc("Sound of a hit that it survives.");
        type.field<&Hull::endSound>("endSound").doc("Sound of its explosion.");
        type.field<&Hull::safe>("safe").unit(Unit::Seconds).transient();
    }
};

/// Shows the player's hull: the Sprite gets as wide as it has points.
struct HullBar {
    int cell = 24;  ///< px, width of one point

    static void describe(TypeBuilder<HullBar>& type) {
        type.name("HullBar").doc("Shows the player's hull: the Sprite gets as wide as it has points.");
        type.field<&HullBar::cell>("cell")
            .unit(Unit::Pixels)
            .range(1.0f, 100.0f)
            .doc("Width of a point, px.");
    }
};

/// Sends enemies from all sides, one wave after the other, and ends the game when the player is destroyed.
struct Waves {
    Rect area = {-40.0f, -40.0f, 1360.0f, 800.0f};  ///< px: enemies appear on its border
    FixedList<PrefabId, 4> kinds;  ///< prefabs of enemies; the second appears from wave 2 on, and so on
    int first = 6;                 ///< number of enemies in the first wave
    int growth = 4;                ///< number of enemies that each wave has more than the one before
    float interval = 0.55f;        ///< s, between two enemies of a wave
    float pause = 1.8f;            ///< s, before a wave, and before the game is over
    float speedUp = 0.06f;         ///< ratio by which enemies get faster with each wave
    EntityId banner;               ///< Label that announces a wave
    int wave = 0;                  ///< number of the current wave; 0: not begun
    int left = 0;                  ///< number of its enemies that have not appeared yet
    float wait = 0.0f;             ///< s, until the next step

    static void describe(TypeBuilder<Waves>& type) {
        type.name("Waves").doc("Sends enemies from all sides, one wave after the other.");
        type.field<&Waves::area>("area").unit(Unit::Pixels).doc("Enemies appear on its border, px.");
        type.field<&Waves::kinds>("kinds").doc("Prefabs of enemies; the second appears from wave 2 on, ...");
        type.field<&Waves::first>("first").range(1.0f, 1000.0f).doc("Number of enemies in wave 1.");
        type.field<&Waves::growth>("growth").range(0.0f, 100.0f).doc("More enemies with each wave.");
        type.field<&Waves::interval>("interval").unit(Unit::Seconds).doc("Between two enemies, s.");
        type.field<&Waves::pause>("pause").unit(Unit::Seconds).doc("Before a wave and at the end, s.");
        type.field<&Waves::speedUp>("speedUp").unit(Unit::Ratio).doc("Enemies get faster with each wave.");
        type.field<&Waves::banner>("banner").doc("Label that announces a wave.");
        type.field<&Waves::wave>("wave").transient();
        type.field<&Waves::left>("left").transient();
        type.field<&Waves::wait>("wait").unit(Unit::Seconds).transient();
    }
};

/// What outlives the scene: a resource of the world, shown by labels with {score}, {best} and {wave}.
struct Score {
    int points = 0;
    int best = 0;  ///< highest score since the program was started
    int wave = 0;

    static void describe(TypeBuilder<Score>& type) {
        type.name("Score");
        type.field<&Score::points>("points");
        type.field<&Score::best>("best");
        type.field<&Score::wave>("wave");
    }
    /// Makes it part of the world's hash, so that replays check it.
    void addTo(Hasher& hasher) const {
        for (const int value : {points, best, wave}) hasher.add(static_cast<std::uint64_t>(value));
    }
};

/// Event: a hull has no points left. The entity still exists; explode() removes it.
struct Destroyed {
    EntityId entity;
};
