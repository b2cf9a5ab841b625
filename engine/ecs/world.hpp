#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/reports.hpp"
#include "core/text_store.hpp"
#include "ecs/command_buffer.hpp"
#include "ecs/entity.hpp"
#include "ecs/events.hpp"
#include "ecs/query.hpp"
#include "ecs/resources.hpp"
#include "ecs/schedule.hpp"
#include "ecs/snapshot.hpp"
#include "ecs/storage.hpp"
#include "ecs/tile_store.hpp"

namespace plumb {

class TypeRegistry;

/// The state of a game: entities with components, resources (one per type), texts, tile grids, and the
/// systems that change them. The same operations give the same world in the same order on any machine.
/// A World cannot be moved, so handles may point to it.
class World {
public:
    World();
    /// Creates a world with types that tools can find by name; the registry must outlive the world.
    explicit World(const TypeRegistry& types) : World{} { types_ = &types; }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    std::uint64_t tick = 0;  ///< fixed updates since the start; counted by beginTick

    // entities

    /// Creates an entity without components.
    Entity createEntity() { return {*this, storage_.create()}; }
    /// Creates one entity per id, each with a copy of the components; much faster than single calls.
    template <class... T>
    void createEntities(std::span<EntityId> ids, const T&... components);
    [[nodiscard]] Entity entity(EntityId id) { return {*this, id}; }
    [[nodiscard]] bool alive(EntityId id) const { return storage_.alive(id); }
    /// Destroys the entity, its components and its children. Does nothing if it does not exist.
    void destroy(EntityId id) {
        if (!storage_.alive(id)) return;
        if (storage_.watched(id)) [[unlikely]]
            leaveFamily(id);
        storage_.destroy(id);
    }
    [[nodiscard]] std::size_t entityCount() const { return storage_.entityCount(); }
    /// All living entities, including paused ones, sorted by index.
    [[nodiscard]] std::vector<EntityId> entities() const;
    /// Destroys all entities. Resources, services, systems, texts and tiles stay.
    void clear() { storage_.clear(); }

    // components

    /// nullptr if the entity does not exist or has no T. Counts as a write of T; use `const T` to read.
    /// The address, as those of get(), add() and loops, is valid until any entity loses its T (destroy(),
    /// remove(); inside a loop over a query: until the loop ends), the next beginTick(), cluster() or
    /// restore(). New entities and components do not change it.
    template <class T>
    [[nodiscard]] T* find(EntityId id);
    template <class T>
    [[nodiscard]] const T* find(EntityId id) const;
    /// @pre has<T>(id): see Entity about what happens otherwise
    template <class T>
    T& get(EntityId id);
    template <class T>
    const T& get(EntityId id) const;
    template <class T>
    [[nodiscard]] bool has(EntityId id) const;
    /// Adds a component, or replaces the existing one. @pre alive(id)
    template <class T, class... Arguments>
    T& add(EntityId id, Arguments&&... arguments);
    /// Does nothing if the entity has no T.
    template <class T>
    void remove(EntityId id);
    /// Number of entities with a T.
    template <class T>
    [[nodiscard]] std::size_t count() const;

    // The same functions for types known only at run time. The address returned for a tag is not writable.

    [[nodiscard]] void* find(const TypeInfo& type, EntityId id);
    [[nodiscard]] const void* find(const TypeInfo& type, EntityId id) const;
    [[nodiscard]] bool has(const TypeInfo& type, EntityId id) const;
    /// Adds a component with its defaults, or resets the
    /// existing one; nullptr if the entity does not exist.
    void* add(const TypeInfo& type, EntityId id);
    void remove(const TypeInfo& type, EntityId id);
    [[nodiscard]] std::size_t count(const TypeInfo& type) const;
    /// Calls `f(EntityId, const void* component)` for every entity with a component of this type.
    template <class F>
    void eachOf(const TypeInfo& type, F&& f) const;
    /// To be called after the description of a component type was changed or removed: converts its components
    /// to the new version by convertComponent(), or removes them. Older snapshots cannot be restored.
    /// @param before  the old description
    /// @param now     the new one, already passed to updateComponentType(); null: the type was removed
    void convert(const TypeInfo& before, const TypeInfo* now);
    /// Removes resources and events whose types belong to code that can be loaded again, and its components
    /// that are not in types(): their layout may be another. Frees the caches of queries, as those of code
    /// that was replaced are not used again.
    void dropReloadable();
    [[nodiscard]] const TypeRegistry* types() const { return types_; }

    // queries

