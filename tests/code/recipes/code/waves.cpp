#include <plumb.hpp>

using namespace plumb;

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

/// Begins a wave, and sets a timer for the next one, which does so again.
void beginWave(World& world, const WaveDue& due) {
    Waves* waves = world.find<Waves>(due.waves);
    if (waves == nullptr) return;  // destroyed since
    const int count = waves->first + waves->wave++;
    if (waves->enemy.empty()) {
        logError("Game", Error{"Waves.enemy", "no prefab is chosen", "choose the enemy in the inspector"});
        return;
    }
    const Vec2 place = worldPose(world, due.waves).position;
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
