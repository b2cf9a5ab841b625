#pragma once

#include <algorithm>

#include "editor/ui/theme_colors.hpp"
#include "math/color.hpp"

namespace plumb::editor::ui {

inline constexpr float kFaintLine = 128.0f;  ///< alpha (0 to 255) below which a line counts as faint

/// Returns the color of the dark halo of an overlay line. Lines are light; the halo makes them visible on
/// light scenes. Faint lines have a fainter halo, the grid almost none. Returns 0 for black: no halo.
inline ImU32 edgeOf(Color line) {
    if (line.r + line.g + line.b == 0) return 0;
    const ImU32 edge = palette::kHalo.dark;  // equal in both themes
    const float strength = std::min(static_cast<float>(line.a) / kFaintLine, 1.0f);
    const float alpha = static_cast<float>(edge >> IM_COL32_A_SHIFT & 0xff) * strength * strength;
    return (edge & ~IM_COL32_A_MASK) | static_cast<ImU32>(alpha) << IM_COL32_A_SHIFT;
}

}  // namespace plumb::editor::ui
