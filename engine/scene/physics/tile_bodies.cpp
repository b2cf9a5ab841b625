#include "scene/physics/tile_bodies.hpp"

#include <algorithm>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "assets/asset_store.hpp"
#include "core/task_pool.hpp"
#include "core/text.hpp"
#include "scene/components/transform.hpp"
#include "scene/physics/entity_bodies.hpp"

namespace plumb {

namespace {

using physics::MaskCell;
using physics::OneWay;
using physics::TerrainOutlines;
using physics::TileForm;
using physics::TilePalette;

template <class T>
T valueOr(const Result<T>& result, T otherwise) {
    return result ? *result : otherwise;
}

TileForm formOf(TileShape shape) {
    constexpr TileForm kForms[] = {
        TileForm::Empty,        TileForm::Full,       TileForm::OneWay,      TileForm::SlopeUp,
        TileForm::SlopeDown,    TileForm::SlopeUpLow, TileForm::SlopeUpHigh, TileForm::SlopeDownHigh,
        TileForm::SlopeDownLow, TileForm::HalfTop,    TileForm::HalfBottom,
    };
    return kForms[static_cast<std::size_t>(shape)];
}

/// Converts the cells of a tile grid to terrain cells.
class CellReader {
public:
    CellReader(const Tileset* tileset, const TileCollider& collider, TilePalette& palette)
        : tileset_{tileset}, collider_{collider}, palette_{palette} {
        layers_ = valueOr(palette.addLayers({collider.layers, collider.mask}), std::uint8_t{0});
    }

    MaskCell of(TileCell cell) {
        if (cell == 0) return {};
        if (cell == last_.first) return last_.second;
        auto known =
            std::lower_bound(known_.begin(), known_.end(), cell,
                             [](const auto& entry, TileCell wanted) { return entry.first < wanted; });
        if (known == known_.end() || known->first != cell) known = known_.emplace(known, cell, make(cell));
        return (last_ = *known).second;
    }

    /// The first tile whose polygons were not accepted.
    [[nodiscard]] const std::optional<Error>& refusal() const { return refusal_; }

private:
    MaskCell make(TileCell cell) {
        const Tile* tile = tileset_ != nullptr ? tileset_->find(tileOf(cell)) : nullptr;
        if (tileset_ != nullptr && tile == nullptr) return {};
        const TileForm form = tile != nullptr ? formOf(*tile, cell & kTileFlips) : TileForm::Full;
        if (form == TileForm::Empty) return {};
        physics::TileMaterial material;
        material.friction = tile != nullptr && tile->friction >= 0.0f ? tile->friction : collider_.friction;
        material.bounciness =
            std::clamp(tile != nullptr && tile->bounciness >= 0.0f ? tile->bounciness : collider_.bounciness,
                       0.0f, 1.0f);
        return {form, valueOr(palette_.addMaterial(material), std::uint8_t{0}), layers_};
    }

    TileForm formOf(const Tile& tile, TileCell flips) {
        if (tile.shape == TileShape::None) return TileForm::Empty;
        TileForm form = TileForm::Full;
        if (tile.shape == TileShape::Polygon) {
            const Vec2 size{static_cast<float>(tileset_->tileWidth),
                            static_cast<float>(tileset_->tileHeight)};
            std::vector<std::vector<Vec2>> polygons = tile.polygons;
            for (std::vector<Vec2>& polygon : polygons) {
                for (Vec2& point : polygon) point = {point.x / size.x, point.y / size.y};
            }
            const Result<TileForm> added = palette_.addPolygons(polygons);
            if (!added && !refusal_)
                refusal_ = Error{format("tile {}", tile.id),
                                 added.error().what + "; it collides as a full cell", added.error().remedy};
            form = valueOr(added, TileForm::Full);
        } else {
            form = plumb::formOf(tile.shape);
        }
        if (flips != 0) form = valueOr(palette_.flipped(form, flips), form);
        if (tile.oneWay && tile.shape != TileShape::OneWay)
            form = valueOr(palette_.withOneWay(form, OneWay::Up), form);
        return form;
    }

