#include "render/font.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "render/glyph_outline.hpp"

// Only the rasterizer of stb_truetype is used, because its file readers do not check for damaged
// files. Its assertions can fail by rounding, but it never writes outside the image.
#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#define STBTT_assert(condition) static_cast<void>(0)
#include <stb_truetype.h>

namespace plumb {
namespace {

constexpr char32_t kCommonLetters = 128;
constexpr char32_t kFirstShown = 32;
constexpr std::uint8_t kHalfCovered = 128;
/// em^2: maximum area of a glyph's image, about five times the widest ligature of Unicode (12 by 1)
constexpr double kLargestLetter = 64.0;
constexpr float kFlatness = 0.35f;  // px: maximum distance between a curve and its line segments

/// True if the glyph has edges and all of them are horizontal or vertical.
bool hasOnlyStraightEdges(const GlyphOutline& outline) {
    for (std::size_t i = 1; i < outline.steps.size(); ++i) {
        const OutlineStep& step = outline.steps[i];
        const OutlineStep& last = outline.steps[i - 1];
        if (step.kind != OutlineStep::Kind::Move &&
            (step.kind != OutlineStep::Kind::Line || (step.x != last.x && step.y != last.y)))
            return false;
    }
    return !outline.steps.empty();
}

std::vector<stbtt_vertex> verticesOf(const GlyphOutline& outline) {
    static constexpr std::array kTypes{STBTT_vmove, STBTT_vline, STBTT_vcurve, STBTT_vcubic};
    std::vector<stbtt_vertex> vertices;
    vertices.reserve(outline.steps.size());
    for (const OutlineStep& step : outline.steps) {
        const auto type = static_cast<unsigned char>(kTypes[static_cast<std::size_t>(step.kind)]);
        vertices.push_back({step.x, step.y, step.cx, step.cy, step.cx1, step.cy1, type, 0});
    }
    return vertices;
}

}  // namespace

struct Font::Parts {
    std::string bytes;
    FontTables tables;
    std::uint32_t id = 0;
    float scale = 1.0f;  ///< font units to a size of 1 px
    float ascent = 1.0f;
    float lineHeight = 1.0f;
    bool pixelFont = false;
    std::array<int, kCommonLetters> commonGlyphs{};
};

Font::Font(std::unique_ptr<Parts> parts) : parts_{std::move(parts)} {}
Font::~Font() = default;
Font::Font(Font&&) noexcept = default;
Font& Font::operator=(Font&&) noexcept = default;

Result<Font> Font::fromBytes(std::string bytes, const std::string& where) {
    auto parts = std::make_unique<Parts>();
    parts->bytes = std::move(bytes);
    const Result<FontTables> tables = FontTables::read(parts->bytes, where);
    if (!tables) return tables.error();
    parts->tables = *tables;
    parts->scale = 1.0f / static_cast<float>(tables->unitsPerEm);
    parts->ascent = static_cast<float>(tables->ascent) * parts->scale;
    const int lineHeight = tables->ascent - tables->descent + tables->lineGap;
    parts->lineHeight = std::max(static_cast<float>(lineHeight) * parts->scale, 1.0f);
    parts->pixelFont = true;
    for (char32_t letter = 0; letter < kCommonLetters; ++letter) {
        const int glyph = parts->commonGlyphs[letter] = tables->glyphOf(letter);
        GlyphOutline outline;
        if (letter >= kFirstShown && !readOutline(*tables, glyph, outline)) {
            return Error{where, format("the outline of character {} is damaged", static_cast<int>(letter)),
                         "use another copy of the .ttf or .otf file"};
        }
        if (letter == U'A' || letter == U'O')
            parts->pixelFont = parts->pixelFont && hasOnlyStraightEdges(outline);
    }
    static std::atomic<std::uint32_t> lastId{0};
    parts->id = ++lastId;
    return Font{std::move(parts)};
}

int Font::glyphOf(char32_t codepoint) const {
    if (codepoint < kCommonLetters) return parts_->commonGlyphs[codepoint];
    return parts_->tables.glyphOf(codepoint);
}

float Font::advance(int glyph) const {
    return static_cast<float>(parts_->tables.advance(glyph)) * parts_->scale;
}

float Font::kerning(int left, int right) const {
    if (parts_->pixelFont) return 0.0f;  // glyphs stay on their grid
    return static_cast<float>(parts_->tables.kerning(left, right)) * parts_->scale;
}

float Font::ascent() const { return parts_->ascent; }
float Font::lineHeight() const { return parts_->lineHeight; }
bool Font::isPixelFont() const { return parts_->pixelFont; }
std::uint32_t Font::id() const { return parts_->id; }

Font::Glyph Font::draw(int glyph, int size) const {
    Glyph drawn;
    GlyphOutline outline;
    if (!readOutline(parts_->tables, glyph, outline)) return drawn;
    const float scale = parts_->scale * static_cast<float>(size);
    const auto below = [scale](int units) {
        return static_cast<int>(std::floor(static_cast<float>(units) * scale));
    };
    const auto above = [scale](int units) {
        return static_cast<int>(std::ceil(static_cast<float>(units) * scale));
    };
    drawn.left = below(outline.left);
    drawn.top = below(-outline.top);
    const int columns = above(outline.right) - drawn.left;
    const int rows = above(-outline.bottom) - drawn.top;
    const double area = static_cast<double>(columns) * rows;
    if (columns <= 0 || rows <= 0 || area > kLargestLetter * size * size) return drawn;
    std::vector<std::uint8_t> coverage(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    std::vector<stbtt_vertex> vertices = verticesOf(outline);
    stbtt__bitmap bitmap{columns, rows, columns, coverage.data()};
    stbtt_Rasterize(&bitmap, kFlatness, vertices.data(), static_cast<int>(vertices.size()), scale, scale,
                    0.0f, 0.0f, drawn.left, drawn.top, 1, nullptr);
    drawn.image = {columns, rows, {}};
    drawn.image.rgba.reserve(coverage.size() * 4);
    for (std::uint8_t covered : coverage) {
        if (parts_->pixelFont) covered = covered >= kHalfCovered ? 255 : 0;
        drawn.image.rgba.insert(drawn.image.rgba.end(), {255, 255, 255, covered});
    }
    return drawn;
}

}  // namespace plumb
