#pragma once

#include "audio/mixer.hpp"
#include "ecs/world.hpp"

namespace plumb {

/// Makes audible what a world does: its PlaySound events and its Music. Changes nothing in the world.
class SoundOutput {
public:
    explicit SoundOutput(AssetStore& assets) : mixer_{assets} {}

    /// After every tick: gathers what the tick asked for.
    void listen(World& world);
    /// Once a frame: plays what was gathered.
    void play() { mixer_.play(queue_); }
    void setPaused(bool paused) { mixer_.setPaused(paused); }

private:
    Mixer mixer_;
    SoundQueue queue_;
    bool hasMusic_ = false;
};

}  // namespace plumb