    /// The entities that have all of T: see Query. Filters: `with<A>`, `without<B, C>`, `withPaused`.
    template <class... T, class... Filters>
    [[nodiscard]] Query<T...> query(Filters... filters) {
        return {*this, storage_, queryCache<T...>(storage_, filters...)};
    }
    /// Read-only: all of T must be const. Must not be called from two threads at the same time.
    template <class... T, class... Filters>
    [[nodiscard]] Query<T...> query(Filters... filters) const {
        static_assert((std::is_const_v<T> && ...), "a const World gives const components: query<const T>");
        return const_cast<World*>(this)->query<T...>(filters...);
    }
    template <class... T, class F>
    void each(F&& f) {
        query<T...>().each(std::forward<F>(f));
    }
    template <class... T, class F>
    void each(F&& f) const {
        query<T...>().each(std::forward<F>(f));
    }
    template <class... T, class F>
    void chunks(F&& f) {
        query<T...>().chunks(std::forward<F>(f));
    }
    /// The first entity that has all of T, or the empty handle.
    template <class... T>
    [[nodiscard]] Entity first() {
        return query<T...>().first();
    }

    // changes

    /// Returns a mark of the current time: later writes count as newer.
    std::uint64_t markChanges() { return storage_.advanceClock(); }
    /// True if the entity's T, or one near it in memory, may have been written since the mark.
    /// Never misses a write through find, get, add or a query that names T without const.
    template <class T>
    [[nodiscard]] bool changedSince(EntityId id, std::uint64_t mark) const;
    /// True if any T may have been written since the mark.
    template <class T>
    [[nodiscard]] bool changedSince(std::uint64_t mark) const;
    /// Calls `f(EntityId)` for every T that may have been written since
    /// the mark, paused ones too. `f` must not add or remove a T.
    template <class T, class F>
    void eachChangedSince(std::uint64_t mark, F&& f) const;
    /// Calls `f(EntityId)` for every entity that may have lost a component or been destroyed since the mark.
    /// The entity may not be alive any more.
    template <class F>
    void eachLossSince(std::uint64_t mark, F&& f) const {
        storage_.eachLossSince(mark, std::forward<F>(f));
    }
    /// The position of the entity's T in the order in which queries visit T. @pre has<T>(id)
    template <class T>
    [[nodiscard]] std::uint32_t positionOf(EntityId id) const {
        const Pool& pool = storage_.knownPool(typeKey<T>());
        return pool.has(id) ? pool.sparse[id.index].position : (missing<const T>(id), 0u);
    }
    /// Increases whenever an entity gains or loses one of these components.
    template <class... T>
    [[nodiscard]] std::uint64_t memberships() const {
        return (storage_.knownPool(typeKey<T>()).changes() + ...);
    }

    [[nodiscard]] std::uint64_t memberships(const TypeInfo& type) const {
        return storage_.knownPool(type.key).changes();
    }

    // resources and services

    /// The value of a type that exists once in the world, created with its defaults at the first use.
    template <class T>
    T& resource() {
        return resources_.get<T>();
    }
    /// The same without creating it; nullptr if there is none.
    template <class T>
    [[nodiscard]] T* findResource() const {
        return resources_.find<T>();
    }
    /// Registers an object outside the world, e.g. the AssetStore. Not in snapshots, not in the hash.
    template <class T>
    void provide(T& service) {
        provide(typeKey<T>(), const_cast<std::remove_const_t<T>*>(&service));
    }
    /// The registered object, or nullptr.
    template <class T>
    [[nodiscard]] T* service() const {
        return static_cast<T*>(findService(typeKey<T>()));
    }
    [[nodiscard]] TextStore& texts() { return texts_; }
    [[nodiscard]] const TextStore& texts() const { return texts_; }
    [[nodiscard]] TileStore& tiles() { return tiles_; }
    [[nodiscard]] const TileStore& tiles() const { return tiles_; }
    /// Removes the tile grids that no component refers to. Called by beginTick().
    void dropUnusedTiles();

    // events

    /// Emits an event, a struct: for handlers (Module::on), which receive it in their next turn, and for
    /// systems that run later in this tick and read events().
    template <class E>
    void emit(E event) {
        events_.emit(std::move(event));
    }
    /// The events emitted since the last beginTick(), in order. The span stays valid until the next one;
    /// events emitted later, e.g. by a loop over it, are in the next call's.
    template <class E>
    [[nodiscard]] std::span<const E> events() const {
        return events_.of<E>();
    }
    /// Lets a handler receive each event of a type once, until its system is removed: see Events.
    /// @param handler  key of its system, which calls deliver()
    template <class E>
    void openInbox(TypeKey handler) {
        events_.openInbox<E>(handler);
    }
    /// Calls `f(const E&)` for every event that was emitted since the handler's call before.
    /// @pre not called by `f` for the same handler
    template <class E, class F>
    void deliver(TypeKey handler, F&& f) {
        events_.deliver<E>(handler, std::forward<F>(f));
    }
    /// Removes the events that handlers have yet to receive, as when another scene begins.
    void dropWaitingEvents() { events_.dropWaiting(); }

