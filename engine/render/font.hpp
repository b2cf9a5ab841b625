#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "platform/image.hpp"

namespace plumb {

/// The glyphs of a TrueType or OpenType file. All measures are for a size of 1 px: multiply by the size.
class Font {
public:
    /// @param where  the file, for the error
    /// @error        not a font
    static Result<Font> fromBytes(std::string bytes, const std::string& where);
    ~Font();
    Font(Font&&) noexcept;
    Font& operator=(Font&&) noexcept;

    /// A glyph rasterized at one size.
    struct Glyph {
        Image image;   ///< white, opacity is coverage; empty for a space
        int left = 0;  ///< px from the pen to the picture
        int top = 0;   ///< px from the base line to the picture, negative is up
    };

    [[nodiscard]] int glyphOf(char32_t codepoint) const;  ///< 0 for characters that the font does not have
    [[nodiscard]] float advance(int glyph) const;
    [[nodiscard]] float kerning(int left, int right) const;
    [[nodiscard]] float ascent() const;      ///< base line to the top of a line
    [[nodiscard]] float lineHeight() const;  ///< base line to base line

    /// True if all outlines are axis-aligned: drawn without smoothing, at its own size, in large pixels.
    [[nodiscard]] bool isPixelFont() const;
    /// @param size  px
    [[nodiscard]] Glyph draw(int glyph, int size) const;
    /// Unique id of a font; unchanged when it is moved.
    [[nodiscard]] std::uint32_t id() const;

private:
    struct Parts;
    explicit Font(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

}  // namespace plumb
