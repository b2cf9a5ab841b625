#include "assets/autotile.hpp"

#include <algorithm>
#include <bit>

#include "core/hash.hpp"

namespace plumb {
namespace {

constexpr int kMaxId = 255;

/// Returns the difference of two masks, used to find the best tile: a wrong edge counts 4, a wrong corner 1.
int distance(std::uint8_t a, std::uint8_t b) {
    const unsigned differing = a ^ b;
    return 4 * std::popcount(differing & Neighbour::kEdges) + std::popcount(differing & Neighbour::kCorners);
}

/// Returns a pseudorandom number, uniform in [0, 1), that depends only on the cell and the terrain.
double chanceAt(int x, int y, int terrain) {
    const std::uint64_t place =
        static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32 | static_cast<std::uint32_t>(y);
    return static_cast<double>(mixBits(mixBits(place) + static_cast<std::uint64_t>(terrain)) >> 11) * 0x1p-53;
}

float probabilityOf(const Tileset& tileset, int tile) {
    const Tile* known = tileset.find(tile);
    return known == nullptr ? 1.0f : known->probability;
}

}  // namespace

Autotile::Autotile(const Tileset& tileset) : rules_(kMaxId + 1) {
    for (const Terrain& terrain : tileset.terrains) {
        if (terrain.id < 1 || terrain.id > kMaxId || terrain.tiles.empty()) continue;
        rules_[static_cast<std::size_t>(terrain.id)] = rulesOf(terrain, tileset);
        for (const TerrainTile& tile : terrain.tiles) {
            const auto slot = static_cast<std::size_t>(std::max(tile.tile, 0));
            if (slot >= terrainOfTile_.size()) terrainOfTile_.resize(slot + 1);
            if (terrainOfTile_[slot] == 0) terrainOfTile_[slot] = static_cast<std::uint8_t>(terrain.id);
        }
    }
}

Autotile::Rules Autotile::rulesOf(const Terrain& terrain, const Tileset& tileset) {
    Rules rules;
    rules.known = true;
    rules.mode = terrain.mode;
    std::vector<std::uint8_t> masks;
    for (const TerrainTile& tile : terrain.tiles) {
        const std::uint8_t mask = countedMask(terrain.mode, tile.mask);
        const auto known = std::find(masks.begin(), masks.end(), mask);
        const auto at = static_cast<std::size_t>(known - masks.begin());
        if (known == masks.end()) masks.push_back(mask), rules.choices.emplace_back();
        std::vector<Variant>& variants = rules.choices[at];
        const double before = variants.empty() ? 0.0 : variants.back().upTo;
        variants.push_back({tile.tile, before + static_cast<double>(probabilityOf(tileset, tile.tile))});
    }
    for (unsigned mask = 0; mask < 256; ++mask) {
        const std::uint8_t wanted = countedMask(terrain.mode, static_cast<std::uint8_t>(mask));
        const auto best = std::min_element(masks.begin(), masks.end(), [&](std::uint8_t a, std::uint8_t b) {
            return std::pair{distance(a, wanted), a} < std::pair{distance(b, wanted), b};
        });
        rules.choiceOf[mask] = static_cast<std::uint16_t>(best - masks.begin());
    }
    return rules;
}

bool Autotile::onCorners(int terrain) const {
    return terrain > 0 && terrain <= kMaxId && rules_[static_cast<std::size_t>(terrain)].known &&
           rules_[static_cast<std::size_t>(terrain)].mode == TerrainMode::Corners;
}

int Autotile::terrainOf(TileCell cell) const {
    const int tile = tileOf(cell);
    return tile >= 0 && static_cast<std::size_t>(tile) < terrainOfTile_.size()
               ? terrainOfTile_[static_cast<std::size_t>(tile)]
               : 0;
}

/// Returns the terrain that determines a cell's tile: the cell's own, unless it has mode Corners; otherwise
/// the one with the highest id among those of mode Corners at the cell's corners; 0: none.
int Autotile::terrainFor(const Around& around) const {
    const int own = around[4];
    if (rules_[static_cast<std::size_t>(own)].known && !onCorners(own)) return own;
    int highest = 0;
    for (const std::size_t place : {4u, 5u, 7u, 8u}) {
        if (onCorners(around[place])) highest = std::max(highest, int{around[place]});
    }
    return highest;
}

std::uint8_t Autotile::maskFor(const Around& around, int terrain) const {
    struct Place {
        std::size_t slot;
        std::uint8_t bit;
    };
    using N = Neighbour;
    static constexpr std::array kCells{Place{1, N::kUp},        Place{2, N::kUpRight}, Place{5, N::kRight},
                                       Place{8, N::kDownRight}, Place{7, N::kDown},    Place{6, N::kDownLeft},
                                       Place{3, N::kLeft},      Place{0, N::kUpLeft}};
    static constexpr std::array kCornersOfCell{Place{4, N::kUpLeft}, Place{5, N::kUpRight},
                                               Place{8, N::kDownRight}, Place{7, N::kDownLeft}};
    const auto collect = [&](std::span<const Place> places) {
        unsigned mask = 0;
        for (const Place& place : places) {
            if (around[place.slot] == terrain) mask |= place.bit;
        }
        return static_cast<std::uint8_t>(mask);
    };
    return onCorners(terrain) ? collect(kCornersOfCell) : collect(kCells);
}

std::optional<TileCell> Autotile::cellFor(const Around& around, int x, int y) const {
    const int terrain = terrainFor(around);
    if (terrain == 0) return std::nullopt;
    const Rules& rules = rules_[static_cast<std::size_t>(terrain)];
    const std::vector<Variant>& variants = rules.choices[rules.choiceOf[maskFor(around, terrain)]];
    const double wanted = chanceAt(x, y, terrain) * variants.back().upTo;
    const auto chosen = std::find_if(variants.begin(), variants.end() - 1,
                                     [&](const Variant& variant) { return wanted < variant.upTo; });
    return cellOf(chosen->tile);
}

std::optional<TileCell> Autotile::cellAt(const TileGrid& terrain, int x, int y) const {
    Around around{};
    for (int i = 0; i < 9; ++i) {
        const int atX = std::clamp(x + i % 3 - 1, 0, terrain.width() - 1);
        const int atY = std::clamp(y + i / 3 - 1, 0, terrain.height() - 1);
        around[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(terrain.at(atX, atY));
    }
    return cellFor(around, x, y);
}

TileGrid terrainFromTiles(const TileGrid& cells, const Tileset& tileset) {
    const Autotile autotile{tileset};
    TileGrid terrain{cells.width(), cells.height()};
    const auto mark = [&](int x, int y, TileCell cell) {
        const int id = autotile.terrainOf(cell);
        if (id == 0) return;
        if (!autotile.onCorners(id)) return terrain.set(x, y, static_cast<TileCell>(id));
        const auto owner = std::find_if(tileset.terrains.begin(), tileset.terrains.end(),
                                        [&](const Terrain& other) { return other.id == id; });
        const auto tile = std::find_if(owner->tiles.begin(), owner->tiles.end(),
                                       [&](const TerrainTile& other) { return other.tile == tileOf(cell); });
        if ((tile->mask & Neighbour::kUpLeft) != 0) terrain.set(x, y, static_cast<TileCell>(id));
        if ((tile->mask & Neighbour::kUpRight) != 0) terrain.set(x + 1, y, static_cast<TileCell>(id));
        if ((tile->mask & Neighbour::kDownLeft) != 0) terrain.set(x, y + 1, static_cast<TileCell>(id));
        if ((tile->mask & Neighbour::kDownRight) != 0) terrain.set(x + 1, y + 1, static_cast<TileCell>(id));
    };
    constexpr int kSide = TileGrid::kChunkSide;
    for (int row = 0; row < cells.chunkRows(); ++row) {
        for (int column = 0; column < cells.chunkColumns(); ++column) {
            const TileGrid::Chunk* chunk = cells.chunk(column, row);
            for (int i = 0; chunk != nullptr && i < kSide * kSide; ++i)
                mark(column * kSide + i % kSide, row * kSide + i / kSide,
                     chunk->cells[static_cast<std::size_t>(i)]);
        }
    }
    return terrain;
}

}  // namespace plumb
