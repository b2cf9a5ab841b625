#pragma once

#include <string>

namespace plumb::editor::ui {

/// As much of a text as a width holds, with "…" for what is left out in the middle: beginning and end are
/// what tells names apart. @param width  px
std::string fittedText(const std::string& text, float width);

/// A text in a width, in the color of the style; the whole of it is in the tooltip where it was cut.
void fittedLine(const std::string& text, float width);

}  // namespace plumb::editor::ui
