#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/hash.hpp"
#include "core/state_archive.hpp"
#include "reflect/entity_id.hpp"
#include "reflect/type_info.hpp"
#include "script/script_event.hpp"
#include "script/script_memory.hpp"

namespace plumb {

/// The scripts of a world, with all that they know: a world resource, so that snapshots include the Lua
/// state, the handlers that wait, and the events to handle. `ref` is a reference in the registry of the Lua
/// state.
struct ScriptState {
    /// A script of an entity.
    struct Instance {
        EntityId entity;
        int self = 0;             ///< ref of the table `self`
        bool ticking = false;     ///< its onTick waits: it is not called again before that has ended
        bool isLoaded = false;    ///< from a saved game, and its onLoad is not called yet
        std::uint32_t scene = 0;  ///< LoadedScene::loading of the entity's scene; 0: none
    };

    /// A script file that the Lua state has loaded.
    struct Loaded {
        std::uint64_t nameHash = 0;
        std::uint64_t textHash = 0;
        TypeKey type = 0;
        int table = 0;                    ///< ref of the table of functions; 0 for a file without a component
        std::uint32_t handlers = 0;       ///< bits of Handler
        std::uint64_t memberships = 0;    ///< World::memberships() when the instances were up to date
        std::vector<Instance> instances;  ///< in order of creation
        std::vector<std::uint32_t>
            byEntity;  ///< indexed by EntityId::index: 1 + index of the instance, 0 for none

        [[nodiscard]] Instance* find(EntityId entity);
        void add(Instance instance);
        /// Removes the instances of `gone`, keeping the order. @return true if any was removed
        template <class Gone>
        void removeIf(Gone gone);
    };

    /// A handler that waits.
    struct Wait {
        EntityId entity;
        TypeKey type = 0;         ///< its script
        int thread = 0;           ///< ref of its coroutine
        std::uint32_t ticks = 0;  ///< ticks left; 0: it waits for an event without end
        TextId event;             ///< name of the event that it waits for; empty: none
        bool isTick = false;      ///< it is onTick
    };

    ScriptMemory memory;
    std::uint64_t typesVersion = 0;  ///< version of the ScriptSet whose component types the Lua state knows
    std::vector<Loaded> loaded;      ///< in the order of the ScriptSet
    std::vector<Wait> waits;         ///< in the order in which they began
    std::vector<int> idle;           ///< refs of coroutines that can be used again
    /// What a saved game contains of the scripts, until the ScriptRunner has taken it: see
    /// script_archive.cpp.
    std::string saved;
    bool hasLoaded = false;  ///< false: no instance has isLoaded

    [[nodiscard]] Loaded* find(TypeKey type);
    /// Returns the ref of the `self` of an entity's script; 0 if there is none.
    [[nodiscard]] int selfOf(TypeKey type, EntityId entity);
    [[nodiscard]] bool hasInstances() const;

    /// Values of `self` are saved; what handlers wait for is not.
    void archive(StateArchive& archive);

    /// Properties of scripts are fields of components, which the world hashes; this adds what waits.
    void addTo(Hasher& hasher) const;
};

template <class Gone>
void ScriptState::Loaded::removeIf(Gone gone) {
    std::size_t kept = 0;
    for (const Instance& instance : instances) {
        byEntity[instance.entity.index] = 0;
        if (!gone(instance)) instances[kept++] = instance;
    }
    instances.resize(kept);
    for (std::size_t i = 0; i < kept; ++i)
        byEntity[instances[i].entity.index] = static_cast<std::uint32_t>(i + 1);
}

}  // namespace plumb
