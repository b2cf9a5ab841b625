#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "core/hash.hpp"
#include "ecs/world.hpp"
#include "reflect/type_key.hpp"

namespace plumb {

/// Events that are emitted in later ticks. A world resource of plain data: rewinding and saved snapshots
/// include it.
struct DelayedEvents {
    static constexpr std::size_t kBytes = 48;  ///< maximum size of an event
    using Emit = void (*)(World& world, const std::byte* event);

    struct Entry {
        std::uint64_t tick = 0;                 ///< World::tick in which it is emitted
        std::uint64_t number = 0;               ///< orders events of the same tick; identifies the entry
        TypeKey type = 0;                       ///< type of the event
        std::uint32_t scene = 0;                ///< LoadedScene::loading of its scene; 0: the whole game
        std::uint32_t size = 0;                 ///< size of the event, bytes
        std::array<std::byte, kBytes> bytes{};  ///< the event
    };

    std::vector<Entry> entries;  ///< in the order of their ticks, then of their numbers
    std::uint64_t count = 0;     ///< number of events that were ever delayed

    void addTo(Hasher& hasher) const;
    /// Removes events whose types belong to a project's code, which the editor can load again.
    void dropReloadable();
};

/// Identifies a delayed event, to cancel it.
struct DelayedEvent {
    std::uint64_t number = 0;  ///< 0: none
};

/// Returns the number of ticks nearest to a time, at least 1. @param seconds  s
std::uint64_t ticksOf(float seconds);

/// Implementation of emitAfter(), without the event's type.
/// @param entry  the event: its type, size and bytes
DelayedEvent addDelayed(World& world, EntityId asker, float seconds, DelayedEvents::Entry entry,
                        DelayedEvents::Emit emit);

/// Ends the timers whose scenes are gone, and lets those wait whose scenes are paused.
void followScenes(const World& world, DelayedEvents& delayed);

/// Emits the event of an entry now.
void emitDelayed(World& world, const DelayedEvents::Entry& entry);

/// Emits an event at the beginning of a later tick: a timer. Entities that the event refers to may have been
/// destroyed by then. The timer belongs to the scene of `asker`: it rests while overlays pause that scene,
/// and ends with it. After hideOverlay() the timers of an overlay belong to the scene below it; those of
/// Persistent entities survive every change of the scene.
/// @param asker    an entity; empty: the scene that runs, as for an entity that code creates
/// @param seconds  s from now on, rounded to ticks
template <class E>
DelayedEvent emitAfter(World& world, EntityId asker, float seconds, const E& event) {
    static_assert(std::is_trivially_copyable_v<E>,
                  "delayed events are plain data, so that they can be rewound");
    static_assert(sizeof(E) <= DelayedEvents::kBytes, "the event exceeds DelayedEvents::kBytes bytes");
    const auto emit = [](World& target, const std::byte* bytes) {
        E delayed;
        std::memcpy(&delayed, bytes, sizeof(E));
        target.emit(delayed);
    };
    DelayedEvents::Entry entry;
    entry.type = typeKey<E>();
    entry.size = sizeof(E);
    std::memcpy(entry.bytes.data(), &event, sizeof(E));
    return addDelayed(world, asker, seconds, entry, emit);
}
template <class E>
DelayedEvent emitAfter(World& world, float seconds, const E& event) {
    return emitAfter(world, EntityId{}, seconds, event);
}

/// Cancels a delayed event; does nothing if it was emitted already.
void cancel(World& world, DelayedEvent event);

}  // namespace plumb
