#include "ecs/snapshot.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/assert.hpp"
#include "ecs/storage.hpp"

namespace plumb {

void Storage::save(StorageImage& image) const {
    image.used = used_;
    image.freeCount = freeCount_;
    image.retired = retired_;
    image.clock = clock_;
    image.pools.clear();
    std::size_t bytes =
        (std::size_t{used_} + 1) * sizeof(EntityRecord) + std::size_t{freeCount_} * sizeof(std::uint32_t);
    for (const std::unique_ptr<Pool>& pool : pools_) {
        image.pools.push_back({pool->type, pool->count, pool->disorder});
        bytes += std::size_t{pool->count} * (sizeof(std::uint32_t) + pool->stride);
    }
    image.bytes.prepare(bytes);
    image.bytes.append(records_, (std::size_t{used_} + 1) * sizeof(EntityRecord));
    image.bytes.append(free_, std::size_t{freeCount_} * sizeof(std::uint32_t));
    for (const std::unique_ptr<Pool>& pool : pools_) {
        image.bytes.append(pool->dense, std::size_t{pool->count} * sizeof(std::uint32_t));
        image.bytes.append(pool->column, std::size_t{pool->count} * pool->stride);
    }
}

/// Restores the pool numbers of the time of the save, because the masks in the records depend on them.
void Storage::adoptPoolOrder(const StorageImage& image) {
    bool same = image.pools.size() <= pools_.size();
    for (std::size_t i = 0; same && i < image.pools.size(); ++i)
        same = image.pools[i].type == pools_[i]->type;
    if (same) return;
    for (const StorageImage::PoolImage& saved : image.pools) pool(saved.type->info);
    const auto savedIndexOf = [&image](const std::unique_ptr<Pool>& pool) {
        const auto at =
            std::find_if(image.pools.begin(), image.pools.end(),
                         [&](const StorageImage::PoolImage& saved) { return saved.type == pool->type; });
        return at - image.pools.begin();
    };
    std::stable_sort(pools_.begin(), pools_.end(),
                     [&](const auto& a, const auto& b) { return savedIndexOf(a) < savedIndexOf(b); });
    for (std::uint32_t i = 0; i < pools_.size(); ++i) {
        pools_[i]->ordinal = i;
        pools_[i]->bit = std::uint64_t{1} << std::min(i, 63u);
    }
    for (const std::unique_ptr<QueryCache>& cache : caches_) {
        if (cache != nullptr) cache->prepare();
    }
    findWatched();
}

void Storage::restore(const StorageImage& image) {
    adoptPoolOrder(image);
    noteAllLosses();
    const std::byte* from = image.bytes.data();
    const auto read = [&from](void* to, std::size_t bytes) {
        if (bytes > 0) std::memcpy(to, from, bytes);
        from += bytes;
    };
    if (image.used + 2 > recordCapacity_) growRecords(image.used + 2);
    const std::uint32_t before = used_;
    used_ = image.used;
    freeCount_ = image.freeCount;
    retired_ = image.retired;
    // Marks in the restored state may be those of another program, whose clock was ahead: see markChanges().
    clock_ = std::max(clock_, image.clock);
    read(records_, (std::size_t{used_} + 1) * sizeof(EntityRecord));
    read(free_, std::size_t{freeCount_} * sizeof(std::uint32_t));
    // Indices first used after the save become unused again.
    if (before > used_) {
        std::memset(static_cast<void*>(records_ + used_ + 1), 0,
                    std::size_t{before - used_} * sizeof(EntityRecord));
    }
    for (std::size_t i = 0; i < pools_.size(); ++i) {
        Pool& pool = *pools_[i];
        for (std::uint32_t k = 0; k < pool.count; ++k) pool.sparse[pool.dense[k]] = {};
        pool.version += pool.count + 1;
        pool.count = 0;
        if (pool.stride != pool.type->info.size) renew(pool, *pool.type);  // the type was changed meanwhile
        pool.count = i < image.pools.size() ? image.pools[i].count : 0;
        pool.disorder = i < image.pools.size() ? image.pools[i].disorder : 0;
        if (pool.count == 0) continue;
        pool.reserve(pool.count, used_);
        read(pool.dense, std::size_t{pool.count} * sizeof(std::uint32_t));
        read(pool.column, std::size_t{pool.count} * pool.stride);
        for (std::uint32_t k = 0; k < pool.count; ++k) {
            const std::uint32_t index = pool.dense[k];
            pool.sparse[index] = {~records_[index].generation, k};
        }
        pool.stampAll(clock_);
    }
}

}  // namespace plumb
