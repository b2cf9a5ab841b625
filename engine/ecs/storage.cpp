#include "ecs/storage.hpp"

#include <algorithm>
#include <cstring>

#include "core/assert.hpp"

namespace plumb {

namespace {

constexpr std::uint32_t kFirstRecords = 1u << 14;
/// The last generation of the dead: after it an index is given up, or its names would repeat.
constexpr std::uint32_t kLastGeneration = 0xfffffffeu;

}  // namespace

Storage::Storage() : recordMemory_{kMaxEntities * (sizeof(EntityRecord) + sizeof(std::uint32_t))} {
    if (!recordMemory_.ok())
        failAssertion("the system has no addresses left for a world", __FILE__, __LINE__);
    records_ = reinterpret_cast<EntityRecord*>(recordMemory_.start());
    free_ = reinterpret_cast<std::uint32_t*>(recordMemory_.start() + kMaxEntities * sizeof(EntityRecord));
    growRecords(1);
    records_[0].generation = ~0u;  // so that the empty handle names nobody
}

void Storage::growRecords(std::uint32_t count) {
    if (count > kMaxEntities)
        failAssertion("a world is full: it holds too many entities", __FILE__, __LINE__);
    std::uint32_t capacity = std::max(recordCapacity_, kFirstRecords);
    while (capacity < count) capacity *= 4;
    recordCapacity_ = std::min(capacity, kMaxEntities);
    if (!recordMemory_.commit(0, recordCapacity_ * sizeof(EntityRecord)) ||
        !recordMemory_.commit(kMaxEntities * sizeof(EntityRecord), recordCapacity_ * sizeof(std::uint32_t))) {
        failAssertion("the memory is used up", __FILE__, __LINE__);
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
    alive_ += count;
    if (iterating_ != 0) ++structure_;
}

std::uint32_t Storage::appendRange(Pool& pool, EntityId first, std::uint32_t count) {
    pool.reserve(pool.count + count, first.index + count - 1);
    const std::uint32_t start = pool.count;
    for (std::uint32_t i = 0; i < count; ++i) {
        pool.dense[start + i] = first.index + i;
        pool.sparse[first.index + i] = {~first.generation, start + i};
    }
    pool.count += count;
    ++pool.version;
    pool.stamp(start, count, clock_);
    return start;
}

void Storage::take(Pool& pool, std::uint32_t index) {
    if (iterating_ == 0) {
        pool.erase(index, pool.stride, clock_);
    } else {
        pool.punch(index);
        holes_ = true;
    }
}

void Storage::removeAll(std::uint32_t index, std::uint64_t mask) {
    const std::unique_ptr<Pool>* const pools = pools_.data();
    for (std::uint64_t rest = mask & ~kOverflowBit; rest != 0; rest &= rest - 1) {
        Pool& pool = *pools[static_cast<std::size_t>(std::countr_zero(rest))];
        if (iterating_ == 0) {
            pool.erase(index, pool.stride, clock_);
        } else {
            take(pool, index);
        }
    }
    if ((mask & kOverflowBit) == 0) return;
    for (std::size_t i = 63; i < pools_.size(); ++i) {
        if (pools_[i]->holds(index)) take(*pools_[i], index);
    }
}

void Storage::destroy(EntityId id) {
    EntityRecord& record = records_[id.index];
    const std::uint64_t mask = record.mask;
    record.mask = 0;
    record.generation = id.generation + 1;
    if (record.generation != kLastGeneration) free_[freeCount_++] = id.index;
    --alive_;
    if (iterating_ != 0) ++structure_;
    if (mask != 0) removeAll(id.index, mask);
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
        pool->count = 0;
        pool->disorder = 0;
        ++pool->version;
    }
    bool worn = false;
    for (std::uint32_t index = 1; index <= used_; ++index) {
        EntityRecord& record = records_[index];
        record.generation += record.generation & 1u;
        record.mask = 0;
        worn |= record.generation == kLastGeneration;
    }
    // Lowest index on top, so that a cleared world gives out the same order as a new one.
    freeCount_ = 0;
    for (std::uint32_t index = used_; index > 0; --index) {
        if (!worn || records_[index].generation != kLastGeneration) free_[freeCount_++] = index;
    }
    alive_ = 0;
}

Pool& Storage::makePool(const ComponentType& type) {
    const TypeKey key = type.info.key;
    if (key >= keyTable_.size()) keyTable_.resize(key + 1, &nobody_);
    byKey_ = keyTable_.data();
    keyCount_ = static_cast<TypeKey>(keyTable_.size());
    const auto ordinal = static_cast<std::uint32_t>(pools_.size());
    pools_.push_back(std::make_unique<Pool>(type, ordinal, kMaxEntities));
    byKey_[key] = pools_.back().get();
    findWatched();
    return *pools_.back();
}

void Storage::findWatched() {
    watchedMask_ = 0;
    for (const TypeKey key : watchedKeys_) watchedMask_ |= knownPool(key).bit;
}

QueryCache& Storage::beginIteration(QueryCache& wanted) {
    QueryCache* cache = &wanted;
    if (cache->stale()) [[unlikely]] {
        while (cache->users != 0 && cache->stale()) cache = &cache->spare();
        for (Pool* pool : cache->included) {
            if (pool->indexCapacity <= used_) pool->reserve(0, used_);
        }
        if (cache->stale()) cache->rebuild(records_);
    }
    ++cache->users;
    ++iterating_;
    return *cache;
}

void Storage::compact() {
    holes_ = false;
    for (const std::unique_ptr<Pool>& pool : pools_) {
        pool->compact(clock_);
    }
}

}  // namespace plumb
