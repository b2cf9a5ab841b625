#include "gameplay/delayed_events.hpp"

#include <algorithm>

#include "core/assert.hpp"

namespace plumb {
namespace {

/// Returns the functions that emit events, indexed by event type. Not part of a world, as they are code.
std::array<DelayedEvents::Emit, kMaxTypes>& emitters() {
    static std::array<DelayedEvents::Emit, kMaxTypes> functions{};
    return functions;
}

}  // namespace

void DelayedEvents::addTo(Hasher& hasher) const {
    // Without the bytes of the event: those between its members differ from run to run.
    for (const Entry& entry : entries) {
        hasher.add(entry.tick);
        hasher.add(entry.number);
    }
}

void DelayedEvents::dropReloadable() {
    std::erase_if(entries, [](const Entry& entry) { return isReloadable(entry.type); });
}

std::uint64_t ticksOf(float seconds) {
    constexpr float kTicksPerSecond = 60.0f;
    constexpr float kMax = 1e9f;      // ticks: half a year
    if (!(seconds > 0.0f)) return 1;  // NaN too
    return static_cast<std::uint64_t>(std::clamp(seconds * kTicksPerSecond + 0.5f, 1.0f, kMax));
}

DelayedEvent addDelayed(World& world, TypeKey type, DelayedEvents::Emit emit, const void* event,
                        std::size_t size, float seconds) {
    emitters()[type] = emit;
    DelayedEvents& delayed = world.resource<DelayedEvents>();
    DelayedEvents::Entry entry;
    entry.tick = world.tick + ticksOf(seconds);
    entry.number = ++delayed.count;
    entry.type = type;
    entry.size = static_cast<std::uint32_t>(size);
    std::memcpy(entry.bytes.data(), event, size);
    const auto at = std::upper_bound(
        delayed.entries.begin(), delayed.entries.end(), entry.tick,
        [](std::uint64_t tick, const DelayedEvents::Entry& other) { return tick < other.tick; });
    delayed.entries.insert(at, entry);
    return {entry.number};
}

void cancel(World& world, DelayedEvent event) {
    auto* delayed = world.findResource<DelayedEvents>();
    if (delayed == nullptr) return;
    std::erase_if(delayed->entries,
                  [&](const DelayedEvents::Entry& entry) { return entry.number == event.number; });
}

void emitDelayed(World& world, const DelayedEvents::Entry& entry) {
    emitters()[entry.type](world, entry.bytes.data());
}

}  // namespace plumb
