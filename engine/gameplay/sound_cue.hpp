#pragma once

#include "ecs/world.hpp"
#include "gameplay/components/sound_cues.hpp"
#include "scene/play_sound.hpp"

namespace plumb {

/// Plays a sound of an entity's SoundCues, e.g. `playCue(world,
/// coin, &SoundCues::collect)`. Does nothing if the entity lacks it.
inline void playCue(World& world, EntityId entity, SoundId SoundCues::*cue) {
    const auto* cues = world.find<const SoundCues>(entity);
    if (cues == nullptr || (cues->*cue).empty()) return;
    world.emit(PlaySound{cues->*cue, cues->volume, entity, world.tick});
}

}  // namespace plumb
