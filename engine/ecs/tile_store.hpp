#pragma once

#include <cstdint>
#include <vector>

#include "core/hash.hpp"
#include "core/state_archive.hpp"
#include "math/tile_grid.hpp"
#include "reflect/field_types.hpp"

namespace plumb {

/// The tile grids of a world. Components refer to them by TilesId and so stay plain data. A grid
/// is kept while a component refers to it: the world removes the others at the start of a tick.
/// Copying is cheap if little changed: assignment copies only the grids that differ.
class TileStore {
public:
    /// Adds a grid and returns its id; ids are never reused.
    TilesId add(TileGrid grid);
    void remove(TilesId id);
    [[nodiscard]] const TileGrid* find(TilesId id) const;
    /// Returns the grid for changes. Call it again after a snapshot was restored; use find() to read.
    TileGrid* edit(TilesId id);
    [[nodiscard]] std::size_t size() const { return entries_.size(); }

    /// Garbage collection: unmark all grids, mark those in use, remove the rest.
    void unmarkAll();
    void mark(TilesId id);
    void dropUnmarked();

    TileStore() = default;
    TileStore(const TileStore& other) { *this = other; }
    TileStore& operator=(const TileStore& other);

    void addTo(Hasher& hasher) const;
    /// Writes all grids, or replaces them by those that are read.
    void archive(StateArchive& archive);

private:
    struct Entry {
        std::uint32_t id = 0;
        bool marked = false;
        TileGrid grid;
        std::uint64_t stamp = 0;  // stamp of the last edit(); unique within the program
        mutable std::uint64_t hash = 0;
        mutable std::uint64_t hashedStamp = 0;
        mutable std::uint32_t hashedVersion = 0;

        [[nodiscard]] bool same(const Entry& other) const {
            return id == other.id && stamp == other.stamp && grid.version() == other.grid.version();
        }
    };
    [[nodiscard]] Entry* entry(TilesId id) const;

    std::vector<Entry> entries_;  // sorted by id
    std::uint32_t lastId_ = 0;
};

}  // namespace plumb
