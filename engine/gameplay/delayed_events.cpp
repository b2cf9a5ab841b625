#include "gameplay/delayed_events.hpp"

#include <algorithm>
#include <cmath>

#include "core/crash.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "ecs/saved_type.hpp"
#include "scene/loaded_scene.hpp"
#include "scene/scene_requests.hpp"
#include "scene/scene_stack.hpp"

namespace plumb {
namespace {

/// The types that code delays, by key. Not part of a world, as they are code.
std::array<DelayedType, kMaxTypes>& delayedTypes() {
    static std::array<DelayedType, kMaxTypes> types{};
    return types;
}

/// The types that code has listed since followCode(), some before their keys were initialized.
std::vector<DelayedType>& listedTypes() {
    static std::vector<DelayedType> types;
    return types;
}

/// The order of the heap: true if `a` is emitted after `b`. No two entries are equal, so the order in which
/// they are taken from the heap does not depend on how it is arranged.
bool isAfter(const DelayedEvents::Entry& a, const DelayedEvents::Entry& b) {
    return a.tick != b.tick ? a.tick > b.tick : a.number > b.number;
}

void arrange(std::vector<DelayedEvents::Entry>& entries) {
    std::make_heap(entries.begin(), entries.end(), isAfter);
}

template <class Condition>
void removeIf(std::vector<DelayedEvents::Entry>& entries, const Condition& condition) {
    if (std::erase_if(entries, condition) > 0) arrange(entries);
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

void endTimersOfClosedScenes(DelayedEvents& delayed, const LoadedScenes& loaded) {
    if (delayed.loadings == loaded.loadings && delayed.openScenes == loaded.scenes.size()) return;
    delayed.loadings = loaded.loadings;
    delayed.openScenes = static_cast<std::uint32_t>(loaded.scenes.size());
    removeIf(delayed.entries,
             [&](const DelayedEvents::Entry& entry) { return fateOf(loaded, entry.scene) == Fate::Ends; });
}

void delayTimersOfPausedScenes(DelayedEvents& delayed, const LoadedScenes& loaded) {
    const auto pauses = [](const LoadedScene& scene) { return scene.pauses; };
    if (std::none_of(loaded.scenes.begin(), loaded.scenes.end(), pauses)) return;
    for (DelayedEvents::Entry& entry : delayed.entries) {
        if (fateOf(loaded, entry.scene) == Fate::Rests) ++entry.tick;
    }
    arrange(delayed.entries);
}

}  // namespace

void DelayedEvents::addTo(Hasher& hasher) const {
    // Without the bytes of the event: those between its members differ from run to run. Without the number of
    // the scene: that counts scenes which the editor may have loaded before.
    // As a sum, as the arrangement of the heap is not state.
    std::uint64_t sum = 0;
    for (const Entry& entry : entries) {
        Hasher one;
        one.add(entry.tick);
        one.add(entry.number);
        sum += one.value();
    }
    hasher.add(sum);
}

void DelayedEvents::archive(StateArchive& archive) {
    const std::size_t saved = archive.count(entries.size());
    if (archive.reading()) {
        for (const DelayedType& type : listedTypes()) delayedTypes()[*type.key] = type;
        listedTypes().clear();
        entries.assign(saved, {});
    }
    for (Entry& entry : entries) {
        archive.value(entry.tick);
        archive.value(entry.number);
        archive.value(entry.scene);
        archive.value(entry.size);
        archive.value(entry.bytes);
        archiveKey(archive, entry.type);
    }
    archive.value(count);
    archive.value(loadings);
    archive.value(openScenes);
    if (!archive.reading()) return;
    // Events that this version of the game does not delay, or that have another layout in it.
    std::erase_if(entries, [](const Entry& entry) {
        return entry.type >= kMaxTypes || delayedTypes()[entry.type].emit == nullptr ||
               delayedTypes()[entry.type].size != entry.size;
    });
    arrange(entries);
}

DelayedType listDelayedType(const DelayedType& type) { return listedTypes().emplace_back(type); }

std::vector<std::string> DelayedEvents::followCode() {
    for (const DelayedType& type : listedTypes()) delayedTypes()[*type.key] = type;
    listedTypes().clear();
    std::vector<std::string> dropped;
    removeIf(entries, [&](const Entry& entry) {
        if (!isReloadable(entry.type)) return false;
        const DelayedType& type = delayedTypes()[entry.type];
        if (type.version == reloadableVersion() && type.size == entry.size) return false;
        dropped.emplace_back(type.name);
        return true;
    });
    std::sort(dropped.begin(), dropped.end());
    dropped.erase(std::unique(dropped.begin(), dropped.end()), dropped.end());
    return dropped;
}

std::uint64_t ticksOf(float seconds) {
    constexpr float kTicksPerSecond = 60.0f;
    constexpr float kMax = 1e9f;      // ticks: half a year
    if (!(seconds > 0.0f)) return 1;  // NaN too
    return static_cast<std::uint64_t>(std::clamp(seconds * kTicksPerSecond + 0.5f, 1.0f, kMax));
}

bool isTime(const World& world, float seconds, std::string_view call, std::string_view type) {
    if (std::isfinite(seconds)) return true;
    const std::string_view system = Running::current;
    const std::string where = format("{}{}{} of {}", system, system.empty() ? "" : ": ", call, type);
    if (world.reports().isFirst("Code", where)) {
        logError("Code", Error{where, format("expected a time in s, found {}; nothing was done", seconds),
                               "check the computation of the time, e.g. for a division by 0"});
    }
    return false;
}

DelayedEvent addDelayed(World& world, EntityId asker, float seconds, const DelayedType& type,
                        const void* event) {
    if (!isTime(world, seconds, "emitAfter()", type.name)) return {};
    DelayedEvents::Entry entry;
    entry.type = *type.key;
    entry.size = type.size;
    std::memcpy(entry.bytes.data(), event, type.size);
    delayedTypes()[entry.type] = type;
    DelayedEvents& delayed = world.resource<DelayedEvents>();
    entry.tick = world.tick + ticksOf(seconds);
    entry.number = ++delayed.count;
    entry.scene = sceneOfAsker(world, asker);
    delayed.entries.push_back(entry);
    std::push_heap(delayed.entries.begin(), delayed.entries.end(), isAfter);
    return {entry.number};
}

void followScenes(const World& world, DelayedEvents& delayed) {
    const LoadedScenes* loaded = world.findResource<LoadedScenes>();
    if (loaded == nullptr) return;
    endTimersOfClosedScenes(delayed, *loaded);
    delayTimersOfPausedScenes(delayed, *loaded);
}

void cancel(World& world, DelayedEvent event) {
    auto* delayed = world.findResource<DelayedEvents>();
    if (delayed == nullptr) return;
    removeIf(delayed->entries,
             [&](const DelayedEvents::Entry& entry) { return entry.number == event.number; });
}

void emitDue(World& world, DelayedEvents& delayed) {
    std::vector<DelayedEvents::Entry>& entries = delayed.entries;
    while (!entries.empty() && entries.front().tick <= world.tick) {
        std::pop_heap(entries.begin(), entries.end(), isAfter);
        const DelayedEvents::Entry due = entries.back();
        entries.pop_back();
        delayedTypes()[due.type].emit(world, due.bytes.data());
    }
}

}  // namespace plumb
