#include <plumb.hpp>

using namespace plumb;

struct Hero {
    int lives = 3;
    float mercy = 1.0f;  ///< s after a hit in which no other one counts
    float safe = 0.0f;   ///< s, rest of `mercy`

    static void describe(TypeBuilder<Hero>& type) {
        type.name("Hero").doc("Loses lives while it touches a Thorn; {lives} shows them.");
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
    std::vector<EntityId> touched;  // a member, so that its memory is used again

    void update(World& world, float dt) {
        for (auto [entity, hero] : world.query<Hero>()) {
            hero.safe = std::max(0.0f, hero.safe - dt);
            if (hero.safe == 0.0f && hero.lives > 0 && touchesThorn(world, entity)) {
                hero.safe = hero.mercy;
                if (--hero.lives == 0) world.emit(HeroDied{entity});
            }
            showText(world, "lives", format("{}", hero.lives));
        }
    }
    bool touchesThorn(World& world, EntityId hero) {
        touchesOf(world, hero, touched);
        return std::any_of(touched.begin(), touched.end(),
                           [&](EntityId other) { return world.has<Thorn>(other); });
    }
};

/// Shows scenes/game_over.scene.json over the game, which rests.
void endGame(World& world, const HeroDied&) { showOverlay(world, "game_over"); }

void addHealth(Module& module) {
    module.components<Hero, Thorn>();
    module.system<HealthSystem, Hero>();
    module.on<HeroDied, endGame>();
}
