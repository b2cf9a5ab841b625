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
    ImFont* strong = nullptr;  ///< for what differs from its default
    ImFont* mono = nullptr;
    ImFont* title = nullptr;  ///< large, for the name of the program
    float size = 15.0f;       ///< px
    float titleSize = 30.0f;  ///< px
};

/// Loads the fonts and sets colors and spacing for a scale of the whole interface.
/// @param fonts  the folder of the engine's fonts; without its files ImGui's own font is used
/// @param scale     ratio, 0.75..3
/// @param textSize  px at scale 1
Fonts applyTheme(const Path& fonts, Theme theme, float scale, float textSize = 14.0f);
/// The colors alone, of the ImGui context in use.
void applyColors(Theme theme);

/// The color as ImGui's style wants it.
ImVec4 colorOf(ImU32 color);

}  // namespace plumb::editor::ui
