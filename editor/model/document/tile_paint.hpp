#pragma once

#include <array>
#include <optional>

#include "editor/model/document/cell_selection.hpp"
#include "editor/model/document/object_id.hpp"
#include "editor/model/document/tile_stamp.hpp"

namespace plumb::editor {

/// What the tile tools share.
struct TilePaint {
    static constexpr std::size_t kKept = 9;

    TileStamp stamp;
    ObjectId layer;              ///< the one that was worked on last
    bool random = false;         ///< each cell takes any tile of the stamp, by their probabilities
    bool terrainInHand = false;  ///< what is painted: the terrain, or the stamp
    int terrain = 0;             ///< id in the tileset; one that it lacks stands for its first
    bool rightErases = false;    ///< what the right button does: else it takes a stamp from the layer
    std::array<std::optional<TileStamp>, kKept> kept;
    CellSelection selected;
};

}  // namespace plumb::editor
