#include <algorithm>
#include <cstring>
#include <numeric>

#include "core/assert.hpp"
#include "ecs/storage.hpp"

namespace plumb {

namespace {

/// Entities with the same components.
struct Group {
    std::uint64_t mask = 0;
    std::uint64_t rank = 0;  ///< the mask with its bits in the order of the types' names
    std::uint32_t count = 0;
    std::uint32_t next = 0;  ///< where its next entity goes
};

/// Moves the bits of a mask into the order of the types' names: pool ordinals depend on what a program
/// happened to use first.
std::uint64_t rankOf(std::uint64_t mask, const std::vector<std::uint32_t>& rankOfOrdinal) {
    std::uint64_t rank = 0;
    for (; mask != 0; mask &= mask - 1) {
        rank |= std::uint64_t{1} << rankOfOrdinal[static_cast<std::size_t>(std::countr_zero(mask))];
    }
    return rank;
}

std::vector<std::uint32_t> ranks(std::span<const std::unique_ptr<Pool>> pools) {
    const std::size_t count = std::min<std::size_t>(pools.size(), 63);
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return pools[a]->type->nameHash != pools[b]->type->nameHash
                   ? pools[a]->type->nameHash < pools[b]->type->nameHash
                   : a < b;
    });
    std::vector<std::uint32_t> rank(64, 63);
    for (std::uint32_t i = 0; i < count; ++i) rank[order[i]] = i;
    return rank;
}

/// Sorts entity indices by (rank of their mask, index) with one counting pass.
std::vector<std::uint32_t> clusteredOrder(const Storage& storage) {
    const EntityRecord* records = storage.records();
    const std::uint32_t used = storage.usedIndices();
    std::vector<Group> groups;
    std::vector<std::uint32_t> groupOf(used + 1);
    const std::vector<std::uint32_t> rank = ranks(storage.pools());
    std::vector<std::pair<std::uint64_t, std::uint32_t>> known;  // mask -> group, sorted
    std::uint32_t last = 0;
    for (std::uint32_t index = 1; index <= used; ++index) {
        const std::uint64_t mask = records[index].mask;
        if (mask == 0) continue;
        if (groups.empty() || groups[last].mask != mask) {
            const auto at = std::lower_bound(known.begin(), known.end(), std::pair{mask, 0u});
            if (at != known.end() && at->first == mask) {
                last = at->second;
            } else {
                last = static_cast<std::uint32_t>(groups.size());
                known.insert(at, {mask, last});
                groups.push_back({mask, rankOf(mask, rank), 0, 0});
            }
        }
        groupOf[index] = last;
        ++groups[last].count;
    }
    std::vector<std::uint32_t> byRank(groups.size());
    std::iota(byRank.begin(), byRank.end(), 0u);
    // Entities with more components first: those that most queries match then start where the columns start,
    // on a line of the cache.
    std::sort(byRank.begin(), byRank.end(),
              [&](std::uint32_t a, std::uint32_t b) { return groups[a].rank > groups[b].rank; });
    std::uint32_t total = 0;
    for (const std::uint32_t group : byRank) {
        groups[group].next = total;
        total += groups[group].count;
    }
    std::vector<std::uint32_t> order(total);
    for (std::uint32_t index = 1; index <= used; ++index) {
        if (records[index].mask != 0) order[groups[groupOf[index]].next++] = index;
    }
    return order;
}

/// Puts a pool into the given order; `scratch` holds its column meanwhile. Tags have none.
void reorder(Pool& pool, const std::vector<std::uint32_t>& order, std::vector<std::byte>& scratch) {
    const std::size_t stride = pool.stride;
    scratch.resize(std::max(scratch.size(), stride * pool.count));
    std::uint32_t to = 0;
    for (const std::uint32_t index : order) {
        if (!pool.holds(index)) continue;
        Slot& slot = pool.sparse[index];
        if (stride > 0) std::memcpy(scratch.data() + stride * to, pool.at(slot.position), stride);
        slot.position = to;
        pool.dense[to++] = index;
    }
    PLUMB_ASSERT(to == pool.count, "a pool and the entity records disagree");
    if (stride > 0) std::memcpy(pool.column, scratch.data(), stride * to);
}

}  // namespace

void Storage::cluster() {
    PLUMB_ASSERT(iterating_ == 0, "cluster() moves components; call it when no query is running");
    if (iterating_ != 0) return;
    const std::vector<std::uint32_t> order = clusteredOrder(*this);
    for (const std::unique_ptr<Pool>& pool : pools_) {
        pool->disorder = 0;
        if (pool->count == 0) continue;
        reorder(*pool, order, scratch_);
        ++pool->version;
        pool->stampAll(clock_);
    }
}

bool Storage::fragmented() const {
    // A function of what was done to the world, never of which queries ran: the order of iteration is a
    // part of the simulation, and a game must run the same with and without a window.
    return std::any_of(pools_.begin(), pools_.end(), [](const std::unique_ptr<Pool>& pool) {
        return pool->count >= 256 && pool->disorder > pool->count / 4;
    });
}

}  // namespace plumb
