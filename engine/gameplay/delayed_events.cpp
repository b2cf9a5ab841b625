#include "gameplay/delayed_events.hpp"

#include <algorithm>

#include "scene/loaded_scene.hpp"
#include "scene/scene_requests.hpp"
#include "scene/scene_stack.hpp"

namespace plumb {
namespace {

/// Returns the functions that emit events, indexed by event type. Not part of a world, as they are code.
std::array<DelayedEvents::Emit, kMaxTypes>& emitters() {
    static std::array<DelayedEvents::Emit, kMaxTypes> functions{};
    return functions;
}

/// The order of entries; no two are equal.
bool isBefore(const DelayedEvents::Entry& a, const DelayedEvents::Entry& b) {
    return a.tick != b.tick ? a.tick < b.tick : a.number < b.number;
}

/// The scene that a timer belongs to, see emitAfter(). @return its LoadedScene::loading; 0: the whole game
std::uint32_t sceneOfAsker(const World& world, EntityId asker) {
    const std::uint32_t scene = loadingOf(world, asker);
    const SceneRequests* requests = world.findResource<SceneRequests>();
    if (scene == 0 || requests == nullptr || !requests->close) return scene;
    const std::vector<LoadedScene>& scenes = world.findResource<LoadedScenes>()->scenes;
    const bool isClosing = scenes.size() > 1 && scenes.back().loading == scene;
    return isClosing ? scenes[scenes.size() - 2].loading : scene;
}

enum class Fate : std::uint8_t { Runs, Rests, Ends };

/// What happens to the timers of a scene in this tick. Those of the whole game rest while any scene is
/// paused.
Fate fateOf(const LoadedScenes& loaded, std::uint32_t scene) {
    bool isPaused = false;
    for (auto above = loaded.scenes.rbegin(); above != loaded.scenes.rend(); ++above) {
        if (above->loading == scene) return isPaused ? Fate::Rests : Fate::Runs;
        isPaused = isPaused || above->pauses;
    }
    if (scene != 0) return Fate::Ends;
    return isPaused ? Fate::Rests : Fate::Runs;
}

}  // namespace

void DelayedEvents::addTo(Hasher& hasher) const {
    // Without the bytes of the event: those between its members differ from run to run. Without the number of
    // the scene: that counts scenes which the editor may have loaded before.
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

DelayedEvent addDelayed(World& world, EntityId asker, float seconds, DelayedEvents::Entry entry,
                        DelayedEvents::Emit emit) {
    emitters()[entry.type] = emit;
    DelayedEvents& delayed = world.resource<DelayedEvents>();
    entry.tick = world.tick + ticksOf(seconds);
    entry.number = ++delayed.count;
    entry.scene = sceneOfAsker(world, asker);
    const auto at = std::upper_bound(delayed.entries.begin(), delayed.entries.end(), entry, isBefore);
    delayed.entries.insert(at, entry);
    return {entry.number};
}

void followScenes(const World& world, DelayedEvents& delayed) {
    const LoadedScenes* loaded = world.findResource<LoadedScenes>();
    if (loaded == nullptr) return;
    std::erase_if(delayed.entries, [&](const DelayedEvents::Entry& entry) {
        return fateOf(*loaded, entry.scene) == Fate::Ends;
    });
    bool anyRests = false;
    for (DelayedEvents::Entry& entry : delayed.entries) {
        if (fateOf(*loaded, entry.scene) != Fate::Rests) continue;
        ++entry.tick;
        anyRests = true;
    }
    if (anyRests) std::sort(delayed.entries.begin(), delayed.entries.end(), isBefore);
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
