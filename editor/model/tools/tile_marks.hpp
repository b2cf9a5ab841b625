#pragma once

#include "editor/model/document/cell_selection.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "editor/model/tools/tool.hpp"

namespace plumb::editor::marks {

// What tile tools draw over the scene.

inline constexpr Color kCursor{77, 163, 255, 255};
inline constexpr Color kWords{255, 255, 255, 255};  ///< over tiles of any color
inline constexpr Color kCursorFill{77, 163, 255, 50};
inline constexpr Color kErase{240, 104, 104, 255};
inline constexpr Color kEraseFill{240, 104, 104, 50};
inline constexpr Color kPick{255, 221, 87, 255};
inline constexpr Color kPickFill{255, 221, 87, 40};
inline constexpr Color kGhost{255, 255, 255, 190};
inline constexpr Color kLayer{226, 164, 96, 150};
inline constexpr Color kSelected{120, 230, 160, 255};
inline constexpr Color kSelectedFill{120, 230, 160, 45};

/// The border of the layer, its selected cells, and what keeps one from painting on it.
void drawLayer(const ToolContext& context, ObjectId layer, Overlay& overlay);
void drawSelection(const ToolContext& context, ObjectId layer, Overlay& overlay);
/// Cells, filled, and a line around each group of them; of very many only the first ones.
void drawCells(const Document& document, ObjectId layer, const CellSelection& cells, Color fill, Color line,
               Overlay& overlay);
/// "12 x 5" beside a box.
void drawSize(const AABB& box, CellPlace from, CellPlace to, Overlay& overlay);
/// Half a cell around the upper left corner of a cell.
AABB cornerBox(const Document& document, ObjectId layer, CellPlace corner);

}  // namespace plumb::editor::marks
