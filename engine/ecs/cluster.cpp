#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>
#include <utility>
#include <vector>

#include "core/assert.hpp"
#include "ecs/storage.hpp"

namespace plumb {

namespace {

/// Entities with the same components.
struct Group {
    std::uint64_t mask = 0;            ///< bits of its components' pools, without the overflow bit
    std::vector<std::uint64_t> names;  ///< hashes of the type names of its components, largest first
    std::uint32_t first = 0;           ///< the lowest index of its entities
    std::uint32_t count = 0;
    std::uint32_t next = 0;  ///< position of its next entity in the order
};

/// The entities of a storage, grouped by which components they have.
class Grouping {
public:
    explicit Grouping(const Storage& storage)
        : storage_{storage}, records_{storage.records()}, groupOf_(storage.usedIndices() + 1) {
        groupByMask();
        bool parted = false;
        for (const std::unique_ptr<Pool>& pool : storage_.pools()) {
            if (pool->bit != Storage::kOverflowBit || pool->count == 0) continue;
            split(*pool);
            parted = true;
        }
        if (parted) countAgain();
        nameGroups();
    }

    /// Returns the indices of all entities with components, group by group.
    ///
    /// The order of iteration is part of the simulation, so it depends only on the state: on type names and
    /// entity indices. It must not depend on pool numbers, which follow the order of first use: a program
    /// with a window uses types in a different order than one without.
    [[nodiscard]] std::vector<std::uint32_t> order() {
        std::vector<Group*> sorted;
        sorted.reserve(groups_.size());
        for (Group& group : groups_) sorted.push_back(&group);
        std::sort(sorted.begin(), sorted.end(), [](const Group* a, const Group* b) {
            return a->names != b->names ? a->names > b->names : a->first < b->first;
        });
        std::uint32_t total = 0;
        for (Group* group : sorted) {
            group->next = total;
            total += group->count;
        }
        std::vector<std::uint32_t> order(total);
        for (std::uint32_t index = 1; index < groupOf_.size(); ++index) {
            if (records_[index].mask != 0) order[groups_[groupOf_[index]].next++] = index;
        }
        return order;
    }

private:
    void groupByMask() {
        std::vector<std::pair<std::uint64_t, std::uint32_t>> known;  // mask -> group, sorted
        std::uint32_t last = 0;
        for (std::uint32_t index = 1; index < groupOf_.size(); ++index) {
            if (records_[index].mask == 0) continue;
            // The overflow bit stays set when the last such component is removed, so it is not reliable.
            const std::uint64_t mask = records_[index].mask & ~Storage::kOverflowBit;
            if (groups_.empty() || groups_[last].mask != mask) {
                const auto at = std::lower_bound(known.begin(), known.end(), std::pair{mask, 0u});
                if (at != known.end() && at->first == mask) {
                    last = at->second;
                } else {
                    last = static_cast<std::uint32_t>(groups_.size());
                    known.insert(at, {mask, last});
                    groups_.push_back({mask, {}, index, 0, 0});
                }
            }
            groupOf_[index] = last;
            ++groups_[last].count;
        }
    }

    /// Splits groups: separates the entities that have a component of this
    /// pool, which has no bit in the masks, from those that have none.
    void split(const Pool& pool) {
        constexpr std::uint32_t kNone = ~0u;
        std::vector<std::uint32_t> partOf(groups_.size(), kNone);
        for (std::uint32_t position = 0; position < pool.count; ++position) {
            const std::uint32_t index = pool.dense[position];
            const std::uint32_t whole = groupOf_[index];
            if (partOf[whole] == kNone) {
                partOf[whole] = static_cast<std::uint32_t>(groups_.size());
                groups_.push_back({groups_[whole].mask, groups_[whole].names, 0, 0, 0});
                groups_.back().names.push_back(pool.type->nameHash);
            }
            groupOf_[index] = partOf[whole];
        }
    }

    void countAgain() {
        for (Group& group : groups_) group.count = 0;
        for (std::uint32_t index = 1; index < groupOf_.size(); ++index) {
            if (records_[index].mask == 0) continue;
            Group& group = groups_[groupOf_[index]];
            if (group.count++ == 0) group.first = index;
        }
    }

    void nameGroups() {
        for (Group& group : groups_) {
            for (std::uint64_t rest = group.mask; rest != 0; rest &= rest - 1) {
                const auto ordinal = static_cast<std::size_t>(std::countr_zero(rest));
                group.names.push_back(storage_.pools()[ordinal]->type->nameHash);
            }
            std::sort(group.names.begin(), group.names.end(), std::greater{});
        }
    }

    const Storage& storage_;
    const EntityRecord* records_;
    std::vector<Group> groups_;
    std::vector<std::uint32_t> groupOf_;  // group of each entity index
};

/// Sorts a pool into the given order; `scratch` is temporary storage for its column. Tags have none.
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
    PLUMB_ASSERT(to == pool.count, "a pool and the entity records are inconsistent");
    if (stride > 0) std::memcpy(pool.column, scratch.data(), stride * to);
}

}  // namespace

void Storage::cluster() {
    if (refusedInLoop("cluster()")) return;
    const std::vector<std::uint32_t> order = Grouping{*this}.order();
    for (const std::unique_ptr<Pool>& pool : pools_) {
        pool->disorder = 0;
        if (pool->count == 0) continue;
        reorder(*pool, order, scratch_);
        ++pool->version;
        pool->stampAll(clock_);
    }
}

bool Storage::fragmented() const {
    // Depends only on changes of the world, never on which queries ran: the order of iteration
    // is part of the simulation, and a game must run the same with and without a window.
    return std::any_of(pools_.begin(), pools_.end(), [](const std::unique_ptr<Pool>& pool) {
        return pool->count >= 256 && pool->disorder > pool->count / 4;
    });
}

}  // namespace plumb
