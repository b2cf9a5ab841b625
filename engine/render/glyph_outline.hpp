#pragma once

#include <cstdint>
#include <vector>

#include "render/font_tables.hpp"

namespace plumb {

/// A segment of the outline of a glyph, in font units, y up.
struct OutlineStep {
    enum class Kind : std::uint8_t { Move, Line, Quadratic, Cubic } kind;
    std::int16_t x, y;
    std::int16_t cx = 0, cy = 0;    ///< the first control point
    std::int16_t cx1 = 0, cy1 = 0;  ///< the second one of a cubic
};

struct GlyphOutline {
    /// Real glyphs have fewer; a damaged file may contain any number.
    static constexpr std::size_t kMaxSteps = std::size_t{1} << 16;

    std::vector<OutlineStep> steps;
    int left = 0;
    int bottom = 0;
    int right = 0;
    int top = 0;
};

/// The outline of a glyph: quadratic curves from "glyf", or cubic ones from "CFF ".
/// @return false if the data is damaged; a glyph without an outline, such as the space, is empty
bool readOutline(const FontTables& tables, int glyph, GlyphOutline& outline);

/// Readers of the two formats; use `readOutline`.
bool readGlyfOutline(const FontTables& tables, int glyph, GlyphOutline& outline);
bool readCffOutline(FontBytes cff, int glyph, GlyphOutline& outline);

}  // namespace plumb
