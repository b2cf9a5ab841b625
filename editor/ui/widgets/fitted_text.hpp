#pragma once

#include <string>

namespace plumb::editor::ui {

/// Shortens a text to a width by replacing its middle with "…", as beginning and end distinguish names best.
/// @param width  px
std::string fittedText(const std::string& text, float width);

/// Draws a text shortened to a width, px, in the current
/// text color; a shortened text has the full one as tooltip.
void fittedLine(const std::string& text, float width);

}  // namespace plumb::editor::ui
