#include "editor/model/tiles/tile_brush.hpp"

#include <algorithm>

#include "core/hash.hpp"

namespace plumb::editor {
namespace {

int wrapped(int value, int size) { return ((value % size) + size) % size; }

double weightOf(const Tileset* tileset, TileCell cell) {
    if (cell == 0) return 0.0;
    const Tile* tile = tileset == nullptr ? nullptr : tileset->find(tileOf(cell));
    return tile == nullptr ? 1.0 : static_cast<double>(tile->probability);
}

/// Returns a pseudo-random number in [0, 1) for a cell in one stroke.
double chanceAt(CellPlace place, std::uint32_t seed) {
    const std::uint64_t bits = static_cast<std::uint64_t>(static_cast<std::uint32_t>(place.x)) << 32 |
                               static_cast<std::uint32_t>(place.y);
    return static_cast<double>(mixBits(mixBits(bits) ^ seed) >> 11) * 0x1p-53;
}

}  // namespace

const Terrain* activeTerrain(const Tileset& tileset, const TilePaint& paint) {
    if (tileset.terrains.empty()) return nullptr;
    const auto found = std::find_if(tileset.terrains.begin(), tileset.terrains.end(),
                                    [&](const Terrain& terrain) { return terrain.id == paint.terrain; });
    return found == tileset.terrains.end() ? &tileset.terrains.front() : &*found;
}

std::shared_ptr<TileGrid> DerivedTerrain::of(ObjectId layer, const TileGrid& cells, const Tileset& tileset) {
    const bool known = terrain_ != nullptr && layer_ == layer && version_ == cells.version() &&
                       terrain_->width() == cells.width() && terrain_->height() == cells.height() &&
                       terrains_ == tileset.terrains;
    if (!known) {
        terrain_ = std::make_shared<TileGrid>(terrainFromTiles(cells, tileset));
        layer_ = layer;
        version_ = cells.version();
        terrains_ = tileset.terrains;
    }
    return terrain_;
}

TileBrush::TileBrush(const Document& document, const TilePaint& paint, ObjectId layer, TileInk ink,
                     std::uint32_t seed, DerivedTerrain* derived)
    : paint_{paint},
      tileset_{tilesetOf(document, layer)},
      grid_{gridOf(document, layer)},
      terrain_{terrainOf(document, layer)},
      ink_{ink},
      seed_{seed} {
    if (grid_ == nullptr) return;
    const bool fits =
        terrain_ != nullptr && terrain_->width() == grid_->width() && terrain_->height() == grid_->height();
    if (ink == TileInk::Terrain) {
        const Terrain* terrain = tileset_ == nullptr ? nullptr : activeTerrain(*tileset_, paint);
        if (terrain == nullptr) {
            grid_ = nullptr;
            return;
        }
        id_ = terrain->id;
        if (!fits) makeTerrain(layer, derived);
    } else if (!fits) {
        terrain_ = nullptr;
    }
    if (terrain_ != nullptr && tileset_ != nullptr) autotile_ = std::make_unique<Autotile>(*tileset_);
    for (const TileCell cell : paint.stamp.cells) weights_ += weightOf(tileset_, cell);
}

void TileBrush::makeTerrain(ObjectId layer, DerivedTerrain* derived) {
    DerivedTerrain once;
    newTerrain_ = terrain_ != nullptr
                      ? std::make_shared<TileGrid>(resized(*terrain_, grid_->width(), grid_->height()))
                      : (derived != nullptr ? *derived : once).of(layer, *grid_, *tileset_);
    terrain_ = newTerrain_.get();
}

bool TileBrush::onCorners() const {
    return ink_ == TileInk::Terrain && autotile_ != nullptr && autotile_->onCorners(id_);
}

std::vector<CellPlace> TileBrush::coveredAt(CellPlace at) const {
    if (ink_ != TileInk::Stamp || paint_.random) return {at};
    std::vector<CellPlace> places;
    for (int y = 0; y < paint_.stamp.height; ++y) {
        for (int x = 0; x < paint_.stamp.width; ++x) places.push_back({at.x + x, at.y + y});
    }
    return places;
}

PaintTiles::Change TileBrush::change(const std::vector<CellPlace>& places, CellPlace origin) const {
    if (!ready()) return {};
    if (ink_ == TileInk::Nothing) return erased(places);
    if (ink_ == TileInk::Stamp) return stamped(places, origin);
    std::vector<PaintTiles::Cell> wanted;
    wanted.reserve(places.size());
    for (const CellPlace place : places) wanted.push_back({place.x, place.y, static_cast<TileCell>(id_)});
    return withTerrain(wanted);
}

PaintTiles::Change TileBrush::withTerrain(const std::vector<PaintTiles::Cell>& wanted) const {
    PaintTiles::Change change = terrainChange(*grid_, *terrain_, *autotile_, wanted);
    if (!change.empty()) change.newTerrain = newTerrain_;
    return change;
}

PaintTiles::Change TileBrush::stamped(const std::vector<CellPlace>& places, CellPlace origin) const {
    PaintTiles::Change change;
    const bool whole = paint_.stamp.single() && !paint_.random;
    for (const CellPlace place : places) {
        if (!grid_->has(place.x, place.y)) continue;
        const TileCell cell = paint_.random ? randomCell(place) : stampCell(place, origin);
        // Empty cells of a pattern do not change the layer.
        if ((cell == 0 && !whole) || grid_->at(place.x, place.y) == cell) continue;
        change.cells.push_back({place.x, place.y, cell});
    }
    return change;
}

/// Erasing tiles also removes their terrain, so that the remaining terrain gets a border there.
PaintTiles::Change TileBrush::erased(const std::vector<CellPlace>& places) const {
    PaintTiles::Change change;
    std::vector<PaintTiles::Cell> bare;
    const auto uncover = [&](int x, int y, bool corner) {
        if (terrain_ == nullptr || autotile_ == nullptr) return;
        const auto id = static_cast<int>(terrain_->at(x, y));
        if (id != 0 && (!corner || autotile_->onCorners(id))) bare.push_back({x, y, 0});
    };
    for (const CellPlace place : places) {
        uncover(place.x, place.y, false);
        uncover(place.x + 1, place.y, true);
        uncover(place.x, place.y + 1, true);
        uncover(place.x + 1, place.y + 1, true);
    }
    if (!bare.empty()) {
        const auto inRows = [](const PaintTiles::Cell& a, const PaintTiles::Cell& b) {
            return std::pair{a.y, a.x} < std::pair{b.y, b.x};
        };
        std::sort(bare.begin(), bare.end(), inRows);
        bare.erase(std::unique(bare.begin(), bare.end(),
                               [](const auto& a, const auto& b) { return a.x == b.x && a.y == b.y; }),
                   bare.end());
        change = withTerrain(bare);
    }
    CellSelection changed;
    std::vector<CellPlace> known;
    for (const PaintTiles::Cell& cell : change.cells) known.push_back({cell.x, cell.y});
    changed.set(std::move(known));
    for (const CellPlace place : places) {
        if (grid_->at(place.x, place.y) != 0 && !changed.has(place))
            change.cells.push_back({place.x, place.y, 0});
    }
    return change;
}

TileCell TileBrush::stampCell(CellPlace place, CellPlace origin) const {
    const TileStamp& stamp = paint_.stamp;
    return stamp.at(wrapped(place.x - origin.x, stamp.width), wrapped(place.y - origin.y, stamp.height));
}

TileCell TileBrush::randomCell(CellPlace place) const {
    double wanted = chanceAt(place, seed_) * weights_;
    TileCell last = 0;
    for (const TileCell cell : paint_.stamp.cells) {
        const double weight = weightOf(tileset_, cell);
        if (weight <= 0.0) continue;
        last = cell;
        if (wanted < weight) return cell;
        wanted -= weight;
    }
    return last;
}

}  // namespace plumb::editor
