#include <plumb.hpp>

using namespace plumb;

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
                ParticleEmitter look;
                look.spread = kTau;  // rad, in all directions
                look.speed = 90.0f;  // px/s
                burst(world, contact.point, 12, look);
                if (!sparks->sound.empty()) playSound(world, sparks->sound, 0.6f);
            }
        }
    }
};

void addSparks(Module& module) {
    module.components<Sparks>();
    module.system<SparkSystem, Sparks>();
}
