#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "math/vec2.hpp"
#include "render/font.hpp"

namespace plumb {

enum class TextAlign : std::uint8_t { Left, Center, Right };

struct TextShape {
    float size = 8.0f;  ///< px, of the font's em
    TextAlign align = TextAlign::Left;
    float wrapWidth = 0.0f;    ///< px; longer lines break between words. 0 never breaks
    float lineSpacing = 1.0f;  ///< ratio of the font's own
};

struct PlacedGlyph {
    int glyph = 0;
    Vec2 pen;  ///< px from the text's top left (Left), top middle (Center) or top right (Right); on the base
               ///< line
};

/// The positions of all glyphs of a text. Reuse it to avoid allocations.
struct TextLayout {
    std::vector<PlacedGlyph> glyphs;
    Vec2 size;  ///< px: the widest line, all lines
    int lines = 0;
};

/// Lays out UTF-8 text in lines. Invalid bytes are shown as the replacement character.
void layOutText(const Font& font, std::string_view text, const TextShape& shape, TextLayout& layout);

/// Removes the next character from the front of UTF-8 text; U+FFFD for invalid bytes.
/// @pre !text.empty()
char32_t takeCodepoint(std::string_view& text);

}  // namespace plumb
