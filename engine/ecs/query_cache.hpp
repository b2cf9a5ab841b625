#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace plumb {

struct Pool;

/// What is known of an entity besides its components. Generations of the living are odd.
struct EntityRecord {
    std::uint64_t mask = 0;  ///< Pool::bit of its components
    std::uint32_t generation = 0;
};

/// The remembered answer of a query: runs of entities that follow one another in all of its columns, so
/// that the inner loop is a plain one. Valid as long as no pool of the query changes its version.
struct QueryCache {
    std::vector<Pool*> included;  ///< the named columns first, then those that must merely be there
    std::vector<Pool*> excluded;
    std::uint32_t columns = 0;  ///< how many of `included` are named
    bool prepared = false;      ///< the pools above are filled in

    /// Per run the first position in each named column, then the length. When `indexed`, every run is of
    /// one entity and the length is left out.
    std::vector<std::uint32_t> runs;
    bool indexed = false;
    std::uint32_t total = 0;  ///< entities
    std::uint32_t users = 0;  ///< loops that read `runs` right now

    [[nodiscard]] std::uint32_t step() const { return indexed ? columns : columns + 1; }
    [[nodiscard]] bool stale() const;
    void rebuild(const EntityRecord* records);

    /// Whether the entity at the index answers the query now.
    [[nodiscard]] bool matches(const EntityRecord* records, std::uint32_t index) const {
        return masked_ ? ((records[index].mask ^ need_) & care_) == 0 : holdsAll(index);
    }
    /// Whether what stood at a place of a run when the loop began is still there and still matches.
    [[nodiscard]] bool stillThere(const EntityRecord* records, const std::uint32_t* run,
                                  std::uint32_t i) const;

    /// Another cache of the same query, for a loop inside a loop after the world changed.
    QueryCache& spare();
    /// Works out the masks; once the pools are known or were renumbered.
    void prepare();

private:
    [[nodiscard]] bool holdsAll(std::uint32_t index) const;
    [[nodiscard]] std::uint64_t poolVersions() const;
    [[nodiscard]] bool anyHoles() const;
    void buildRuns(const EntityRecord* records, const Pool& lead);
    template <std::uint32_t N>
    bool buildIndex(const EntityRecord* records, const Pool& lead);
    void expandRuns();

    bool masked_ = false;  // the masks say it all: no pool of the query is past the 63rd
    std::uint64_t need_ = 0;
    std::uint64_t care_ = 0;
    std::uint64_t version_ = 0;
    std::unique_ptr<QueryCache> spare_;
    std::vector<std::uint32_t> scratch_;
};

}  // namespace plumb
