#include "ecs/tile_store.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

namespace plumb {

namespace {

/// Stamps only tell copies of one edit from another edit; their order means nothing.
std::uint64_t nextStamp() {
    static std::atomic<std::uint64_t> stamp{0};
    return ++stamp;
}

}  // namespace

TilesId TileStore::add(TileGrid grid) {
    Entry& entry = entries_.emplace_back();
    entry.present = true;
    entry.grid = std::move(grid);
    entry.stamp = nextStamp();
    return {static_cast<std::uint32_t>(entries_.size())};
}

void TileStore::remove(TilesId id) {
    if (entry(id) == nullptr) return;
    Entry& gone = entries_[id.value - 1];
    gone = {};
    gone.stamp = nextStamp();
}

const TileStore::Entry* TileStore::entry(TilesId id) const {
    if (id.value == 0 || id.value > entries_.size()) return nullptr;
    const Entry& found = entries_[id.value - 1];
    return found.present ? &found : nullptr;
}

const TileGrid* TileStore::find(TilesId id) const {
    const Entry* found = entry(id);
    return found != nullptr ? &found->grid : nullptr;
}

TileGrid* TileStore::edit(TilesId id) {
    if (entry(id) == nullptr) return nullptr;
    Entry& found = entries_[id.value - 1];
    found.stamp = nextStamp();
    return &found.grid;
}

std::size_t TileStore::size() const {
    return static_cast<std::size_t>(
        std::count_if(entries_.begin(), entries_.end(), [](const Entry& entry) { return entry.present; }));
}

TileStore& TileStore::operator=(const TileStore& other) {
    if (this == &other) return *this;
    entries_.resize(other.entries_.size());
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const Entry& from = other.entries_[i];
        const bool same =
            entries_[i].stamp == from.stamp && entries_[i].grid.version() == from.grid.version();
        if (!same) entries_[i] = from;
    }
    return *this;
}

void TileStore::addTo(Hasher& hasher) const {
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const Entry& entry = entries_[i];
        if (!entry.present) continue;
        if (entry.hashedStamp != entry.stamp || entry.hashedVersion != entry.grid.version()) {
            Hasher cells;
            cells.add(static_cast<std::uint64_t>(entry.grid.width()));
            cells.addBytes(entry.grid.cells().data(), entry.grid.cells().size() * sizeof(TileCell));
            entry.hash = cells.value();
            entry.hashedStamp = entry.stamp;
            entry.hashedVersion = entry.grid.version();
        }
        hasher.add(std::uint64_t{i});
        hasher.add(entry.hash);
    }
}

}  // namespace plumb
