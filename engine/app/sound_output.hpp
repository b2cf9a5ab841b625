#pragma once

#include <utility>

#include "audio/mixer.hpp"
#include "ecs/world.hpp"

namespace plumb {

/// Plays the PlaySound events and the Music of a world. Does not change the
/// world. The audio device is opened for the first sound, or at once if the
/// effect "sound" is pinned on; if it is pinned off, no sound is played.
class SoundOutput {
public:
    explicit SoundOutput(AssetStore& assets, Mixer::OpenDevice open = openAudioDevice)
        : mixer_{assets, std::move(open)} {}

    /// Collects the sounds of a tick. Call after every tick.
    void listen(const World& world);
    /// Plays the collected sounds. Call once per frame.
    void play() { mixer_.play(queue_); }
    /// Call after a saved game was loaded: sounds of its ticks were not played yet, even if their numbers
    /// were.
    void restart() { queue_.reset(); }
    /// @param master, music, sounds  ratios, 0..1
    void setVolumes(float master, float music, float sounds) {
        mixer_.setMasterVolume(master);
        mixer_.setVolume(SoundGroup::Music, music);
        mixer_.setVolume(SoundGroup::Effects, sounds);
        mixer_.setVolume(SoundGroup::Interface, sounds);
    }
    void setPaused(bool paused) { mixer_.setPaused(paused); }

private:
    void stopMusic();

    Mixer mixer_;
    SoundQueue queue_;
    bool hasMusic_ = false;
    bool countedOpen_ = false;  // the opened device was counted as a use of the effect
};

}  // namespace plumb