    const Tileset* tileset_;
    const TileCollider& collider_;
    TilePalette& palette_;
    std::uint8_t layers_ = 0;
    std::vector<std::pair<TileCell, MaskCell>> known_;  // sorted by cell
    std::pair<TileCell, MaskCell> last_;
    std::optional<Error> refusal_;
};

std::uint32_t revisionOf(const World& world, const TileLayer& layer) {
    const auto* assets = world.service<AssetStore>();
    return assets == nullptr ? 0 : assets->revisionOf(AssetKind::Tileset, layer.tileset.path);
}

std::uint64_t madeFrom(const TileLayer& layer, const TileCollider& collider, const TileGrid& grid, Vec2 place,
                       Vec2 tileSize) {
    Hasher hasher;
    hasher.add(std::uint64_t{layer.cells.value});
    hasher.add(layer.tileset.path.value);
    hasher.add(static_cast<std::uint64_t>(grid.width()) << 32 | static_cast<std::uint64_t>(grid.height()));
    for (const float value : {place.x, place.y, tileSize.x, tileSize.y}) hasher.add(value);
    hasher.add(std::uint64_t{collider.layers} << 32 | collider.mask);
    hasher.add(collider.friction), hasher.add(collider.bounciness);
    return hasher.value() | 1;
}

/// Calls `visit(x, y)` for every cell of a chunk.
template <class Visit>
void eachCell(const TileGrid& grid, int column, int row, Visit visit) {
    constexpr int kSide = TileGrid::kChunkSide;
    for (int y = row * kSide; y < std::min((row + 1) * kSide, grid.height()); ++y) {
        for (int x = column * kSide; x < std::min((column + 1) * kSide, grid.width()); ++x) visit(x, y);
    }
}

constexpr std::size_t kCellsWorthThreads = std::size_t{1} << 22;

int threadsHere() {
    constexpr int kMost = 8;
    return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMost);
}

/// Updates the terrain of one tile layer.
class TileSync {
public:
    TileSync(World& world, PhysicsState& state, EntityId entity, const TileLayer& layer,
             const TileCollider& collider)
        : reader_{world},
          state_{state},
          pool_{world.service<TaskPool>()},
          entity_{entity},
          layer_{layer},
          collider_{collider} {}

    void follow(const TileGrid& grid) {
        TileTerrain& terrain = find();
        terrain.seen = state_.syncs;
        const Vec2 place = worldPose(reader_, entity_).position;
        const Vec2 size = tileSizeOf(reader_, layer_);
        const std::uint64_t made = madeFrom(layer_, collider_, grid, place, size);
        // The revisions of another program mean nothing: after a saved game was loaded, this one counts.
        const std::uint32_t revision = revisionOf(reader_, layer_);
        if (terrain.outlines == nullptr) terrain.revision = revision;
        if (made != terrain.made || revision != terrain.revision) {
            terrain.made = made;
            terrain.revision = revision;
            makeAnew(terrain, grid, place, size);
        } else if (grid.version() != terrain.version || terrain.outlines == nullptr) {
            if (terrain.outlines == nullptr) remember(terrain);
            change(terrain, grid);
        }
        terrain.version = grid.version();
    }

private:
    TileTerrain& find() {
        const auto known = std::find_if(state_.terrains.begin(), state_.terrains.end(),
                                        [&](const TileTerrain& other) { return other.entity == entity_; });
        if (known != state_.terrains.end()) return *known;
        state_.terrains.emplace_back().entity = entity_;
        return state_.terrains.back();
    }

    /// After a saved game was loaded: makes the outlines of the bodies that there are.
    void remember(TileTerrain& terrain) {
        physics::TileMask mask{terrain.cells->width(), terrain.cells->height()};
        readChunks(*terrain.cells, mask);
        terrain.outlines = std::make_shared<TerrainOutlines>(std::move(mask));
        static_cast<void>(terrain.outlines->update(pool_));
    }

    void makeAnew(TileTerrain& terrain, const TileGrid& grid, Vec2 place, Vec2 size) {
        terrain.body.destroy(state_.world);
        physics::TileMask mask{grid.width(), grid.height()};
        readChunks(grid, mask);
        terrain.outlines = std::make_shared<TerrainOutlines>(std::move(mask));
        terrain.cells = std::make_shared<TileGrid>(grid);
        physics::TerrainDefinition definition;
        definition.position = positionInMetres(place, state_.scale);
        definition.cellSize = toMetres(size, state_.scale);
        definition.user = userOf(entity_);
        auto body = physics::TerrainBody::create(state_.world, *terrain.outlines, definition);
        if (!body) return logRefusal(reader_, state_, entity_, body.error());
        terrain.body = std::move(*body);
        // Large maps use temporary threads if the world has no thread pool.
        std::optional<TaskPool> threads;
        if (pool_ == nullptr && grid.cellCount() > kCellsWorthThreads)
            pool_ = &threads.emplace(threadsHere());
        update(terrain);
        if (threads) pool_ = nullptr;
    }

