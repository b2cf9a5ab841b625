#include "editor/model/assets/sheet_part.hpp"

#include <algorithm>

namespace plumb::editor {
namespace {

constexpr float kLongest = 6.0f;  // maximum ratio of the sides shown whole; a longer strip would be too thin
constexpr float kShown = 2.0f;    // ratio of the sides of the part shown: two square cells of the strip

}  // namespace

Rect legiblePart(Vec2 size) {
    Vec2 part = size;
    if (size.x > size.y * kLongest) part.x = std::min(size.x, size.y * kShown);
    if (size.y > size.x * kLongest) part.y = std::min(size.y, size.x * kShown);
    return {0.0f, 0.0f, part.x, part.y};
}

}  // namespace plumb::editor
