#pragma once

#include <string_view>

namespace plumb {

class World;

/// Plays the step sound at every animation frame with the event "step".
/// Reads: AnimationFrameBegan, SoundCues. Emits: PlaySound.
/// When: after animation.
struct SoundCueSystem {
    static constexpr std::string_view kName = "sound cues";

    void update(World& world, float dt);
};

}  // namespace plumb
