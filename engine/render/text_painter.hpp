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
    Color outline{0, 0, 0, 0};      ///< one px around every glyph; drawn if not transparent
    Color shadow{0, 0, 0, 0};       ///< drawn if not transparent
    Vec2 shadowOffset{1.0f, 1.0f};  ///< px
    int layer = 0;
};

/// Adds text to draw lists. Glyphs are rasterized once for each size and stay on the graphics card.
class TextPainter {
public:
    explicit TextPainter(RenderDevice& device)
        : pixelLetters_{device, TextureFilter::Nearest}, smoothLetters_{device, TextureFilter::Linear} {}

    /// Window px per px of the picture: fonts other than pixel fonts are rasterized at this resolution.
    void setPixelScale(float scale) { pixelScale_ = scale; }

    /// @param position  px, world: top left, top middle or top right, by the alignment
    /// @return          px: the size of the text
    Vec2 draw(DrawList& list, const Font& font, std::string_view text, Vec2 position, const TextStyle& style);

    /// The size that draw() would return (px).
    Vec2 measure(const Font& font, std::string_view text, const TextShape& shape);

private:
    struct Letter {
        std::uint64_t key = 0;  ///< font, glyph and size
        TextureRegion region;
        Vec2 offset;  ///< px of the drawn size: pen to top left
    };

    [[nodiscard]] int drawnSize(const DrawList& list, const Font& font, float size) const;
    const Letter& letterOf(const Font& font, int glyph, int size);
    void growTable();
    void drawPass(DrawList& list, const Font& font, Vec2 position, const TextStyle& style, Color color);

    TextureAtlas pixelLetters_;
    TextureAtlas smoothLetters_;
    std::vector<Letter> letters_;  ///< open addressing, a power of two, at most half full
    std::size_t letterCount_ = 0;
    TextLayout layout_;
    float pixelScale_ = 1.0f;
};

}  // namespace plumb
