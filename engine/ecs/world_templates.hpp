#pragma once

// The bodies of the templates of World, Entity and CommandBuffer. Include ecs/world.hpp.

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

#include "core/assert.hpp"
#include "ecs/world.hpp"

namespace plumb {

/// Constructs a T in place, from (World&, arguments...) if it has such a constructor.
template <class T, class... Arguments>
T* constructComponent(void* memory, World& world, Arguments&&... arguments) {
    T* const place = static_cast<T*>(memory);
    if constexpr (std::is_constructible_v<T, World&, Arguments...>) {
        return std::construct_at(place, world, std::forward<Arguments>(arguments)...);
    } else if constexpr (std::is_constructible_v<T, Arguments...>) {
        return std::construct_at(place, std::forward<Arguments>(arguments)...);
    } else {
        return ::new (memory) T{std::forward<Arguments>(arguments)...};  // an aggregate
    }
}

/// Reports that a component was requested which an entity does not have, with the running system and the
/// remedy; each system and component once until Reports::forget().
/// @param world  the entity's; nullptr for an empty handle
void reportMissing(const World* world, EntityId id, TypeKey type);
/// Stops the program, as an empty handle belongs to no world.
[[noreturn]] void failWithoutWorld();

/// The zeroed component that get() returns if the component is missing; it belongs to no entity.
template <class T>
struct Blank {
    alignas(T) inline static std::byte bytes[sizeof(T)] = {};
};

template <class T>
T& blank() {
    std::byte* const bytes = Blank<std::remove_const_t<T>>::bytes;
    std::fill_n(bytes, sizeof(T), std::byte{});  // what was written to it is lost
    return *reinterpret_cast<T*>(bytes);
}

template <class T>
T& World::missing(EntityId id) const {
    if constexpr (kAssertions) {
        reportMissing(this, id, typeKey<T>());
    } else {
        const std::uint64_t key = typeKey<T>();
        const std::uint64_t slot = key % Missed::kSlots;
        if ((missed_.slots >> slot & 1) == 0) {
            missed_.slots |= std::uint64_t{1} << slot;
            missed_.ids[slot] = std::uint64_t{id.generation} << 32 | id.index;
            missed_.keys[slot] = key;
        }
    }
    return blank<T>();
}

/// What the functions of an empty handle return that must return a component.
template <class T>
[[gnu::noinline]] T& missingWithoutWorld() {
    reportMissing(nullptr, {}, typeKey<T>());
    return blank<T>();
}

/// The type of an argument of the rare path: small plain types by value, because a reference
/// would keep the caller's variable in memory instead of a register on the common path, too.
template <class Argument, class Value = std::remove_cvref_t<Argument>>
using PassedOn = std::conditional_t<(std::is_scalar_v<Value> ||
                                     std::is_class_v<Value>)&&std::is_trivially_copyable_v<Value> &&
                                        sizeof(Value) <= 16,
                                    Value, Argument&&>;

template <class T, class... Arguments>
[[gnu::always_inline]] inline T& World::add(EntityId id, Arguments&&... arguments) {
    static_assert(!std::is_const_v<T>);
    Pool& pool = storage_.knownPool(typeKey<T>());
    if (!storage_.canAppend(pool, id)) [[unlikely]]
        return addSlowly<T, PassedOn<Arguments>...>(id, std::forward<Arguments>(arguments)...);
    return append<T>(pool, id, std::forward<Arguments>(arguments)...);
}

template <class T, class... Arguments>
[[gnu::always_inline]] inline T& World::append(Pool& pool, EntityId id, Arguments&&... arguments) {
    if constexpr (kIsTag<T>) {
        storage_.append(pool, id);
        return kTagInstance<T>;
    } else {
        // A constructor that takes the World may add entities, even this component; so append first.
        T* const place = reinterpret_cast<T*>(pool.column) + storage_.append(pool, id);
        return *constructComponent<T>(place, *this, std::forward<Arguments>(arguments)...);
    }
}

/// The rare cases: the first T of a world, no capacity, a replacement, or a destroyed entity.
template <class T, class... Arguments>
[[gnu::noinline]] T& World::addSlowly(EntityId id, Arguments... arguments) {
    Pool& pool = storage_.pool<T>();
    if (!storage_.alive(id)) return missing<T>(id);
    if (!pool.has(id)) {
        pool.makeRoom(id.index);
        return append<T>(pool, id, std::forward<Arguments>(arguments)...);
    }
    if constexpr (kIsTag<T>) {
        return kTagInstance<T>;
    } else {
        // Constructed in a temporary first: the arguments may refer to the component that is replaced.
        alignas(T) std::byte made[sizeof(T)] = {};
        constructComponent<T>(made, *this, std::forward<Arguments>(arguments)...);
        T* const there = find<T>(id);
        std::memcpy(static_cast<void*>(there), made, sizeof(T));
        return *there;
    }
}

template <class... T>
void World::createEntities(std::span<EntityId> ids, const T&... components) {
    static_assert(kAreDistinct<T...>, "an entity has at most one component of a type");
    if (ids.empty()) return;
    storage_.createFresh(ids, (std::uint64_t{0} | ... | storage_.pool<T>().bit));
    const auto fill = [&]<class C>(const C& component) {
        Pool& pool = storage_.pool<C>();
        const std::uint32_t start =
            storage_.appendRange(pool, ids[0], static_cast<std::uint32_t>(ids.size()));
        if constexpr (!kIsTag<C>) {
            const C value = component;  // a copy, because `component` may be in the column
            C* const column = reinterpret_cast<C*>(pool.column) + start;
            for (std::size_t i = 0; i < ids.size(); ++i) std::construct_at(column + i, value);
        }
    };
    (fill(components), ...);
}

template <class T>
T* World::find(EntityId id) {
    const Pool& pool = storage_.knownPool(typeKey<T>());
    if (!pool.has(id)) return nullptr;
    if constexpr (kIsTag<T>) {
        return &kTagInstance<T>;
    } else {
        const std::uint32_t position = pool.sparse[id.index].position;
        if constexpr (!std::is_const_v<T>) pool.stamps[position >> kStampShift] = storage_.clock();
        return reinterpret_cast<T*>(pool.column) + position;
    }
}

template <class T>
const T* World::find(EntityId id) const {
    return const_cast<World*>(this)->find<const T>(id);
}

template <class T>
T& World::get(EntityId id) {
    if constexpr (kIsTag<T>) {
        T* const found = find<T>(id);
        return found != nullptr ? *found : missing<T>(id);
    } else {
        // Everything that is constant between calls is read before
        // any branch, so that loops around get() load it only once.
        const Pool& pool = storage_.knownPool(typeKey<T>());
        T* const column = reinterpret_cast<T*>(pool.column);
        std::uint64_t* const stamps = pool.stamps;
        if (!pool.has(id)) [[unlikely]]
            return missing<T>(id);
        const std::uint32_t position = pool.sparse[id.index].position;
        if constexpr (!std::is_const_v<T>) stamps[position >> kStampShift] = storage_.clock();
        return column[position];
    }
}

template <class T>
const T& World::get(EntityId id) const {
    return const_cast<World*>(this)->get<const T>(id);
}

template <class T>
bool World::has(EntityId id) const {
    return storage_.knownPool(typeKey<T>()).has(id);
}

template <class T>
void World::remove(EntityId id) {
    Pool* const pool = storage_.findPool(typeKey<T>());
    if (pool != nullptr && pool->has(id)) storage_.erase(*pool, id, kIsTag<T> ? 0 : sizeof(T));
}

template <class T>
std::size_t World::count() const {
    return storage_.knownPool(typeKey<T>()).size();
}

template <class T>
bool World::changedSince(EntityId id, std::uint64_t mark) const {
    const Pool* const pool = storage_.findPool(typeKey<T>());
    return pool != nullptr && pool->has(id) &&
           pool->stamps[pool->sparse[id.index].position >> kStampShift] > mark;
}

template <class F>
void World::eachOf(const TypeInfo& type, F&& f) const {
    const Pool* const pool = storage_.findPool(type.key);
    if (pool == nullptr) return;
    for (std::uint32_t position = 0; position < pool->count; ++position) {
        const std::uint32_t index = pool->dense[position];
        if (index != 0) f(storage_.idAt(index), static_cast<const void*>(pool->at(position)));
    }
}

template <class T>
bool World::changedSince(std::uint64_t mark) const {
    return storage_.knownPool(typeKey<T>()).writtenSince(mark);
}

template <class T, class F>
void World::eachChangedSince(std::uint64_t mark, F&& f) const {
    const Pool& pool = storage_.knownPool(typeKey<T>());
    for (std::uint32_t first = 0; first < pool.count; first += 1u << kStampShift) {
        if (pool.stamps[first >> kStampShift] <= mark) continue;
        const std::uint32_t end = std::min(pool.count, first + (1u << kStampShift));
        for (std::uint32_t i = first; i < end; ++i) {
            if (pool.dense[i] != 0) f(storage_.idAt(pool.dense[i]));
        }
    }
}

template <class T, class... Arguments>
[[gnu::always_inline]] inline T& Entity::addComponent(Arguments&&... arguments) const {
    if (world_ == nullptr) [[unlikely]]
        return missingWithoutWorld<T>();
    return world_->add<T>(id_, std::forward<Arguments>(arguments)...);
}

template <class T>
void Entity::removeComponent() const {
    if (world_ != nullptr) world_->remove<T>(id_);
}

template <class T>
bool Entity::hasComponent() const {
    return world_ != nullptr && world_->has<T>(id_);
}

template <class T>
T& Entity::get() const {
    if (world_ == nullptr) [[unlikely]]
        return missingWithoutWorld<T>();
    return world_->get<T>(id_);
}

template <class T>
T* Entity::find() const {
    return world_ != nullptr ? world_->find<T>(id_) : nullptr;
}

inline void Entity::destroy() const {
    if (world_ != nullptr) world_->destroy(id_);
}

inline World& Entity::world() const {
    if (world_ == nullptr) [[unlikely]]
        failWithoutWorld();
    return *world_;
}

inline bool Entity::alive() const { return world_ != nullptr && world_->alive(id_); }

template <class T>
void CommandBuffer::add(EntityId id, const T& component) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::size_t at = payload_.size();
    payload_.resize(at + sizeof(T));
    std::memcpy(payload_.data() + at, &component, sizeof(T));
    const auto apply = [](World& world, EntityId to, const std::byte* payload) {
        alignas(T) std::byte copy[sizeof(T)];
        std::memcpy(copy, payload, sizeof(T));
        world.add<T>(to, *std::launder(reinterpret_cast<const T*>(copy)));
    };
    commands_.push_back({id, apply, at});
}

template <class T>
void CommandBuffer::remove(EntityId id) {
    commands_.push_back(
        {id, [](World& world, EntityId from, const std::byte*) { world.remove<T>(from); }, 0});
}

}  // namespace plumb
