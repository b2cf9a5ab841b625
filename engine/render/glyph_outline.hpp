#pragma once

#include <cstdint>
#include <vector>

#include "render/font_tables.hpp"

namespace plumb {

/// A segment of the outline of a glyph, in font units, y up.
struct OutlineStep {
    enum class Kind : std::uint8_t { Move, Line, Quadratic, Cubic } kind;
    std::int16_t x, y;
    std::int16_t cx = 0, cy = 0;    ///< first control point of a curve
    std::int16_t cx1 = 0, cy1 = 0;  ///< second control point of a cubic curve
};

struct GlyphOutline {
    /// Maximum number of steps, since a damaged file may contain any number; real glyphs have fewer.
    static constexpr std::size_t kMaxSteps = std::size_t{1} << 16;

    std::vector<OutlineStep> steps;
    int left = 0;  ///< left, bottom, right, top: bounding box of all points, font units
    int bottom = 0;
    int right = 0;
    int top = 0;
};

/// Reads the outline of a glyph: quadratic curves from "glyf", or cubic ones from "CFF ".
/// @return false if the data is damaged; a glyph without an outline, such as the space, is empty
bool readOutline(const FontTables& tables, int glyph, GlyphOutline& outline);

/// Readers of the two formats; use `readOutline`.
bool readGlyfOutline(const FontTables& tables, int glyph, GlyphOutline& outline);
bool readCffOutline(FontBytes cff, int glyph, GlyphOutline& outline);

}  // namespace plumb
