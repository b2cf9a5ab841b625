#pragma once

#include <vector>

#include "math/rect.hpp"
#include "platform/image.hpp"

namespace plumb::editor {

/// The boxes around everything that hangs together in a picture (px), from the top left, row by row. Pixels
/// that are nearly transparent are nothing; corners hang together too.
/// @param smallest  px of both sides; what is smaller is dust
std::vector<Rect> shapesIn(const Image& image, int smallest = 2);

/// The size of the cells into which a sheet falls: the smallest that fills the picture evenly and cuts
/// through no shape. {0, 0} when there is none but the whole.
struct CellSize {
    int width = 0;  ///< px
    int height = 0;
    friend bool operator==(CellSize, CellSize) = default;
};
CellSize guessCells(const Image& image);

/// Whether a cell of a sheet has anything in it.
bool hasContent(const Image& image, const Rect& cell);

}  // namespace plumb::editor
