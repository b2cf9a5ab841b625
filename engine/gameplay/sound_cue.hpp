#pragma once

#include "ecs/world.hpp"
#include "gameplay/components/sound_cues.hpp"
#include "scene/play_sound.hpp"

namespace plumb {

/// Plays one of an entity's sounds: `playCue(world, coin, &SoundCues::collect)`. Silent without SoundCues.
inline void playCue(World& world, EntityId entity, SoundId SoundCues::*cue) {
    const auto* cues = world.find<const SoundCues>(entity);
    if (cues == nullptr || (cues->*cue).empty()) return;
    world.emit(PlaySound{cues->*cue, cues->volume, entity, world.tick});
}

}  // namespace plumb
