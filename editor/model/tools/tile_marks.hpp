#pragma once

#include "editor/model/document/cell_selection.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "editor/model/tools/tool.hpp"

namespace plumb::editor::marks {

// Marks that the tile tools draw over the scene.

inline constexpr Color kCursor{77, 163, 255, 255};
inline constexpr Color kWords{255, 255, 255, 255};  ///< text, readable on tiles of any color
inline constexpr Color kCursorFill{77, 163, 255, 50};
inline constexpr Color kErase{240, 104, 104, 255};
inline constexpr Color kEraseFill{240, 104, 104, 50};
inline constexpr Color kPick{255, 221, 87, 255};  ///< box of tiles to pick as the new stamp
inline constexpr Color kPickFill{255, 221, 87, 40};
inline constexpr Color kGhost{255, 255, 255, 190};  ///< tint of previewed tiles
inline constexpr Color kLayer{226, 164, 96, 150};   ///< border of the layer
inline constexpr Color kSelected{120, 230, 160, 255};
inline constexpr Color kSelectedFill{120, 230, 160, 45};

/// Draws the border of the layer, its selected cells and, if the layer cannot be painted, a text with the
/// reason.
void drawLayer(const ToolContext& context, ObjectId layer, Overlay& overlay);
/// Draws the selected cells.
void drawSelection(const ToolContext& context, ObjectId layer, Overlay& overlay);
/// Draws cells filled, with a border around each connected group. Draws only a part if there are very many
/// cells.
void drawCells(const Document& document, ObjectId layer, const CellSelection& cells, Color fill, Color line,
               Overlay& overlay);
/// Draws the number of columns and rows, e.g. "12 x 5", at a box.
void drawSize(const AABB& box, CellPlace from, CellPlace to, Overlay& overlay);
/// Returns a box of the size of a cell, centered at the upper left corner of a cell.
AABB cornerBox(const Document& document, ObjectId layer, CellPlace corner);

}  // namespace plumb::editor::marks
