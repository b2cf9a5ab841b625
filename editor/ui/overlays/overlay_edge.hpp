#pragma once

#include <algorithm>

#include "editor/ui/theme_colors.hpp"
#include "math/color.hpp"

namespace plumb::editor::ui {

inline constexpr float kFaintLine = 128.0f;  ///< alpha: what is fainter is meant to be looked through

/// The dark edge of a line over the scene. Lines are light, for dark scenes; by their edge they are seen on
/// light ones. Faint ones have a fainter one, and that of the grid is next to nothing; what is a shade itself
/// has none.
inline ImU32 edgeOf(Color line) {
    if (line.r + line.g + line.b == 0) return 0;
    const ImU32 edge = palette::kHalo.dark;  // the same in both themes
    const float strength = std::min(static_cast<float>(line.a) / kFaintLine, 1.0f);
    const float alpha = static_cast<float>(edge >> IM_COL32_A_SHIFT & 0xff) * strength * strength;
    return (edge & ~IM_COL32_A_MASK) | static_cast<ImU32>(alpha) << IM_COL32_A_SHIFT;
}

}  // namespace plumb::editor::ui
