#include "render/text_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/hash.hpp"

namespace plumb {
namespace {

constexpr int kSmallestSize = 4;
constexpr int kLargestSize = 160;
constexpr int kExactSizes = 48;
constexpr int kSizeStep = 8;

std::uint64_t keyOf(const Font& font, int glyph, int size) {
    // Never 0, which marks an unused entry, because font ids begin at 1.
    return std::uint64_t{font.id()} << 40 | static_cast<std::uint64_t>(glyph & 0xffff) << 16 |
           static_cast<std::uint64_t>(size);
}

Vec2 rounded(Vec2 v) { return {std::floor(v.x + 0.5f), std::floor(v.y + 0.5f)}; }

/// Adds a transparent border of one pixel, so that edges of glyphs are smooth at positions between pixels.
Image bordered(const Image& image) {
    Image wide{image.width + 2, image.height + 2, {}};
    wide.rgba.assign(static_cast<std::size_t>(wide.width) * static_cast<std::size_t>(wide.height) * 4, 255);
    for (std::size_t i = 3; i < wide.rgba.size(); i += 4) wide.rgba[i] = 0;
    for (int y = 0; y < image.height; ++y) {
        const auto from = image.rgba.begin() + static_cast<std::ptrdiff_t>(y) * image.width * 4;
        std::copy_n(from, image.width * 4,
                    wide.rgba.begin() + (static_cast<std::ptrdiff_t>(y + 1) * wide.width + 1) * 4);
    }
    return wide;
}

}  // namespace

/// Returns the size at which glyphs are rasterized, px. Pixel fonts are rasterized at their
/// font size and enlarged like sprites; other fonts at the resolution of the window.
int TextPainter::drawnSize(const DrawList& list, const Font& font, float size) const {
    const float shown = font.isPixelFont() ? size : size * list.view().zoom * pixelScale_;
    if (!(shown > static_cast<float>(kSmallestSize))) return kSmallestSize;
    if (shown >= static_cast<float>(kLargestSize)) return kLargestSize;
    const int whole = static_cast<int>(std::lround(shown));
    // A zooming camera needs many sizes: rasterize large glyphs only at multiples of 8 px and scale them.
    return whole <= kExactSizes ? whole : (whole + kSizeStep - 1) / kSizeStep * kSizeStep;
}

const TextPainter::Letter& TextPainter::letterOf(const Font& font, int glyph, int size) {
    if ((letterCount_ + 1) * 2 > letters_.size()) growTable();
    const std::uint64_t key = keyOf(font, glyph, size);
    std::size_t at = mixBits(key) & (letters_.size() - 1);
    while (letters_[at].key != 0) {
        if (letters_[at].key == key) return letters_[at];
        at = (at + 1) & (letters_.size() - 1);
    }
    const Font::Glyph drawn = font.draw(glyph, size);
    Letter& letter = letters_[at];
    letter.key = key;
    letter.offset = {static_cast<float>(drawn.left), static_cast<float>(drawn.top)};
    if (!drawn.image.empty() && font.isPixelFont()) {
        letter.region = pixelLetters_.add(drawn.image);
    } else if (!drawn.image.empty()) {
        letter.region = smoothLetters_.add(bordered(drawn.image));
        letter.offset -= {1.0f, 1.0f};
    }
    ++letterCount_;
    return letter;
}

void TextPainter::growTable() {
    std::vector<Letter> old(std::max<std::size_t>(256, letters_.size() * 2));
    old.swap(letters_);
    for (const Letter& letter : old) {
        if (letter.key == 0) continue;
        std::size_t at = mixBits(letter.key) & (letters_.size() - 1);
        while (letters_[at].key != 0) at = (at + 1) & (letters_.size() - 1);
        letters_[at] = letter;
    }
}

Vec2 TextPainter::draw(DrawList& list, const Font& font, std::string_view text, Vec2 position,
                       const TextStyle& style) {
    layOutText(font, text, style.shape, layout_);
    if (style.shadow.a > 0) drawPass(list, font, position + style.shadowOffset, style, style.shadow);
    if (style.outline.a > 0) {
        for (const Vec2 side : {Vec2{-1.0f, -1.0f}, Vec2{0.0f, -1.0f}, Vec2{1.0f, -1.0f}, Vec2{-1.0f, 0.0f},
                                Vec2{1.0f, 0.0f}, Vec2{-1.0f, 1.0f}, Vec2{0.0f, 1.0f}, Vec2{1.0f, 1.0f}}) {
            drawPass(list, font, position + side, style, style.outline);
        }
    }
    drawPass(list, font, position, style, style.color);
    return layout_.size;
}

void TextPainter::drawPass(DrawList& list, const Font& font, Vec2 position, const TextStyle& style,
                           Color color) {
    const int size = drawnSize(list, font, style.shape.size);
    const float toWorldPx = style.shape.size / static_cast<float>(size);
    // Align the text to window pixels and its glyphs to pixels at their
    // rasterized size, because otherwise they would be clipped or blurred.
    const float grid = std::max(list.view().zoom * pixelScale_, 1.0f);
    const Vec2 start = rounded(position * grid) / grid;
    for (const PlacedGlyph& placed : layout_.glyphs) {
        const Letter& letter = letterOf(font, placed.glyph, size);
        if (letter.region.width == 0) continue;
        const Vec2 corner = rounded(placed.pen / toWorldPx) + letter.offset;
        SpriteQuad quad;
        quad.half = Vec2{static_cast<float>(letter.region.width), static_cast<float>(letter.region.height)} *
                    (0.5f * toWorldPx);
        quad.center = start + corner * toWorldPx + quad.half;
        quad.texture = letter.region.texture;
        quad.source = letter.region.whole();
        quad.tint = color;
        quad.layer = style.layer;
        list.sprite(quad);
    }
}

Vec2 TextPainter::measure(const Font& font, std::string_view text, const TextShape& shape) {
    layOutText(font, text, shape, layout_);
    return layout_.size;
}

}  // namespace plumb
