#pragma once

#include <string_view>

#include "core/result.hpp"
#include "render/font_bytes.hpp"

namespace plumb {

/// The tables of a TrueType or OpenType file, and the glyph
/// data except outlines. All measures are in font units.
struct FontTables {
    FontBytes cmap;  ///< the subtable that is used
    FontBytes hmtx;
    FontBytes kern;
    FontBytes gpos;
    FontBytes loca;  ///< with glyf: quadratic outlines
    FontBytes glyf;
    FontBytes cff;  ///< cubic outlines
    int glyphs = 0;
    int unitsPerEm = 1000;
    int ascent = 0;
    int descent = 0;
    int lineGap = 0;
    int advances = 0;          ///< number of glyphs with their own advance; the others use the last one
    bool longOffsets = false;  ///< of loca

    /// @param bytes must outlive the result
    /// @param where the file, for the error
    static Result<FontTables> read(std::string_view bytes, std::string_view where);

    /// 0 for characters that the font does not have.
    [[nodiscard]] int glyphOf(char32_t codepoint) const;
    [[nodiscard]] int advance(int glyph) const;
    [[nodiscard]] int kerning(int left, int right) const;
};

}  // namespace plumb
