#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "ecs/pool.hpp"

namespace plumb {

/// Data of an entity besides its components. Generations of living entities are odd.
struct EntityRecord {
    std::uint64_t mask = 0;  ///< Pool::bit of its components
    std::uint32_t generation = 0;
};

/// The cached result of a query: runs of entities that are consecutive in all of its
/// columns, so that the inner loop is a plain one. Valid while no pool of the query changes.
struct QueryCache {
    std::vector<Pool*> included;  ///< the pools of the columns first, then pools that are only required
    std::vector<Pool*> excluded;
    std::uint32_t columns = 0;  ///< number of pools in `included` that are columns
    bool prepared = false;      ///< the pools above have been filled in

    /// Per run: the first position in each column, then the length. If
    /// `indexed`, every run is a single entity and the length is omitted.
    std::vector<std::uint32_t> runs;
    bool indexed = false;
    std::uint32_t total = 0;  ///< number of entities
    std::uint32_t users = 0;  ///< loops that currently read `runs`

    [[nodiscard]] std::uint32_t step() const { return indexed ? columns : columns + 1; }
    [[nodiscard]] bool stale() const { return version_ != poolChanges(); }
    void rebuild(const EntityRecord* records);

    /// True if the entity at this index currently matches the query.
    [[nodiscard]] bool matches(const EntityRecord* records, std::uint32_t index) const {
        return masked_ ? ((records[index].mask ^ need_) & care_) == 0 : holdsAll(index);
    }
    /// True if the entity that was at a position of a run when the loop began is still there and matches.
    [[nodiscard]] bool stillThere(const EntityRecord* records, const std::uint32_t* run,
                                  std::uint32_t i) const {
        const std::uint32_t index = included[0]->dense[run[0] + i];
        if (index == 0) return false;
        for (std::uint32_t k = 1; k < columns; ++k) {
            if (included[k]->dense[run[k] + i] != index) return false;
        }
        return matches(records, index);
    }

    /// Returns another cache of the same query, for a nested loop after the world changed.
    QueryCache& spare();
    /// Computes the masks, once the pools are known or were renumbered.
    void prepare();

private:
    [[nodiscard]] bool holdsAll(std::uint32_t index) const {
        for (const Pool* pool : included) {
            if (!pool->holds(index)) return false;
        }
        for (const Pool* pool : excluded) {
            if (pool->holds(index)) return false;
        }
        return true;
    }
    [[nodiscard]] std::uint64_t poolChanges() const {
        // Each summand only grows, so equal sums mean that none of them changed.
        std::uint64_t sum = 0;
        for (const Pool* pool : included) sum += pool->changes();
        for (const Pool* pool : excluded) sum += pool->changes();
        return sum;
    }
    [[nodiscard]] bool anyHoles() const;
    void buildRuns(const EntityRecord* records, const Pool& lead);
    template <std::uint32_t N>
    bool buildIndex(const EntityRecord* records, const Pool& lead);
    void expandRuns();

    bool masked_ = false;        // the masks are sufficient: no pool of the query is beyond the 63rd
    std::uint64_t need_ = 0;     // bits of the required pools
    std::uint64_t care_ = 0;     // bits of the required and the excluded pools
    std::uint64_t version_ = 0;  // poolChanges() when `runs` was computed
    std::unique_ptr<QueryCache> spare_;
    std::vector<std::uint32_t> scratch_;
};

}  // namespace plumb
