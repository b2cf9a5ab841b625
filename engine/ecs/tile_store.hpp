#pragma once

#include <cstdint>
#include <vector>

#include "core/hash.hpp"
#include "math/tile_grid.hpp"
#include "reflect/field_types.hpp"

namespace plumb {

/// The tile grids of a world, named by TilesId so that components stay plain data. A grid lives as long as a
/// component names it: the world drops the others at the start of a tick.
/// Copies are cheap when little changed: assigning copies only the grids that differ.
class TileStore {
public:
    /// A new name for the grid; names are never used again.
    TilesId add(TileGrid grid);
    void remove(TilesId id);
    [[nodiscard]] const TileGrid* find(TilesId id) const;
    /// The grid, to change it. Ask anew after a snapshot was restored; only reading? use find.
    TileGrid* edit(TilesId id);
    [[nodiscard]] std::size_t size() const { return entries_.size(); }

    /// Garbage collection: unmark all grids, mark those in use, drop the rest.
    void unmarkAll();
    void mark(TilesId id);
    void dropUnmarked();

    TileStore() = default;
    TileStore(const TileStore& other) { *this = other; }
    TileStore& operator=(const TileStore& other);

    void addTo(Hasher& hasher) const;

private:
    struct Entry {
        std::uint32_t id = 0;
        bool marked = false;
        TileGrid grid;
        std::uint64_t stamp = 0;  // of the last edit(); no two edits of the program share one
        mutable std::uint64_t hash = 0;
        mutable std::uint64_t hashedStamp = 0;
        mutable std::uint32_t hashedVersion = 0;

        [[nodiscard]] bool same(const Entry& other) const {
            return id == other.id && stamp == other.stamp && grid.version() == other.grid.version();
        }
    };
    [[nodiscard]] Entry* entry(TilesId id) const;

    std::vector<Entry> entries_;  // by id
    std::uint32_t lastId_ = 0;
};

}  // namespace plumb
