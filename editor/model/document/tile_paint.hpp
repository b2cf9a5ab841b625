#pragma once

#include <array>
#include <optional>

#include "editor/model/document/cell_selection.hpp"
#include "editor/model/document/object_id.hpp"
#include "editor/model/document/tile_stamp.hpp"

namespace plumb::editor {

/// State shared by the tile tools.
struct TilePaint {
    static constexpr std::size_t kKept = 9;  ///< length of `kept`

    TileStamp stamp;             ///< tile or pattern that is painted
    ObjectId layer;              ///< tile layer edited last
    bool random = false;         ///< paint each cell with a random tile of the stamp, weighted by probability
    bool activeTerrain = false;  ///< true: tools paint terrain, false: the stamp
    int terrain = 0;             ///< terrain id in the tileset; if missing there, its first terrain is used
    bool rightErases = false;    ///< true: the right button erases, false: it picks a stamp from the layer
    std::array<std::optional<TileStamp>, kKept> kept;  ///< patterns stored by the user; nullopt: empty
    CellSelection selected;                            ///< selected cells of the active tile layer
};

}  // namespace plumb::editor
