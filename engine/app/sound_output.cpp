#include "app/sound_output.hpp"

#include "app/sound_place.hpp"
#include "gameplay/components/music.hpp"
#include "scene/effects.hpp"
#include "scene/play_sound.hpp"

namespace plumb {

void SoundOutput::stopMusic() {
    if (!hasMusic_) return;
    mixer_.stopMusic();
    hasMusic_ = false;
}

void SoundOutput::listen(const World& world) {
    if (Effects* effects = world.service<Effects>()) {
        if (mixer_.isOpen() && !std::exchange(countedOpen_, true)) effects->count("sound");
        const Pin pin = effects->pinOf(effects->table().find("sound"));
        if (pin == Pin::Off) return stopMusic();
        if (pin == Pin::On) mixer_.open();
    }
    for (const PlaySound& sound : world.events<PlaySound>()) {
        queue_.add({sound.tick, sound.sound, sound.volume, panOf(world, sound.source)});
    }
    // If an overlay has no music, that of the scene it pauses continues.
    Entity entity = world.query<const Music>().first();
    if (!entity) entity = world.query<const Music>(withPaused).first();
    if (entity) {
        const auto& music = world.get<Music>(entity);
        mixer_.playMusic(music.sound, music.volume);
        hasMusic_ = true;
    } else {
        stopMusic();
    }
}

}  // namespace plumb