    /// Converts the grid chunk by chunk; in chunks of a single tile only one cell is converted.
    void readChunks(const TileGrid& grid, physics::TileMask& mask) {
        CellReader cells{tileset(), collider_, mask.palette};
        physics::TileMask::Chunk read;
        for (int row = 0; row < mask.cells().chunkRows(); ++row) {
            for (int column = 0; column < mask.cells().chunkColumns(); ++column) {
                const TileGrid::Chunk* chunk = grid.chunk(column, row);
                if (chunk == nullptr) continue;
                const TileCell first = chunk->cells.front();
                if (std::all_of(chunk->cells.begin(), chunk->cells.end(),
                                [first](TileCell cell) { return cell == first; })) {
                    mask.putPlain(column, row, cells.of(first));
                    continue;
                }
                std::transform(chunk->cells.begin(), chunk->cells.end(), read.begin(),
                               [&](TileCell cell) { return cells.of(cell); });
                mask.putChunk(column, row, read);
            }
        }
        tellRefused(cells);
    }

    void tellRefused(const CellReader& cells) {
        if (cells.refusal()) logRefusal(reader_, state_, entity_, *cells.refusal());
    }

    /// Updates the terrain from changed cells. Visits only chunks that differ.
    void change(TileTerrain& terrain, const TileGrid& grid) {
        makeOwn(terrain.outlines);
        makeOwn(terrain.cells);
        TileGrid& known = *terrain.cells;
        CellReader cells{tileset(), collider_, terrain.outlines->palette()};
        for (int row = 0; row < grid.chunkRows(); ++row) {
            if (known.rowStamp(row) == grid.rowStamp(row)) continue;
            for (int column = 0; column < grid.chunkColumns(); ++column) {
                if (known.chunk(column, row) == grid.chunk(column, row)) continue;
                eachCell(grid, column, row, [&](int x, int y) {
                    const TileCell now = grid.at(x, y);
                    if (known.at(x, y) != now) terrain.outlines->set(x, y, cells.of(now));
                });
                known.adopt(grid, column, row);
            }
        }
        tellRefused(cells);
        update(terrain);
    }

    template <class T>
    static void makeOwn(std::shared_ptr<T>& shared) {
        if (shared.use_count() > 1) shared = std::make_shared<T>(*shared);
    }

    void update(TileTerrain& terrain) {
        const auto updated =
            terrain.body.update(state_.world, *terrain.outlines, terrain.outlines->update(pool_));
        if (!updated) logRefusal(reader_, state_, entity_, updated.error());
    }

    [[nodiscard]] const Tileset* tileset() const {
        const auto* assets = reader_.service<AssetStore>();
        return assets != nullptr ? &assets->tileset(layer_.tileset) : nullptr;
    }

    const World& reader_;
    PhysicsState& state_;
    TaskPool* pool_;
    EntityId entity_;
    const TileLayer& layer_;
    const TileCollider& collider_;
};

}  // namespace

Vec2 tileSizeOf(const World& world, const TileLayer& layer) {
    if (layer.tileSize.x > 0.0f && layer.tileSize.y > 0.0f) return layer.tileSize;
    const auto* assets = world.service<AssetStore>();
    if (assets == nullptr) return {16.0f, 16.0f};
    const Tileset& tileset = assets->tileset(layer.tileset);
    return {static_cast<float>(std::max(tileset.tileWidth, 1)),
            static_cast<float>(std::max(tileset.tileHeight, 1))};
}

void followTiles(World& world, PhysicsState& state, bool all) {
    for (auto [entity, layer, collider] :
         std::as_const(world).query<const TileLayer, const TileCollider>(with<Transform>)) {
        const TileGrid* grid = world.tiles().find(layer.cells);
        if (grid == nullptr || grid->width() == 0 || grid->height() == 0) continue;
        TileSync{world, state, entity.id(), layer, collider}.follow(*grid);
    }
    if (!all) return;
    std::erase_if(state.terrains, [&state](TileTerrain& terrain) {
        if (terrain.seen == state.syncs) return false;
        terrain.body.destroy(state.world);
        return true;
    });
}

}  // namespace plumb
