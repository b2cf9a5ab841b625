#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "math/vec2.hpp"
#include "render/font.hpp"

namespace plumb {

enum class TextAlign : std::uint8_t { Left, Center, Right };

struct TextShape {
    float size = 8.0f;  ///< font size (em), px
    TextAlign align = TextAlign::Left;
    float wrapWidth = 0.0f;    ///< maximum line width, px; longer lines break between words. 0: no limit
    float lineSpacing = 1.0f;  ///< ratio to the font's line height
};

struct PlacedGlyph {
    int glyph = 0;
    /// Position on the base line, px from the text's top left, top middle or top right corner, depending on
    /// the alignment.
    Vec2 pen;
};

/// Positions of all glyphs of a text. Reuse it to avoid allocations.
struct TextLayout {
    std::vector<PlacedGlyph> glyphs;
    Vec2 size;  ///< px: width of the widest line, height of all lines
    int lines = 0;
};

/// Lays out UTF-8 text in lines. Invalid bytes are shown as the replacement character.
void layOutText(const Font& font, std::string_view text, const TextShape& shape, TextLayout& layout);

/// Removes the first character of UTF-8 text and returns it; U+FFFD for an invalid byte.
/// @pre !text.empty()
char32_t takeCodepoint(std::string_view& text);

}  // namespace plumb
