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

/// A component type that requests an effect: an optional feature of the engine, see EffectRow.
struct EffectRequester {
    const TypeInfo& (*type)();
    std::size_t (*count)(const World& world);           ///< number of entities that have the component; O(1)
    bool (*requests)(const void* component) = nullptr;  ///< true if this one requests it; null: all do
    [[nodiscard]] std::size_t requesters(
        const World& world) const;  ///< number of requests; O(1) if `requests` is null
};

/// An optional feature of the engine, and the components that request it. It runs only while it is requested.
struct EffectRow {
    std::string_view name;                        ///< name in scene files, e.g. "particles"
    std::string_view doc;                         ///< description, for tooltips
    std::span<const EffectRequester> requesters;  ///< component types that request it
    /// Returns true if the effect is requested, in O(1); null for
    /// effects of the physics, which counts its own requests.
    bool (*isRequired)(const World& world) = nullptr;
    physics::Effect physics = physics::Effect::Count;  ///< effect of the physics library; Count: none
    /// Components request it by their default values, so pinning it off while they exist is not reported.
    bool byDefault = false;
    std::string_view device{};  ///< device of the player that is opened for it, e.g. "audio device"
};

/// A system, and the effect for which it runs.
struct EffectSystem {
    TypeKey key = 0;
    std::string_view name;    ///< name of the system, its kName
    std::string_view effect;  ///< name of an effect; empty: the system always runs
};

/// All effects of a program: of physics, systems and devices.
class EffectTable {
public:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    EffectTable(std::vector<EffectRow> rows, std::vector<EffectSystem> systems)
        : rows_{std::move(rows)}, systems_{std::move(systems)} {}

    [[nodiscard]] const std::vector<EffectRow>& rows() const { return rows_; }
    [[nodiscard]] const std::vector<EffectSystem>& systems() const { return systems_; }
    /// Returns the index of the effect with this name, or kNone.
    [[nodiscard]] std::size_t find(std::string_view name) const;

    /// Reads the "effects" object of a scene file and returns a pin for each effect: "on" and "off" override
    /// the requests of components, "auto" does not. Invalid entries are reported and read as "auto".
    /// @param path      path of the file, for errors
    /// @param problems  receives the errors; may be null
    [[nodiscard]] std::vector<Pin> readPins(const Json& json, std::string_view path,
                                            std::vector<Error>* problems) const;

    /// Reports components of a scene that need an effect that is pinned off: one error per component type.
    /// @param path  path of the scene's file, for errors @param pins  one for each effect of the table
    void checkNeeds(const World& world, SceneId scene, std::string_view path, std::span<const Pin> pins,
                    std::vector<Error>& problems) const;

private:
    [[nodiscard]] std::string allNames() const;

    std::vector<EffectRow> rows_;
    std::vector<EffectSystem> systems_;
};

/// Returns "auto", "on" or "off".
std::string_view nameOf(Pin pin);

// Helpers to define rows.

/// Template argument of kRequestersOf that stands for those components T for which `Requests` returns true.
template <class T, bool (*Requests)(const T& component)>
struct Some;

template <class T>
struct RequesterOf {
    using Component = T;
    static constexpr bool (*kRequests)(const void*) = nullptr;
};
template <class T, bool (*Requests)(const T&)>
struct RequesterOf<Some<T, Requests>> {
    using Component = T;
    static constexpr bool (*kRequests)(const void*) = [](const void* component) {
        return Requests(*static_cast<const T*>(component));
    };
};

template <class C>
constexpr EffectRequester requesterOf() {
    using T = typename RequesterOf<C>::Component;
    return {[]() -> const TypeInfo& { return componentType<T>().info; },
            [](const World& world) { return world.count<T>(); }, RequesterOf<C>::kRequests};
}

template <class... Requesters>
inline constexpr EffectRequester kRequestersOf[] = {requesterOf<Requesters>()...};

/// True if any entity has one of these components.
template <class... T>
bool isThereAny(const World& world) {
    return ((world.count<T>() != 0) || ...);
}

}  // namespace plumb
