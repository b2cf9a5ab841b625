#pragma once

#include <cstdint>

#include "reflect/entity_id.hpp"
#include "reflect/field_types.hpp"

namespace plumb {

/// A sound that begins in this tick. Emitted by the simulation, heard by what plays sounds: the tick tells
/// a sound that a replayed tick brings again from a new one.
struct PlaySound {
    SoundId sound;
    float volume = 1.0f;  ///< ratio
    EntityId source;      ///< what made it, or empty
    std::uint64_t tick = 0;
};

}  // namespace plumb
