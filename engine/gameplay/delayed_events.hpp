#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/hash.hpp"
#include "core/state_archive.hpp"
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

    std::vector<Entry> entries;  ///< a binary heap: the first is the next, by tick and then by number
    std::uint64_t count = 0;     ///< number of events that were ever delayed
    /// LoadedScenes::loadings and the number of open scenes as followScenes() found them last: they change
    /// whenever a scene is opened or closed.
    std::uint32_t loadings = 0, openScenes = 0;

    void addTo(Hasher& hasher) const;
    void archive(StateArchive& archive);
    /// To be called after another version of a project's code was loaded: its functions emit the events from
    /// now on. Removes events of types that it does not delay or whose size has changed. @return their names,
    /// sorted
    std::vector<std::string> followCode();
};

/// Identifies a delayed event, to cancel it.
struct DelayedEvent {
    std::uint64_t number = 0;  ///< 0: none
};

/// Returns the number of ticks nearest to a time, at least 1. @param seconds  s
std::uint64_t ticksOf(float seconds);
/// False for NaN and infinity: logs an error that names the running system, the call and the type of the
/// event or component, once until Reports::forget().
/// @param seconds  s
/// @param call     e.g. "emitAfter()"
bool isTime(const World& world, float seconds, std::string_view call, std::string_view type);

/// A type of events that code delays.
struct DelayedType {
    const TypeKey* key;     ///< a pointer, as the key may be initialized later
    std::string_view name;  ///< of the type
    std::uint32_t size;     ///< bytes
    DelayedEvents::Emit emit;
    std::uint32_t version;  ///< reloadableVersion() of the code
};

/// Lists the type for DelayedEvents::followCode(). @return it
DelayedType listDelayedType(const DelayedType& type);

/// Listed when the code that delays E is loaded, not only when it delays the first event.
template <class E>
inline const DelayedType kDelayedType = listDelayedType({&kTypeKey<E>, compilerTypeName<E>(), sizeof(E),
                                                         [](World& world, const std::byte* bytes) {
                                                             E event;
                                                             std::memcpy(&event, bytes, sizeof(E));
                                                             world.emit(event);
                                                         },
                                                         reloadableVersion()});

/// Implementation of emitAfter(), without the event's type.
/// @param event  DelayedType::size bytes
DelayedEvent addDelayed(World& world, EntityId asker, float seconds, const DelayedType& type,
                        const void* event);

/// Ends the timers whose scenes are gone, and lets those wait whose scenes are paused.
/// Cost: linear in the number of timers while a scene is paused and after the scenes have changed.
void followScenes(const World& world, DelayedEvents& delayed);

/// Emits the events that are due, in the order of their ticks and, of a tick, in that in which they were set.
void emitDue(World& world, DelayedEvents& delayed);

/// Emits an event at the beginning of a later tick: a timer. Entities that the event refers to may have been
/// destroyed by then. The timer belongs to the scene of `asker`: it rests while overlays pause that scene,
/// and ends with it. After hideOverlay() the timers of an overlay belong to the scene below it; those of
/// Persistent entities survive every change of the scene.
/// @param asker    an entity; empty: the scene that runs, as for an entity that code creates
/// @param seconds  s from now on, rounded to ticks, at least one
/// @error seconds is NaN or infinite: it is logged, no event is emitted, and the timer has the number 0
template <class E>
DelayedEvent emitAfter(World& world, EntityId asker, float seconds, const E& event) {
    static_assert(std::is_trivially_copyable_v<E>,
                  "delayed events are plain data, so that they can be rewound");
    static_assert(sizeof(E) <= DelayedEvents::kBytes, "the event exceeds DelayedEvents::kBytes bytes");
    return addDelayed(world, asker, seconds, kDelayedType<E>, &event);
}
template <class E>
DelayedEvent emitAfter(World& world, float seconds, const E& event) {
    return emitAfter(world, EntityId{}, seconds, event);
}

/// Cancels a delayed event; does nothing if it was emitted already.
/// Cost: linear in the number of pending events.
void cancel(World& world, DelayedEvent event);

}  // namespace plumb
