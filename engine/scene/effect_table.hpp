#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "ecs/system_gates.hpp"
#include "ecs/world.hpp"
#include "physics/manifest.hpp"
#include "reflect/json.hpp"

namespace plumb {

/// A kind of component that calls for an effect.
struct EffectCaller {
    const TypeInfo& (*type)();
    std::size_t (*count)(const World& world);                     ///< how many entities have one; O(1)
    bool (*calls)(const void* component) = nullptr;               ///< null: every one of them calls
    [[nodiscard]] std::size_t callers(const World& world) const;  ///< how many call; O(1) where all do
};

/// One thing that a game can do without, and what calls for it.
struct EffectRow {
    std::string_view name;  ///< as scene files write it: "particles"
    std::string_view doc;
    std::span<const EffectCaller> callers;
    /// Whether anything calls for it, from the sizes of a few pools; null for an effect of the physics, which
    /// counts its own callers.
    bool (*calledFor)(const World& world) = nullptr;
    physics::Effect physics = physics::Effect::Count;  ///< Count for none of the physics
    /// Components call for it by their defaults, so it is no mistake to pin it off where they are.
    bool byDefault = false;
    std::string_view device{};  ///< of the player, opened for it: "audio device"
};

/// A system, and the effect that it runs for.
struct EffectSystem {
    TypeKey key = 0;
    std::string_view name;    ///< S::kName
    std::string_view effect;  ///< of a row; empty for a system that always runs
};

/// All effects of a program: of the physics, of the systems, of the devices. Never changes.
class EffectTable {
public:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    EffectTable(std::vector<EffectRow> rows, std::vector<EffectSystem> systems)
        : rows_{std::move(rows)}, systems_{std::move(systems)} {}

    [[nodiscard]] const std::vector<EffectRow>& rows() const { return rows_; }
    [[nodiscard]] const std::vector<EffectSystem>& systems() const { return systems_; }
    /// The number of the row, or kNone.
    [[nodiscard]] std::size_t find(std::string_view name) const;

    /// What the "effects" of a scene file say, by row. What cannot be read is reported and counts as "auto".
    /// @param path  of the file, for errors
    [[nodiscard]] std::vector<Pin> readPins(const Json& json, std::string_view path,
                                            std::vector<Error>* problems) const;

    /// Tells of components of a scene that need what is pinned off. One error for each kind of component.
    /// @param scene  whose entities are looked at
    void checkNeeds(const World& world, SceneId scene, std::string_view path, std::span<const Pin> pins,
                    std::vector<Error>& problems) const;

private:
    [[nodiscard]] std::string allNames() const;

    std::vector<EffectRow> rows_;
    std::vector<EffectSystem> systems_;
};

/// "auto", "on" or "off".
std::string_view nameOf(Pin pin);

// For rows.

/// Of the components of a kind only those for which this holds.
template <class T, bool (*Calls)(const T& component)>
struct Some;

template <class T>
struct CallerOf {
    using Component = T;
    static constexpr bool (*kCalls)(const void*) = nullptr;
};
template <class T, bool (*Calls)(const T&)>
struct CallerOf<Some<T, Calls>> {
    using Component = T;
    static constexpr bool (*kCalls)(const void*) = [](const void* component) {
        return Calls(*static_cast<const T*>(component));
    };
};

template <class C>
constexpr EffectCaller callerOf() {
    using T = typename CallerOf<C>::Component;
    return {[]() -> const TypeInfo& { return componentType<T>().info; },
            [](const World& world) { return world.count<T>(); }, CallerOf<C>::kCalls};
}

template <class... Callers>
inline constexpr EffectCaller kCallersOf[] = {callerOf<Callers>()...};

/// Whether there is any of these components.
template <class... T>
bool isThereAny(const World& world) {
    return ((world.count<T>() != 0) || ...);
}

}  // namespace plumb
