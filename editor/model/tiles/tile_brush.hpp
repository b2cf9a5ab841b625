#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "editor/model/document/cell_selection.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "editor/model/tiles/terrain_paint.hpp"

namespace plumb::editor {

/// What one stroke paints, whatever its shape.
enum class TileInk : unsigned char { Stamp, Terrain, Nothing };

/// The terrain of a layer that was painted by hand, read from its tiles once for each state that they are in.
class DerivedTerrain {
public:
    std::shared_ptr<TileGrid> of(ObjectId layer, const TileGrid& cells, const Tileset& tileset);

private:
    ObjectId layer_;
    std::uint32_t version_ = 0;
    std::vector<Terrain> terrains_;
    std::shared_ptr<TileGrid> terrain_;
};

/// Turns the places that a tool goes over into what changes there: tiles of the stamp, terrain, or nothing.
class TileBrush {
public:
    /// @param seed     of random tiles: another one for each stroke
    /// @param derived  keeps what is costly from one brush to the next; needed for terrain
    TileBrush(const Document& document, const TilePaint& paint, ObjectId layer, TileInk ink,
              std::uint32_t seed, DerivedTerrain* derived = nullptr);

    /// Whether there is a layer to paint on.
    [[nodiscard]] bool ready() const { return grid_ != nullptr; }
    [[nodiscard]] const TileGrid& grid() const { return *grid_; }
    /// What counts beside tiles when equal cells are looked for; null when tiles alone do.
    [[nodiscard]] const TileGrid* equalTerrain() const {
        return ink_ == TileInk::Terrain ? terrain_ : nullptr;
    }
    [[nodiscard]] bool onCorners() const;

    /// The places that the brush covers with its corner at `at`.
    [[nodiscard]] std::vector<CellPlace> coveredAt(CellPlace at) const;
    /// @param origin  where the pattern of the stamp begins
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
    int id_ = 0;
    std::unique_ptr<Autotile> autotile_;
    double weights_ = 0.0;
};

/// The terrain in hand, of those that the tileset has; null when it has none.
const Terrain* terrainInHand(const Tileset& tileset, const TilePaint& paint);

}  // namespace plumb::editor
