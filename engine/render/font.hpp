#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "platform/image.hpp"

namespace plumb {

/// A TrueType or OpenType font. All lengths are for a font size of 1 px: multiply them by the size.
class Font {
public:
    /// @param where  the file's path, for the error
    /// @error        not a font
    static Result<Font> fromBytes(std::string bytes, const std::string& where);
    ~Font();
    Font(Font&&) noexcept;
    Font& operator=(Font&&) noexcept;

    /// A glyph rasterized at one size.
    struct Glyph {
        Image image;   ///< white, opacity is coverage; empty for a space
        int left = 0;  ///< px from the pen to the image's left edge
        int top = 0;   ///< px from the base line to the image's top edge, negative is up
    };

    [[nodiscard]] int glyphOf(char32_t codepoint) const;  ///< 0 for characters that the font does not have
    [[nodiscard]] float advance(int glyph) const;
    [[nodiscard]] float kerning(int left, int right) const;
    [[nodiscard]] float ascent() const;      ///< distance from the base line up to the top of a line
    [[nodiscard]] float lineHeight() const;  ///< distance between two base lines

    /// True if all outlines are axis-aligned: such a font is drawn with large pixels, without smoothing.
    [[nodiscard]] bool isPixelFont() const;
    /// Rasterizes a glyph. @param size  font size, px
    [[nodiscard]] Glyph draw(int glyph, int size) const;
    /// Unique id of a font; unchanged when it is moved.
    [[nodiscard]] std::uint32_t id() const;

private:
    struct Parts;
    explicit Font(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

}  // namespace plumb
