#include "ecs/tile_store.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "core/limits.hpp"

namespace plumb {

namespace {

/// Small grids are hashed row by row, large ones chunk by chunk, as most of these are empty.
constexpr std::size_t kSmallGrid = 256 * 256;

std::uint64_t hashOf(const TileGrid& grid) {
    Hasher cells;
    cells.add(static_cast<std::uint64_t>(grid.width()));
    if (grid.cellCount() <= kSmallGrid) {
        const std::vector<TileCell> rows = grid.cells();
        cells.addBytes(rows.data(), rows.size() * sizeof(TileCell));
        return cells.value();
    }
    cells.add(static_cast<std::uint64_t>(grid.height()));
    for (int row = 0; row < grid.chunkRows(); ++row) {
        for (int column = 0; column < grid.chunkColumns(); ++column) {
            const TileGrid::Chunk* chunk = grid.chunk(column, row);
            if (chunk == nullptr) continue;
            if (std::all_of(chunk->cells.begin(), chunk->cells.end(), [](TileCell c) { return c == 0; }))
                continue;
            LaneHasher lanes;
            lanes.addBytes(chunk->cells.data(), sizeof chunk->cells);
            cells.add(static_cast<std::uint64_t>(row) << 32 | static_cast<std::uint64_t>(column));
            cells.add(lanes.value());
        }
    }
    return cells.value();
}

/// Writes or reads the chunks that are not empty.
void archiveChunks(StateArchive& archive, TileGrid& grid) {
    for (int row = 0; row < grid.chunkRows(); ++row) {
        for (int column = 0; column < grid.chunkColumns() && archive.ok(); ++column) {
            const TileGrid::Chunk* known = archive.reading() ? nullptr : grid.chunk(column, row);
            std::uint32_t exists = known != nullptr ? 1 : 0;
            archive.number(exists);
            if (exists == 0) continue;
            auto chunk = known != nullptr ? std::make_shared<TileGrid::Chunk>(*known) : TileGrid::filled(1);
            archive.block(chunk->cells.data(), sizeof chunk->cells);
            if (archive.reading()) grid.put(column, row, std::move(chunk));
        }
    }
}

bool canFollow(const TileGrid& grid, const TileGrid& other) {
    return other.cellCount() > kSmallGrid && grid.width() == other.width() && grid.height() == other.height();
}

/// Makes a large grid equal to another of its size by copying the chunks that differ; others stay shared.
void follow(TileGrid& grid, const TileGrid& other) {
    for (int row = 0; row < other.chunkRows(); ++row) {
        if (grid.rowStamp(row) == other.rowStamp(row)) continue;
        for (int column = 0; column < other.chunkColumns(); ++column) {
            if (grid.chunk(column, row) != other.chunk(column, row)) grid.adopt(other, column, row);
        }
    }
}

/// Stamps only distinguish edits; their order has no meaning.
std::uint64_t nextStamp() {
    static std::atomic<std::uint64_t> stamp{0};
    return ++stamp;
}

}  // namespace

TilesId TileStore::add(TileGrid grid) {
    Entry& entry = entries_.emplace_back();
    entry.id = ++lastId_;
    entry.grid = std::move(grid);
    entry.stamp = nextStamp();
    return {entry.id};
}

void TileStore::remove(TilesId id) {
    if (const Entry* gone = entry(id)) entries_.erase(entries_.begin() + (gone - entries_.data()));
}

TileStore::Entry* TileStore::entry(TilesId id) const {
    const auto at =
        std::lower_bound(entries_.begin(), entries_.end(), id.value,
                         [](const Entry& entry, std::uint32_t value) { return entry.id < value; });
    return at != entries_.end() && at->id == id.value ? const_cast<Entry*>(&*at) : nullptr;
}

const TileGrid* TileStore::find(TilesId id) const {
    const Entry* found = entry(id);
    return found != nullptr ? &found->grid : nullptr;
}

TileGrid* TileStore::edit(TilesId id) {
    Entry* found = entry(id);
    if (found == nullptr) return nullptr;
    found->stamp = nextStamp();
    return &found->grid;
}

void TileStore::unmarkAll() {
    for (Entry& entry : entries_) entry.marked = false;
}

void TileStore::mark(TilesId id) {
    if (Entry* found = entry(id)) found->marked = true;
}

void TileStore::dropUnmarked() {
    std::erase_if(entries_, [](const Entry& entry) { return !entry.marked; });
}

TileStore& TileStore::operator=(const TileStore& other) {
    if (this == &other) return *this;
    lastId_ = other.lastId_;
    // Usually the same grids as before: equal ones keep their memory and position.
    std::size_t same = 0;
    const std::size_t both = std::min(entries_.size(), other.entries_.size());
    while (same < both && entries_[same].id == other.entries_[same].id) {
        Entry& mine = entries_[same];
        const Entry& theirs = other.entries_[same];
        if (!mine.same(theirs)) {
            if (canFollow(mine.grid, theirs.grid)) {
                follow(mine.grid, theirs.grid);
                mine.marked = theirs.marked;
                mine.stamp = nextStamp();  // from now on its versions differ from the other's
            } else {
                mine = theirs;
            }
        }
        ++same;
    }
    std::vector<Entry> rest(std::make_move_iterator(entries_.begin() + static_cast<std::ptrdiff_t>(same)),
                            std::make_move_iterator(entries_.end()));
    entries_.resize(same);
    for (std::size_t i = same; i < other.entries_.size(); ++i) {
        const Entry& from = other.entries_[i];
        const auto kept =
            std::find_if(rest.begin(), rest.end(), [&](const Entry& e) { return e.same(from); });
        entries_.push_back(kept != rest.end() ? std::move(*kept) : from);
    }
    return *this;
}

void TileStore::archive(StateArchive& archive) {
    archive.number(lastId_);
    const std::size_t count = archive.count(entries_.size());
    if (archive.reading()) {
        entries_.clear();
        entries_.resize(count);
    }
    std::uint32_t before = 0;
    for (Entry& entry : entries_) {
        archive.number(entry.id);
        std::uint32_t width = static_cast<std::uint32_t>(entry.grid.width());
        std::uint32_t height = static_cast<std::uint32_t>(entry.grid.height());
        archive.number(width);
        archive.number(height);
        if (entry.id <= before || entry.id > lastId_ || width > limits::kTileSide ||
            height > limits::kTileSide)
            archive.fail();
        if (!archive.ok()) break;
        before = entry.id;
        if (archive.reading()) {
            entry.grid = TileGrid{static_cast<int>(width), static_cast<int>(height)};
            entry.stamp = nextStamp();
        }
        archiveChunks(archive, entry.grid);
    }
    if (!archive.ok()) entries_.clear();
}

void TileStore::addTo(Hasher& hasher) const {
    for (const Entry& entry : entries_) {
        if (entry.hashedStamp != entry.stamp || entry.hashedVersion != entry.grid.version()) {
            entry.hash = hashOf(entry.grid);
            entry.hashedStamp = entry.stamp;
            entry.hashedVersion = entry.grid.version();
        }
        hasher.add(std::uint64_t{entry.id} - 1);
        hasher.add(entry.hash);
    }
}

}  // namespace plumb
