#pragma once

#include <imgui.h>

#include "core/file.hpp"
#include "core/result.hpp"
#include "editor/model/project/settings.hpp"
#include "editor/ui/theme_colors.hpp"

namespace plumb::editor::ui {

/// The fonts of the editor, rebuilt when the scale changes.
struct Fonts {
    ImFont* text = nullptr;
    ImFont* strong = nullptr;  ///< bold, e.g. for values that differ from their default
    ImFont* mono = nullptr;
    ImFont* title = nullptr;  ///< large, for the name of the program
    float size = 15.0f;       ///< px: size of `text`, `strong` and `mono`
    float titleSize = 30.0f;  ///< px: size of `title`
};

/// Loads the fonts and sets colors and spacing.
/// @param fonts     folder of the engine's fonts; without its files ImGui's own font is used
/// @param scale     scale of the user interface, 0.75..3
/// @param textSize  text size, px at scale 1
Fonts applyTheme(const Path& fonts, Theme theme, float scale, float textSize = 14.0f);
/// Sets only the colors, in the current ImGui context.
void applyColors(Theme theme);

/// Converts a color to the format of ImGui's style.
ImVec4 colorOf(ImU32 color);

}  // namespace plumb::editor::ui
