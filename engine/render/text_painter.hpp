#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "render/draw_list.hpp"
#include "render/font.hpp"
#include "render/text_layout.hpp"
#include "render/texture_atlas.hpp"

namespace plumb {

/// Style of a text.
struct TextStyle {
    TextShape shape;
    Color color;
    Color outline{0, 0, 0, 0};  ///< color of a border of one px around every glyph; transparent: no border
    Color shadow{0, 0, 0, 0};   ///< transparent: no shadow
    Vec2 shadowOffset{1.0f, 1.0f};  ///< px
    int layer = 0;
};

/// Adds text to draw lists. Glyphs are rasterized once per size and cached on the graphics card.
class TextPainter {
public:
    explicit TextPainter(RenderDevice& device)
        : pixelLetters_{device, TextureFilter::Nearest}, smoothLetters_{device, TextureFilter::Linear} {}

    /// Sets the number of window px per screen px, for rasterizing fonts that are not pixel fonts.
    void setPixelScale(float scale) { pixelScale_ = scale; }

    /// Adds a text to a list.
    /// @param position  top left, top middle or top right corner, depending on the alignment; px, world
    /// @return          size of the text, px
    Vec2 draw(DrawList& list, const Font& font, std::string_view text, Vec2 position, const TextStyle& style);

    /// Returns the size of a text, px, as draw() does.
    Vec2 measure(const Font& font, std::string_view text, const TextShape& shape);

private:
    struct Letter {
        std::uint64_t key = 0;  ///< combination of font, glyph and size; 0: unused
        TextureRegion region;
        Vec2 offset;  ///< from the pen to the image's top left, px at the rasterized size
    };

    [[nodiscard]] int drawnSize(const DrawList& list, const Font& font, float size) const;
    const Letter& letterOf(const Font& font, int glyph, int size);
    void growTable();
    void drawPass(DrawList& list, const Font& font, Vec2 position, const TextStyle& style, Color color);

    TextureAtlas pixelLetters_;
    TextureAtlas smoothLetters_;
    std::vector<Letter> letters_;  ///< hash table, open addressing: a power of two, at most half full
    std::size_t letterCount_ = 0;
    TextLayout layout_;
    float pixelScale_ = 1.0f;  ///< px of the target per px of the view at zoom 1
};

}  // namespace plumb
