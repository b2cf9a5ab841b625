#include "render/text_layout.hpp"

#include <algorithm>

namespace plumb {
namespace {

constexpr char32_t kReplacement = 0xfffd;

/// Appends characters to a TextLayout and breaks lines.
class LineBreaker {
public:
    LineBreaker(const Font& font, const TextShape& shape, TextLayout& layout)
        : font_{font}, shape_{shape}, layout_{layout}, baseline_{font.ascent() * shape.size} {}

    void add(char32_t letter) {
        if (letter == U'\n') return endLine(layout_.glyphs.size());
        const int glyph = font_.glyphOf(letter);
        const float width = font_.advance(glyph) * shape_.size;
        const float kerning = before_ > 0 ? font_.kerning(before_, glyph) * shape_.size : 0.0f;
        if (letter == U' ') {
            // A space may extend beyond the wrap width, because lines break after it.
            wordStart_ = layout_.glyphs.size();
            widthAtBreak_ = pen_;
            pen_ += kerning + width;
            wordPen_ = pen_;
        } else {
            if (shape_.wrapWidth > 0.0f && pen_ + kerning + width > shape_.wrapWidth) breakLine();
            layout_.glyphs.push_back({glyph, {pen_ + kerning, baseline_}});
            pen_ += kerning + width;
        }
        before_ = glyph;
    }

    void endLine(std::size_t end) {
        endLineAt(end, pen_);
        pen_ = 0.0f;
        before_ = 0;
        wordStart_ = lineStart_;
        wordPen_ = 0.0f;
    }

private:
    /// Moves the last word, which does not fit, to a new line; splits it if it is the only word of its line.
    void breakLine() {
        if (wordPen_ <= 0.0f) {
            if (layout_.glyphs.size() > lineStart_) endLine(layout_.glyphs.size());
            return;
        }
        const float taken = wordPen_;
        endLineAt(wordStart_, widthAtBreak_);
        for (std::size_t i = wordStart_; i < layout_.glyphs.size(); ++i) {
            layout_.glyphs[i].pen = {layout_.glyphs[i].pen.x - taken, baseline_};
        }
        pen_ -= taken;
        wordPen_ = 0.0f;
    }

    void endLineAt(std::size_t end, float width) {
        const float shift = shape_.align == TextAlign::Center  ? -width * 0.5f
                            : shape_.align == TextAlign::Right ? -width
                                                               : 0.0f;
        for (std::size_t i = lineStart_; i < end; ++i) layout_.glyphs[i].pen.x += shift;
        layout_.size.x = std::max(layout_.size.x, width);
        layout_.size.y += font_.lineHeight() * shape_.size * shape_.lineSpacing;
        ++layout_.lines;
        baseline_ += font_.lineHeight() * shape_.size * shape_.lineSpacing;
        lineStart_ = end;
    }

    const Font& font_;
    const TextShape& shape_;
    TextLayout& layout_;
    float baseline_;
    float pen_ = 0.0f;
    float wordPen_ = 0.0f;  ///< x of the last word's start, px; 0 if it is the first word of its line
    float widthAtBreak_ = 0.0f;
    std::size_t lineStart_ = 0;
    std::size_t wordStart_ = 0;
    int before_ = 0;
};

}  // namespace

char32_t takeCodepoint(std::string_view& text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    const std::size_t length = first < 0x80   ? 1
                               : first < 0xc2 ? 0
                               : first < 0xe0 ? 2
                               : first < 0xf0 ? 3
                               : first < 0xf5 ? 4
                                              : 0;
    bool whole = length > 0 && length <= text.size();
    char32_t letter = length <= 1 ? first : first & (0x7fu >> length);
    for (std::size_t i = 1; whole && i < length; ++i) {
        whole = (byte(i) & 0xc0) == 0x80;
        letter = letter << 6 | (byte(i) & 0x3fu);
    }
    text.remove_prefix(whole ? length : 1);
    return whole ? letter : kReplacement;
}

void layOutText(const Font& font, std::string_view text, const TextShape& shape, TextLayout& layout) {
    layout.glyphs.clear();
    layout.size = {};
    layout.lines = 0;
    if (text.empty()) return;
    LineBreaker lines{font, shape, layout};
    while (!text.empty()) {
        const char32_t letter = takeCodepoint(text);
        if (letter != U'\r') lines.add(letter);
    }
    lines.endLine(layout.glyphs.size());
}

}  // namespace plumb
