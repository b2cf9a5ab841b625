#include "scene/files/rough_text.hpp"

#include <algorithm>

namespace plumb {

AABB roughTextBox(const World& world, const Label& label) {
    const auto letters = static_cast<float>(world.texts().find(label.text).size());
    const Vec2 size{std::max(letters, 1.0f) * label.size * 0.6f, label.size * 1.3f};
    const float shift = label.align == LabelAlign::Center  ? 0.5f
                        : label.align == LabelAlign::Right ? 1.0f
                                                           : 0.0f;
    const Vec2 from{-shift * size.x, 0.0f};
    return {from, from + size};
}

}  // namespace plumb
