#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reflect/field_types.hpp"

namespace plumb {

/// A sound that the simulation requests.
struct SoundEvent {
    std::uint64_t tick = 0;  ///< tick in which it is played
    SoundId sound;
    float volume = 1.0f;  ///< ratio
    float pan = 0.0f;     ///< -1 left .. 1 right
};

/// Sounds that the simulation has requested and the mixer has not played yet. A tick that is simulated again
/// after a rollback or a short rewind requests its sounds again: each (tick, sound) is accepted only once.
class SoundQueue {
public:
    static constexpr std::uint64_t kMemory = 600;       ///< ticks, see add()
    static constexpr std::size_t kMaxRemembered = 512;  ///< accepted sounds

    SoundQueue();

    void add(const SoundEvent& event);  ///< an event kMemory ticks older than the newest resets the queue

    /// The events accepted since the last clear(), in order.
    [[nodiscard]] std::span<const SoundEvent> waiting() const { return waiting_; }
    void clear() { waiting_.clear(); }

    /// Discards the events and the list of accepted sounds, e.g. when another scene begins.
    void reset();

private:
    struct Passed {
        std::uint64_t tick = 0;
        std::uint64_t sound = 0;
    };

    std::vector<SoundEvent> waiting_;
    std::vector<Passed> passed_;  // ring buffer of the accepted sounds
    std::size_t oldest_ = 0;      // index in passed_
    std::uint64_t newest_ = 0;    // the latest tick of an event
};

}  // namespace plumb
