#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ecs/address_range.hpp"
#include "ecs/pool.hpp"
#include "ecs/query_cache.hpp"
#include "reflect/entity_id.hpp"

namespace plumb {

struct StorageImage;

/// The entities of a world and their components. World is its public interface.
class Storage {
public:
    static constexpr std::uint64_t kOverflowBit = std::uint64_t{1} << 63;

    Storage();
    Storage(const Storage&) = delete;
    Storage& operator=(const Storage&) = delete;

    // entities

    EntityId create() {
        std::uint32_t index = 0;
        if (freeCount_ != 0) {
            index = free_[--freeCount_];
        } else {
            if (used_ + 1 >= recordCapacity_) growRecords(used_ + 2);
            index = ++used_;
        }
        return {index, ++records_[index].generation};
    }
    /// Creates an entity for each of `ids`, with consecutive indices that were never used before.
    void createFresh(std::span<EntityId> ids, std::uint64_t mask);
    [[nodiscard]] bool alive(EntityId id) const { return id.index <= used_ && isCurrent(id); }
    /// @pre alive(id)
    void destroy(EntityId id);
    void clear();
    [[nodiscard]] std::uint32_t entityCount() const { return used_ - freeCount_ - retired_; }
    [[nodiscard]] std::uint32_t usedIndices() const { return used_; }
    [[nodiscard]] std::uint32_t maxEntities() const { return maxEntities_; }
    [[nodiscard]] const EntityRecord* records() const { return records_; }
    /// True if the entity has a component of a type that was passed to watch().
    [[nodiscard]] bool watched(EntityId id) const { return (records_[id.index].mask & watchedMask_) != 0; }
    /// Marks a type: the caller of destroy() must handle entities with such a component specially.
    void watch(TypeKey key) { watchedKeys_.push_back(key); }
    /// True if the entity at a used index is alive. @pre 0 < index <= usedIndices()
    [[nodiscard]] bool livesAt(std::uint32_t index) const { return (records_[index].generation & 1u) != 0; }
    [[nodiscard]] EntityId idAt(std::uint32_t index) const { return {index, records_[index].generation}; }

    // components

    template <class T>
    Pool& pool() {
        const TypeKey key = typeKey<T>();
        if (byKey_[key] != &emptyPool_) return *byKey_[key];
        return makePool(componentType<std::remove_const_t<T>>());
    }
    /// The pool of a type, or an empty one without capacity if there is none.
    [[nodiscard]] const Pool& knownPool(TypeKey key) const { return *byKey_[key]; }
    [[nodiscard]] Pool& knownPool(TypeKey key) { return *byKey_[key]; }
    [[nodiscard]] Pool* findPool(TypeKey key) const {
        return byKey_[key] != &emptyPool_ ? byKey_[key] : nullptr;
    }
    Pool& pool(const TypeInfo& info) {
        Pool* known = findPool(info.key);
        return known != nullptr ? *known : makePool(componentTypeOf(info));
    }
    /// Gives an empty pool the new layout of its components, after their description was changed.
    /// @pre no component is left in it, and no loop runs
    void renew(Pool& pool, const ComponentType& type);
    /// After the type of an empty pool was removed: the type is registered anew when it is used again, maybe
    /// with another layout. @pre as for renew()
    void forget(Pool& pool);
    /// Frees the cached results of all queries. @pre no loop runs
    void dropCaches();
    [[nodiscard]] std::span<const std::unique_ptr<Pool>> pools() const { return pools_; }

    /// True if append() may be called: the entity is alive, has no such component, and there is room.
    [[nodiscard]] bool canAppend(const Pool& pool, EntityId id) const {
        // Records are committed in the same steps as the sparse arrays, so one check covers both.
        return pool.count != pool.capacity && id.index < pool.indexCapacity && isCurrent(id) &&
               pool.sparse[id.index].check == 0;
    }
    /// Appends a position for a new component and returns it. @pre canAppend(pool, id)
    [[gnu::always_inline]] std::uint32_t append(Pool& pool, EntityId id) {
        records_[id.index].mask |= pool.bit;
        if (iterating_ != 0) [[unlikely]]
            ++structure_;
        return pool.append(id, clock_);
    }
    /// @pre pool.has(id)
    [[gnu::always_inline]] void erase(Pool& pool, EntityId id, std::uint32_t bytes) {
        records_[id.index].mask &= ~(pool.bit & ~kOverflowBit);
        noteLoss(id.index);
        if (iterating_ == 0) [[likely]] {
            pool.erase(id.index, bytes, clock_);
        } else {
            ++structure_;
            pool.punch(id.index);
            holes_ = true;
        }
    }
    /// Appends `count` consecutive positions to a pool, for entities with consecutive indices.
    std::uint32_t appendRange(Pool& pool, EntityId first, std::uint32_t count);

