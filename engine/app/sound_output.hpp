#pragma once

#include <utility>

#include "audio/mixer.hpp"
#include "ecs/world.hpp"

namespace plumb {

/// Makes audible what a world does: its PlaySound events and its Music. Changes nothing in the world. The
/// device is opened for the first sound, or at once where the effect "sound" is pinned on; pinned off, all is
/// silent and it stays closed.
class SoundOutput {
public:
    explicit SoundOutput(AssetStore& assets, Mixer::OpenDevice open = openAudioDevice)
        : mixer_{assets, std::move(open)} {}

    /// After every tick: gathers what the tick asked for.
    void listen(const World& world);
    /// Once a frame: plays what was gathered.
    void play() { mixer_.play(queue_); }
    void setPaused(bool paused) { mixer_.setPaused(paused); }

private:
    void stopMusic();

    Mixer mixer_;
    SoundQueue queue_;
    bool hasMusic_ = false;
    bool counted_ = false;  // that the device is open
};

}  // namespace plumb
