#pragma once

#include <cstdint>

#include "reflect/entity_id.hpp"
#include "reflect/field_types.hpp"

namespace plumb {

/// Event: a sound starts in this tick. Emitted by the simulation and read by the sound output, which uses
/// `tick` to ignore sounds that a repeated tick emits again.
struct PlaySound {
    SoundId sound;
    float volume = 1.0f;  ///< ratio
    EntityId source;      ///< entity that emits it; may be empty
    std::uint64_t tick = 0;
};

}  // namespace plumb
