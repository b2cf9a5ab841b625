#pragma once

#include <string_view>

namespace plumb {

class World;

/// Lets feet be heard: the step sound at every frame of an animation whose event is "step".
/// Reads: AnimationFrameBegan, SoundCues. Emits: PlaySound.
/// When: after animation.
struct SoundCueSystem {
    static constexpr std::string_view kName = "sound cues";

    void update(World& world, float dt);
};

}  // namespace plumb
