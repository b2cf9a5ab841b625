#pragma once

#include <string_view>
#include <vector>

#include "app/system_order.hpp"
#include "ecs/world.hpp"
#include "reflect/type_name.hpp"
#include "reflect/type_registry.hpp"
#include "scene/effect_table.hpp"

namespace plumb {

/// Returns the name of a system: S::kName if it exists, otherwise the name of the type.
template <class S>
constexpr std::string_view systemName() {
    if constexpr (NamedSystem<S>) {
        return S::kName;
    } else {
        return shortTypeName<S>();
    }
}

/// Position of a system in the tick, relative to another system: before<PhysicsSystem>(). By default it runs
/// after the physics and all ready-made gameplay, before animation, particles, sound and camera.
struct SystemPosition {
    std::string_view before{};  ///< name of the system to run before; empty: not given
    std::string_view after{};   ///< name of the system to run after; empty: not given
};
template <class S>
constexpr SystemPosition before() {
    return {systemName<S>(), {}};
}
template <class S>
constexpr SystemPosition after() {
    return {{}, systemName<S>()};
}

/// Components and systems that the code of a project adds to those of the engine. PLUMB_MODULE fills it:
///
///     PLUMB_MODULE(module) {
///         module.components<Turret, Shell>();
///         module.system<TurretSystem, Turret>(before<PhysicsSystem>());
///         module.on<ShellHit, explode>();
///     }
class Module {
public:
    struct Resource {
        void (*describe)(TypeRegistry& types);    ///< adds the type to `types`
        void* (*make)(World& world);              ///< returns the value, created if there is none
        const void* (*find)(const World& world);  ///< null if there is none
    };
    struct System {
        SystemRow row;
        EffectRow effect;  ///< without a name: the system always runs
        SystemPosition position;
        bool isHandler = false;  ///< added by on(): its row is named EventHandler<Event, Handler>
    };

    /// Adds types with a `describe` function: scenes can contain them and the inspector edits them.
    template <Described... T>
    void components() {
        static_assert((!isInUnnamedNamespace(compilerTypeName<T>()) && ...),
                      "a component of the code must be in the global namespace or in a named one: in an "
                      "unnamed namespace it is another type whenever the code is loaded again");
        (components_.push_back([](TypeRegistry& types) { static_cast<void>(types.add<T>()); }), ...);
    }

    /// Adds types of world resources (World::resource) that have a `describe` function. They keep their
    /// values when the editor loads the code again; all other resources of the code are then removed.
    template <Described... T>
    void resources() {
        (resources_.push_back({[](TypeRegistry& types) { static_cast<void>(types.add<T>()); },
                               [](World& world) -> void* { return &world.resource<T>(); },
                               [](const World& world) -> const void* { return world.findResource<T>(); }}),
         ...);
    }

    /// Adds a system: a type with `void update(World& world, float dt)`.
    /// @tparam Required  component types: the system runs only in ticks in which an entity has one of them;
    /// none: in every tick
    template <class S, class... Required>
    void system(SystemPosition position = {}) {
        System& made = systems_.emplace_back();
        made.row = {
            systemName<S>(), {}, typeKey<S>, [](World& world) { static_cast<void>(world.addSystem<S>()); }};
        made.position = position;
        if constexpr (sizeof...(Required) != 0) {
            made.row.effect = made.effect.name = made.row.name;
            made.effect.doc = "System of the project's code.";
            made.effect.requesters = kRequestersOf<Required...>;
            made.effect.isRequired = isThereAny<Required...>;
        }
    }

    /// Calls `Handler` once for each event, in the order of emission. Its turn is at its position in the
    /// order of systems; it receives what was emitted since its last turn. So what is emitted after its turn
    /// of a tick, also by itself, it receives in the next tick.
    template <class Event, void (*Handler)(World& world, const Event& event)>
    void on(SystemPosition position = {}) {
        using Receiver = EventHandler<Event, Handler>;
        system<Receiver>(position);
        systems_.back().isHandler = true;
        systems_.back().row.add = [](World& world) {
            world.openInbox<Event>(typeKey<Receiver>());
            static_cast<void>(world.addSystem<Receiver>());
        };
    }

    [[nodiscard]] const std::vector<void (*)(TypeRegistry& types)>& componentTypes() const {
        return components_;
    }
    [[nodiscard]] const std::vector<Resource>& resourceTypes() const { return resources_; }
    [[nodiscard]] const std::vector<System>& systems() const { return systems_; }

private:
    template <class Event, void (*Handler)(World& world, const Event& event)>
    struct EventHandler {
        void update(World& world, float) const {
            world.deliver<Event>(typeKey<EventHandler>(),
                                 [&world](const Event& event) { Handler(world, event); });
        }
    };

    std::vector<void (*)(TypeRegistry& types)> components_;
    std::vector<Resource> resources_;
    std::vector<System> systems_;
};

}  // namespace plumb

#if defined(_WIN32)
#define PLUMB_EXPORTED extern "C" __declspec(dllexport)
#else
#define PLUMB_EXPORTED extern "C" __attribute__((visibility("default")))
#endif

/// Begins the function that registers the components and systems of a project's code; to be used once in the
/// project's folder `code`. A player is linked with the function, the editor looks it up by name.
#define PLUMB_MODULE(module) PLUMB_EXPORTED void plumbDescribeModule(plumb::Module& module)

PLUMB_MODULE(module);
