#pragma once

#include "app/options/options_menu.hpp"
#include "render/draw_list.hpp"
#include "scene/drawing/label_drawing.hpp"

namespace plumb {

/// Size of the screen in px of the menu: at least 640x360 for a window of that shape or larger.
/// @param window  px, size of the window's drawable area
Vec2 optionsScreen(PixelSize window);

/// Adds the menu to a list whose view has the size optionsScreen().
void drawOptions(const OptionsMenu& menu, LabelDrawing& labels, DrawList& list);

/// Adds a message at the top of the screen, e.g. that saving has failed.
void drawNotice(std::string_view text, LabelDrawing& labels, DrawList& list);

}  // namespace plumb
