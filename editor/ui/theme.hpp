#pragma once

#include <imgui.h>

#include "core/file.hpp"
#include "core/result.hpp"

namespace plumb::editor::ui {

/// The colors of the editor. One accent; everything else is calm grey.
namespace palette {
inline constexpr ImU32 kAccent = IM_COL32(77, 163, 255, 255);
inline constexpr ImU32 kAccentSoft = IM_COL32(77, 163, 255, 70);
inline constexpr ImU32 kPlay = IM_COL32(88, 201, 130, 255);
inline constexpr ImU32 kWarning = IM_COL32(240, 185, 74, 255);
inline constexpr ImU32 kError = IM_COL32(240, 104, 104, 255);
inline constexpr ImU32 kText = IM_COL32(221, 224, 229, 255);
inline constexpr ImU32 kTextDim = IM_COL32(139, 146, 158, 255);
inline constexpr ImU32 kChrome = IM_COL32(30, 32, 37, 255);  ///< bars around the panels
inline constexpr ImU32 kChromePlaying = IM_COL32(26, 58, 42, 255);
inline constexpr ImU32 kChromePaused = IM_COL32(66, 52, 26, 255);
inline constexpr ImU32 kPanel = IM_COL32(37, 40, 46, 255);   ///< the panels themselves
inline constexpr ImU32 kHeader = IM_COL32(45, 48, 56, 255);  ///< titles, component headers
inline constexpr ImU32 kField = IM_COL32(26, 28, 33, 255);   ///< where values are typed
inline constexpr ImU32 kLine = IM_COL32(20, 21, 25, 255);    ///< between panels
inline constexpr ImU32 kCanvas = IM_COL32(23, 24, 28, 255);  ///< behind the scene
}  // namespace palette

/// The fonts of the editor, rebuilt when the scale changes.
struct Fonts {
    ImFont* text = nullptr;
    ImFont* strong = nullptr;  ///< for what differs from its default
    ImFont* mono = nullptr;
    float size = 15.0f;  ///< px
};

/// Loads the fonts and sets colors and spacing for a scale of the whole interface.
/// @param fonts  the folder of the engine's fonts; without its files ImGui's own font is used
/// @param scale  ratio, 0.75..3
Fonts applyTheme(const Path& fonts, float scale);

/// The color as ImGui's style wants it.
ImVec4 colorOf(ImU32 color);

}  // namespace plumb::editor::ui
