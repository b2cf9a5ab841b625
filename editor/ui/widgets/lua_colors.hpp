#pragma once

#include <string_view>
#include <vector>

#include <imgui.h>

namespace plumb::editor::ui {

/// A part of a line of Lua in one color.
struct ColoredPart {
    std::string_view text;
    ImU32 color = 0;
};

/// Splits a line of Lua into comments, texts, numbers, keywords and the rest.
/// @param inLong  the line begins inside a comment or text in [[double brackets]]; receives if the next does.
///                1: in a comment, 2: in a text, 0: in none
std::vector<ColoredPart> luaColors(std::string_view line, int& inLong);

}  // namespace plumb::editor::ui