    // systems

    /// Adds a system; if there is one of this type already, returns it unchanged.
    template <class S, class... Arguments>
    S& addSystem(Arguments&&... arguments) {
        return schedule_.add<S>(std::forward<Arguments>(arguments)...);
    }
    /// Removes the system of this type, and its inboxes; does nothing if there is none.
    void removeSystem(TypeKey system) {
        events_.closeInboxes(system);
        schedule_.remove(system);
    }
    template <class S>
    [[nodiscard]] bool hasSystem() const {
        return schedule_.find<S>() != nullptr;
    }
    template <class S>
    [[nodiscard]] S* findSystem() const {
        return schedule_.find<S>();
    }
    /// Systems named here (S::kName, or the type's name) run in this order, the others after them.
    void setSystemOrder(std::span<const std::string_view> names) { schedule_.setOrder(names); }
    [[nodiscard]] std::vector<std::string_view> systemNames() const { return schedule_.names(); }
    [[nodiscard]] CommandBuffer& commands() { return commands_; }
    /// The errors that were logged since the scene began. Not in snapshots, not in the hash.
    [[nodiscard]] Reports& reports() const { return reports_; }

    /// Starts a fixed update: counts the tick, clears events(), removes
    /// unused tile grids, and sorts the components of a small world that are out of order.
    void beginTick();
    /// Runs all systems in order; commands are applied after each.
    /// @param dt  s
    void update(float dt) { schedule_.run(*this, dt, service<Profile>()); }

    // copies

    // Not inside a loop over a query: save() and restore() do nothing there, and report an error.
    [[nodiscard]] Snapshot save() const;
    void save(Snapshot& snapshot) const;
    /// @pre the snapshot was filled by save()
    void restore(const Snapshot& snapshot);
    /// Serializes the state for a file. What is written: components by the names of their types and fields,
    /// the order of entities and components, resources (see Resources), texts, tiles, waiting events and the
    /// tick.
    /// @param problems  receives the types that cannot be saved; without any, the bytes are the whole state
    [[nodiscard]] std::string toBytes(std::vector<Error>& problems) const;
    /// Reads the state that toBytes() of this or of another version of the program wrote; restore() takes it.
    /// Types with the same fields are exact; others keep the fields that stay: convertComponent().
    /// @param problems  receives what this program does not have: types, and fields of another size
    /// @error the bytes are no state of a world; those of a stranger must have been checked before
    [[nodiscard]] Result<Snapshot> snapshotFrom(std::string_view bytes, std::vector<Error>& problems) const;
    /// Hash of the whole state: entities, components, tiles, resources with `addTo`, the number of events
    /// that handlers have yet to receive, and the tick. Depends only on the state, not on its history.
    [[nodiscard]] std::uint64_t hash() const;
    /// Sorts components by the component sets of their entities, so that every query has few, long
    /// runs. Changes the order of queries. Call it after loading; it costs 5-14 ns per component.
    void cluster() { storage_.cluster(); }

private:
    [[nodiscard]] Result<StorageImage> imageFrom(StateArchive& archive, std::vector<Error>& problems) const;

    friend class Schedule;  // calls reportMissed()

    void provide(TypeKey key, void* service);
    [[nodiscard]] void* findService(TypeKey key) const;
    /// Reports the failed calls of get() since the last call. Called before and after each system, and when
    /// a tick begins.
    void reportMissed() {
        if (missed_.slots != 0) [[unlikely]]
            reportAllMissed();
    }
    void reportAllMissed();
    /// Destroys the children of an entity and detaches it from its parent.
    void leaveFamily(EntityId id);

    /// The first failed get() of each component type: reported at once if asserts are on, else when the
    /// system has run, so that loops around get() contain no call that compilers must assume to change the
    /// world; a call made them a third slower. Of types whose keys have the same slot, the first is kept.
    struct Missed {
        static constexpr std::uint64_t kSlots = 64;

        std::uint64_t slots = 0;  ///< bits of those that are used
        std::array<std::uint64_t, kSlots> ids{};
        std::array<std::uint64_t, kSlots> keys{};
    };
    template <class T>
    T& missing(EntityId id) const;
    template <class T, class... Arguments>
    T& append(Pool& pool, EntityId id, Arguments&&... arguments);
    template <class T, class... Arguments>
    T& addSlowly(EntityId id, Arguments... arguments);

    Storage storage_;
    Resources resources_;
    TextStore texts_;
    TileStore tiles_;
    Events events_;
    CommandBuffer commands_;
    Schedule schedule_;
    std::vector<std::pair<TypeKey, void*>> services_;
    const TypeRegistry* types_ = nullptr;
    mutable Missed missed_;
    mutable Reports reports_;
};

}  // namespace plumb

#include "ecs/world_templates.hpp"
