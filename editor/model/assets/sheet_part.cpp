#include "editor/model/assets/sheet_part.hpp"

#include <algorithm>

namespace plumb::editor {
namespace {

constexpr float kLongest = 6.0f;  // times as long as wide: what is longer is a line in a square
constexpr float kShown = 2.0f;    // times: two cells of a strip of square ones

}  // namespace

Rect legiblePart(Vec2 size) {
    Vec2 part = size;
    if (size.x > size.y * kLongest) part.x = std::min(size.x, size.y * kShown);
    if (size.y > size.x * kLongest) part.y = std::min(size.y, size.x * kShown);
    return {0.0f, 0.0f, part.x, part.y};
}

}  // namespace plumb::editor
