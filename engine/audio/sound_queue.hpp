#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reflect/field_types.hpp"

namespace plumb {

/// A sound that the simulation asks for.
struct SoundEvent {
    std::uint64_t tick = 0;  ///< in which it sounds
    SoundId sound;
    float volume = 1.0f;  ///< ratio
    float pan = 0.0f;     ///< -1 left .. 1 right
};

/// Sounds on their way from the simulation to the loudspeakers. A tick that is run again, after a rollback or
/// a rewind of a few seconds, asks for the same sounds again: each (tick, sound) passes once.
class SoundQueue {
public:
    static constexpr std::uint64_t kMemory = 600;        ///< ticks; a tick further back begins a new time
    static constexpr std::size_t kMostRemembered = 512;  ///< sounds

    SoundQueue();

    void add(const SoundEvent& event);

    /// What was added since the last `clear`, in order.
    [[nodiscard]] std::span<const SoundEvent> waiting() const { return waiting_; }
    void clear() { waiting_.clear(); }

    /// Forgets all, e.g. when another scene begins.
    void reset();

private:
    struct Passed {
        std::uint64_t tick = 0;
        std::uint64_t sound = 0;
    };

    std::vector<SoundEvent> waiting_;
    std::vector<Passed> passed_;  // a ring
    std::size_t oldest_ = 0;
    std::uint64_t newest_ = 0;  // tick
};

}  // namespace plumb
