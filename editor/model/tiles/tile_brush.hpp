#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "editor/model/document/cell_selection.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "editor/model/tiles/terrain_paint.hpp"

namespace plumb::editor {

/// What a stroke puts into cells: the tiles of the stamp, a terrain, or nothing (it erases).
enum class TileInk : unsigned char { Stamp, Terrain, Nothing };

/// Derives the terrain of a layer without terrain data from its tiles. The result is cached until the tiles
/// change.
class DerivedTerrain {
public:
    std::shared_ptr<TileGrid> of(ObjectId layer, const TileGrid& cells, const Tileset& tileset);

private:
    ObjectId layer_;
    std::uint32_t version_ = 0;
    std::vector<Terrain> terrains_;
    std::shared_ptr<TileGrid> terrain_;
};

/// Computes the change of a tile layer when cells are painted with the stamp or a terrain, or erased.
class TileBrush {
public:
    /// @param seed     seed of the choice of random tiles; a different one for each stroke
    /// @param derived  cache kept between brushes, used for terrain; may be null
    TileBrush(const Document& document, const TilePaint& paint, ObjectId layer, TileInk ink,
              std::uint32_t seed, DerivedTerrain* derived = nullptr);

    /// True if there is a layer to paint on, and a terrain if the ink is terrain.
    [[nodiscard]] bool ready() const { return grid_ != nullptr; }
    [[nodiscard]] const TileGrid& grid() const { return *grid_; }
    /// The terrain that decides which cells are equal, for flood fills; null: only tiles are compared.
    [[nodiscard]] const TileGrid* equalTerrain() const {
        return ink_ == TileInk::Terrain ? terrain_ : nullptr;
    }
    /// True if the terrain is painted on the corners of cells instead of the cells.
    [[nodiscard]] bool onCorners() const;

    /// Returns the cells that the brush covers if its upper left cell is `at`.
    [[nodiscard]] std::vector<CellPlace> coveredAt(CellPlace at) const;
    /// Computes the change of painting these cells.
    /// @param origin  cell of the upper left corner of the stamp's pattern, which repeats
    [[nodiscard]] PaintTiles::Change change(const std::vector<CellPlace>& places, CellPlace origin) const;

private:
    [[nodiscard]] TileCell stampCell(CellPlace place, CellPlace origin) const;
    [[nodiscard]] TileCell randomCell(CellPlace place) const;
    [[nodiscard]] PaintTiles::Change stamped(const std::vector<CellPlace>& places, CellPlace origin) const;
    [[nodiscard]] PaintTiles::Change erased(const std::vector<CellPlace>& places) const;
    [[nodiscard]] PaintTiles::Change withTerrain(const std::vector<PaintTiles::Cell>& wanted) const;
    void makeTerrain(ObjectId layer, DerivedTerrain* derived);

    const TilePaint& paint_;
    const Tileset* tileset_;
    const TileGrid* grid_;
    const TileGrid* terrain_;
    std::shared_ptr<TileGrid> newTerrain_;
    TileInk ink_;
    std::uint32_t seed_;
    int id_ = 0;  // id of the painted terrain
    std::unique_ptr<Autotile> autotile_;
    double weights_ = 0.0;  // sum of the probabilities of the stamp's tiles
};

/// Returns the tileset's terrain selected for painting, or its first one; null if the tileset has no terrain.
const Terrain* activeTerrain(const Tileset& tileset, const TilePaint& paint);

}  // namespace plumb::editor
