#include "ecs/storage.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include "core/assert.hpp"
#include "core/log.hpp"
#include "core/os.hpp"

namespace plumb {

namespace {

constexpr std::uint32_t kFirstRecords = 1u << 14;
/// The last generation of an index: then the index is not used again, because its ids would repeat.
constexpr std::uint32_t kLastGeneration = 0xfffffffeu;

/// The number of entities for which a world reserves address space. If the address space of the process
/// is limited, all pools together take about a quarter of it, assuming 64 types with 64 bytes per entity.
/// Where reserving takes memory, at once, that is the least.
std::uint32_t roomOfWorld() {
    constexpr std::size_t kBytes = std::size_t{64} * 64;
    if (!os::reservingIsFree()) return kFirstRecords;
    return static_cast<std::uint32_t>(std::clamp<std::size_t>(std::bit_floor(os::addressLimit() / 4 / kBytes),
                                                              kFirstRecords, std::size_t{1} << 22));
}

}  // namespace

Storage::Storage()
    : byKey_(kMaxTypes, &emptyPool_),
      maxEntities_{roomOfWorld()},
      recordMemory_{maxEntities_ * (sizeof(EntityRecord) + sizeof(std::uint32_t))} {
    if (!recordMemory_.ok()) failAssertion("not enough address space for a world", __FILE__, __LINE__);
    records_ = reinterpret_cast<EntityRecord*>(recordMemory_.start());
    free_ = reinterpret_cast<std::uint32_t*>(recordMemory_.start() + maxEntities_ * sizeof(EntityRecord));
    growRecords(1);  // the generation of index 0 stays 0, so that the empty handle matches no entity
}

void Storage::growRecords(std::uint32_t count) {
    if (count > maxEntities_)
        failAssertion("too many entities: the address space of the world is used up", __FILE__, __LINE__);
    std::uint32_t capacity = std::max(recordCapacity_, kFirstRecords);
    while (capacity < count) capacity *= 4;
    recordCapacity_ = std::min(capacity, maxEntities_);
    losses_.resize((recordCapacity_ >> kStampShift) + 1);
    if (!recordMemory_.commit(0, recordCapacity_ * sizeof(EntityRecord)) ||
        !recordMemory_.commit(maxEntities_ * sizeof(EntityRecord), recordCapacity_ * sizeof(std::uint32_t))) {
        failAssertion("out of memory", __FILE__, __LINE__);
    }
}

void Storage::createFresh(std::span<EntityId> ids, std::uint64_t mask) {
    const auto count = static_cast<std::uint32_t>(ids.size());
    if (used_ + count + 1 > recordCapacity_) growRecords(used_ + count + 1);
    EntityRecord* records = records_ + used_ + 1;
    for (std::uint32_t i = 0; i < count; ++i) {
        records[i].mask = mask;
        records[i].generation = 1;  // an index never used before
        ids[i] = {used_ + 1 + i, 1};
    }
    used_ += count;
}

std::uint32_t Storage::appendRange(Pool& pool, EntityId first, std::uint32_t count) {
    pool.reserve(pool.count + count, first.index + count - 1);
    const std::uint32_t start = pool.count;
    for (std::uint32_t i = 0; i < count; ++i) {
        pool.dense[start + i] = first.index + i;
        pool.sparse[first.index + i] = {~first.generation, start + i};
    }
    pool.count += count;
    pool.stamp(start, count, clock_);
    return start;
}

/// Removes all components of an entity during iteration, or from more pools than a mask has bits for.
void Storage::removeCarefully(std::uint32_t index, std::uint64_t mask) {
    const auto take = [&](Pool& pool) {
        if (iterating_ == 0) {
            pool.erase(index, pool.stride, clock_);
        } else {
            pool.punch(index);
            holes_ = true;
        }
    };
    if (iterating_ != 0) ++structure_;
    for (std::uint64_t rest = mask & ~kOverflowBit; rest != 0; rest &= rest - 1)
        take(*pools_[static_cast<std::size_t>(std::countr_zero(rest))]);
    if ((mask & kOverflowBit) == 0) return;
    for (std::size_t i = 63; i < pools_.size(); ++i) {
        if (pools_[i]->holds(index)) take(*pools_[i]);
    }
}

void Storage::destroy(EntityId id) {
    EntityRecord& record = records_[id.index];
    const std::uint64_t mask = record.mask;
    noteLoss(id.index);
    record.mask = 0;
    record.generation = id.generation + 1;
    if (record.generation != kLastGeneration) [[likely]] {
        free_[freeCount_++] = id.index;
    } else {
        ++retired_;
    }
    if (iterating_ != 0 || (mask & kOverflowBit) != 0) [[unlikely]]
        return removeCarefully(id.index, mask);
    const std::unique_ptr<Pool>* const pools = pools_.data();
    const std::uint64_t clock = clock_;
    for (std::uint64_t rest = mask; rest != 0; rest &= rest - 1) {
        Pool& pool = *pools[static_cast<std::size_t>(std::countr_zero(rest))];
        pool.erase(id.index, pool.stride, clock);
    }
}

void Storage::clear() {
    if (iterating_ != 0) {
        for (std::uint32_t index = 1; index <= used_; ++index) {
            if (livesAt(index)) destroy(idAt(index));
        }
        return;
    }
    for (const std::unique_ptr<Pool>& pool : pools_) {
        if (pool->count == 0) continue;
        const std::uint32_t reached = std::min(used_ + 1, pool->indexCapacity);
        if (pool->count > reached / 8) {
            std::memset(static_cast<void*>(pool->sparse), 0, reached * sizeof(Slot));
        } else {
            for (std::uint32_t i = 0; i < pool->count; ++i) pool->sparse[pool->dense[i]] = {};
        }
        pool->version += pool->count + 1;
        pool->count = 0;
        pool->disorder = 0;
    }
    noteAllLosses();
    const bool mayBeWorn = endAllLives();
    // Lowest index on top, so that a cleared world assigns indices in the same order as a new one.
    freeCount_ = used_;
    for (std::uint32_t i = 0; i < used_; ++i) free_[i] = used_ - i;
    if (mayBeWorn) {
        const auto worn = [this](std::uint32_t i) { return records_[i].generation == kLastGeneration; };
        freeCount_ = static_cast<std::uint32_t>(std::remove_if(free_, free_ + used_, worn) - free_);
    }
    retired_ = used_ - freeCount_;
}

/// Ends all entities. @return true if some generations are so high that they need a check
bool Storage::endAllLives() {
    EntityRecord* const records = records_;
    const std::uint32_t used = used_;
    std::uint32_t bits = 0;
    for (std::uint32_t index = 1; index <= used; ++index) {
        const std::uint32_t generation = (records[index].generation + 1) & ~1u;
        records[index] = {0, generation};
        bits |= generation;
    }
    return bits >> 31 != 0;
}

bool Storage::refusedInLoop(const char* function) const {
    if (iterating_ == 0) return false;
    const Error error{"World", format("{} was called inside a loop over a query; nothing was done", function),
                      "call it after the loop"};
    PLUMB_ASSERT(false, error.text().c_str());
    logError("World", error);
    return true;
}

Pool& Storage::makePool(const ComponentType& type) {
    const auto forgotten = std::find_if(
        pools_.begin(), pools_.end(), [&](const std::unique_ptr<Pool>& pool) { return pool->type == &type; });
    Pool* pool = forgotten == pools_.end() ? nullptr : forgotten->get();
    if (pool != nullptr) {
        renew(*pool, type);
    } else {
        const auto ordinal = static_cast<std::uint32_t>(pools_.size());
        pool = pools_.emplace_back(std::make_unique<Pool>(type, ordinal, maxEntities_)).get();
    }
    byKey_[type.info.key] = pool;
    findWatched();
    return *pool;
}

void Storage::renew(Pool& pool, const ComponentType& type) {
    PLUMB_ASSERT(pool.count == 0 && iterating_ == 0, "only an empty pool can change its layout");
    Pool renewed{type, pool.ordinal, maxEntities_};
    renewed.version = pool.version + 1;  // caches of queries are stale
    pool = std::move(renewed);
}

void Storage::forget(Pool& pool) {
    PLUMB_ASSERT(pool.count == 0 && iterating_ == 0, "only an empty pool can be forgotten");
    byKey_[pool.type->info.key] = &emptyPool_;  // it stays in pools_, for makePool() and for snapshots
    findWatched();
}

void Storage::dropCaches() {
    for (std::unique_ptr<QueryCache>& cache : caches_) cache.reset();
}

void Storage::findWatched() {
    watchedMask_ = 0;
    for (const TypeKey key : watchedKeys_) watchedMask_ |= knownPool(key).bit;
}

/// An up-to-date cache of the same query: this one, unless a loop currently reads its runs.
QueryCache& Storage::renewed(QueryCache& wanted) {
    QueryCache* cache = &wanted;
    while (cache->users != 0 && cache->stale()) cache = &cache->spare();
    for (Pool* pool : cache->included) {
        if (pool->indexCapacity <= used_) pool->reserve(0, used_);
    }
    if (cache->stale()) cache->rebuild(records_);
    return *cache;
}

void Storage::compact() {
    holes_ = false;
    for (const std::unique_ptr<Pool>& pool : pools_) {
        pool->compact(clock_);
    }
}

}  // namespace plumb
