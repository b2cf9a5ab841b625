#pragma once

#include <vector>

#include "math/rect.hpp"
#include "platform/image.hpp"

namespace plumb::editor {

/// Returns the boxes (px) around the connected shapes of an image, row by row from the top left. Nearly
/// transparent pixels count as empty; diagonal neighbors are connected.
/// @param smallest  minimum width and height, px; smaller shapes are ignored
std::vector<Rect> shapesIn(const Image& image, int smallest = 2);

/// Cell size of a sprite sheet.
struct CellSize {
    int width = 0;   ///< px
    int height = 0;  ///< px
    friend bool operator==(CellSize, CellSize) = default;
};
/// Returns the smallest cell size that divides the image evenly and cuts through no shape; {0, 0} if only the
/// whole image does.
CellSize guessCells(const Image& image);

/// True if a cell of a sheet is not empty.
bool hasContent(const Image& image, const Rect& cell);

}  // namespace plumb::editor
