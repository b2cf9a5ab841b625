#pragma once

#include <string_view>

#include "core/result.hpp"
#include "render/font_bytes.hpp"

namespace plumb {

/// The tables of a TrueType or OpenType file, and readers for
/// all glyph data except outlines. All lengths are in font units.
struct FontTables {
    FontBytes cmap;  ///< the subtable used to map characters to glyphs
    FontBytes hmtx;
    FontBytes kern;
    FontBytes gpos;
    FontBytes loca;  ///< offsets of the quadratic outlines in glyf
    FontBytes glyf;
    FontBytes cff;  ///< cubic outlines
    int glyphs = 0;
    int unitsPerEm = 1000;
    int ascent = 0;
    int descent = 0;
    int lineGap = 0;
    int advances = 0;          ///< number of glyphs with their own advance; the others use the last one
    bool longOffsets = false;  ///< offsets in loca have 32 bits instead of 16

    /// @param bytes must outlive the result
    /// @param where the file's path, for the error
    static Result<FontTables> read(std::string_view bytes, std::string_view where);

    /// Returns the glyph of a character; 0 if the font does not have it.
    [[nodiscard]] int glyphOf(char32_t codepoint) const;
    [[nodiscard]] int advance(int glyph) const;
    [[nodiscard]] int kerning(int left, int right) const;
};

}  // namespace plumb