    // iteration

    QueryCache& cache(std::uint32_t key) {
        if (key >= caches_.size()) caches_.resize(key + 1);
        if (caches_[key] == nullptr) caches_[key] = std::make_unique<QueryCache>();
        return *caches_[key];
    }
    QueryCache& beginIteration(QueryCache& wanted) {
        QueryCache& cache = wanted.stale() ? renewed(wanted) : wanted;
        ++cache.users;
        ++iterating_;
        return cache;
    }
    void endIteration(QueryCache& cache) {
        --cache.users;
        if (--iterating_ == 0 && holes_) compact();
    }
    [[nodiscard]] bool iterating() const { return iterating_ != 0; }
    /// True inside a loop over a query, where a function that moves or copies all components must not run:
    /// reports that as an error. @param function  "save()"
    [[nodiscard]] bool refusedInLoop(const char* function) const;
    /// Number of components added or removed during iteration, for loops that must detect such changes.
    [[nodiscard]] const std::uint64_t& structure() const { return structure_; }

    // changes

    [[nodiscard]] std::uint64_t clock() const { return clock_; }
    /// Calls `f(EntityId)` for all indices of blocks in which an entity lost a component since the mark.
    template <class F>
    void eachLossSince(std::uint64_t mark, F&& f) const {
        for (std::uint32_t first = 0; first <= used_; first += 1u << kStampShift) {
            if (losses_[first >> kStampShift] <= mark) continue;
            const std::uint32_t end = std::min(used_ + 1, first + (1u << kStampShift));
            for (std::uint32_t index = std::max(first, 1u); index < end; ++index) f(idAt(index));
        }
    }
    std::uint64_t advanceClock() { return clock_++; }

    // order

    /// Sorts every pool by the component sets of its entities, then by index.
    void cluster();
    [[nodiscard]] bool fragmented() const;

    // copies

    void save(StorageImage& image) const;
    void restore(const StorageImage& image);

private:
    /// @pre the record of id.index exists
    [[nodiscard]] bool isCurrent(EntityId id) const {
        // The generations of living entities are odd; those of destroyed and of future ones even, and may
        // equal that of an id which no entity ever had.
        return records_[id.index].generation == id.generation && (id.generation & 1u) != 0;
    }
    Pool& makePool(const ComponentType& type);
    QueryCache& renewed(QueryCache& wanted);
    bool endAllLives();
    void removeCarefully(std::uint32_t index, std::uint64_t mask);
    void growRecords(std::uint32_t count);
    void noteLoss(std::uint32_t index) { losses_[index >> kStampShift] = clock_; }
    void noteAllLosses() { std::fill(losses_.begin(), losses_.end(), clock_); }
    void compact();
    void adoptPoolOrder(const StorageImage& image);
    void findWatched();

    EntityRecord* records_ = nullptr;
    std::uint32_t used_ = 0;         // highest index used so far
    std::uint32_t* free_ = nullptr;  // a stack of indices to reuse
    std::uint32_t freeCount_ = 0;
    std::uint32_t retired_ = 0;    // indices whose generations are used up
    std::uint32_t iterating_ = 0;  // number of loops that run now
    std::uint64_t structure_ = 0;  // see structure()
    std::uint64_t clock_ = 1;
    bool holes_ = false;  // some pools have holes
    std::uint32_t recordCapacity_ = 0;
    std::vector<std::uint64_t> losses_;  // per block of indices: clock of the last loss of a component
    std::uint64_t watchedMask_ = 0;
    Pool emptyPool_;
    std::vector<Pool*> byKey_;  // &emptyPool_ for types without a pool
    std::vector<TypeKey> watchedKeys_;
    std::vector<std::unique_ptr<Pool>> pools_;  // indexed by Pool::ordinal
    std::vector<std::unique_ptr<QueryCache>> caches_;
    std::vector<std::byte> scratch_;
    std::uint32_t maxEntities_;  // number for which all arrays have reserved address space
    AddressRange recordMemory_;
};

}  // namespace plumb
