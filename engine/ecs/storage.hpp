#pragma once

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

/// What is known of an entity besides its components. Generations of the living are odd.
struct EntityRecord {
    std::uint64_t mask = 0;  ///< Pool::bit of its components
    std::uint32_t generation = 0;
    std::uint32_t nextFree = 0;
};

/// The entities of a world and their components. World is the friendly face of it.
class Storage {
public:
    static constexpr std::uint32_t kMaxEntities = kAddressesAreFree ? 1u << 22 : 1u << 16;
    static constexpr std::uint64_t kOverflowBit = std::uint64_t{1} << 63;

    Storage();
    Storage(const Storage&) = delete;
    Storage& operator=(const Storage&) = delete;

    // entities

    EntityId create() {
        std::uint32_t index = freeHead_;
        if (index != 0) {
            freeHead_ = records_[index].nextFree;
        } else {
            if (used_ + 1 >= recordCapacity_) [[unlikely]]
                growRecords(used_ + 2);
            index = ++used_;
        }
        ++alive_;
        return {index, ++records_[index].generation};
    }
    /// Never used indices for all of `ids`, one after the other.
    void createFresh(std::span<EntityId> ids, std::uint64_t mask);
    [[nodiscard]] bool alive(EntityId id) const {
        return (id.generation & 1u) != 0 && id.index <= used_ &&
               records_[id.index].generation == id.generation;
    }
    /// @pre alive(id)
    void destroy(EntityId id);
    void clear();
    [[nodiscard]] std::uint32_t entityCount() const { return alive_; }
    [[nodiscard]] std::uint32_t usedIndices() const { return used_; }
    [[nodiscard]] const EntityRecord* records() const { return records_; }
    [[nodiscard]] EntityId idAt(std::uint32_t index) const { return {index, records_[index].generation}; }

    // components

    template <class T>
    Pool& pool() {
        const TypeKey key = typeKey<T>();
        if (key < byKey_.size() && byKey_[key] != nullptr) [[likely]]
            return *byKey_[key];
        return makePool(componentType<std::remove_const_t<T>>());
    }
    [[nodiscard]] Pool* findPool(TypeKey key) const { return key < byKey_.size() ? byKey_[key] : nullptr; }
    Pool& pool(const TypeInfo& info) {
        Pool* known = findPool(info.key);
        return known != nullptr ? *known : makePool(componentTypeOf(info));
    }
    [[nodiscard]] std::span<const std::unique_ptr<Pool>> pools() const { return pools_; }

    /// A position for a new component. @pre alive(id) and the pool has none of it
    std::uint32_t append(Pool& pool, EntityId id) {
        records_[id.index].mask |= pool.bit;
        ++structure_;
        return pool.append(id, clock_);
    }
    /// @pre pool.has(id)
    void erase(Pool& pool, EntityId id, std::uint32_t bytes) {
        records_[id.index].mask &= ~(pool.bit & ~kOverflowBit);
        ++structure_;
        if (iterating_ == 0) [[likely]] {
            pool.erase(id.index, bytes, clock_);
        } else {
            pool.punch(id.index);
            holes_ = true;
        }
    }
    /// Room for `count` more in a pool, behind one another, for entities with following indices.
    std::uint32_t appendRange(Pool& pool, EntityId first, std::uint32_t count);

    // iteration

    QueryCache& cache(std::uint32_t key) {
        if (key >= caches_.size()) caches_.resize(key + 1);
        if (caches_[key] == nullptr) caches_[key] = std::make_unique<QueryCache>();
        return *caches_[key];
    }
    QueryCache& beginIteration(QueryCache& wanted);
    void endIteration(QueryCache& cache) {
        --cache.users;
        if (--iterating_ == 0 && holes_) compact();
    }
    [[nodiscard]] bool iterating() const { return iterating_ != 0; }
    /// Counts every change of who has what, for loops that must notice.
    [[nodiscard]] const std::uint64_t& structure() const { return structure_; }

    // changes

    [[nodiscard]] std::uint64_t clock() const { return clock_; }
    std::uint64_t advanceClock() { return clock_++; }

    // order

    /// Sorts every pool by which components its entities have, then by index.
    void cluster();
    [[nodiscard]] bool fragmented() const;

    // copies

    void save(StorageImage& image) const;
    void restore(const StorageImage& image);

private:
    Pool& makePool(const ComponentType& type);
    void removeAll(std::uint32_t index, std::uint64_t mask);
    void growRecords(std::uint32_t count);
    void compact();
    void adoptPoolOrder(const StorageImage& image);

    EntityRecord* records_ = nullptr;
    std::uint32_t used_ = 0;      // highest index ever used
    std::uint32_t freeHead_ = 0;  // 0: none
    std::uint32_t alive_ = 0;
    std::uint32_t iterating_ = 0;
    std::uint64_t structure_ = 0;
    std::uint64_t clock_ = 1;
    bool holes_ = false;
    std::uint32_t recordCapacity_ = 0;
    std::vector<Pool*> byKey_;
    std::vector<std::unique_ptr<Pool>> pools_;  // by ordinal
    std::vector<std::unique_ptr<QueryCache>> caches_;
    std::vector<std::byte> scratch_;
    AddressRange recordMemory_;
};

}  // namespace plumb
