#include "render/font.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb_truetype.h>

namespace plumb {
namespace {

constexpr char32_t kCommonLetters = 128;
constexpr std::uint8_t kHalfCovered = 128;

/// True when no outline of the letter has a slanted or bent edge. One outline says it for the whole font.
bool hasOnlyStraightEdges(const stbtt_fontinfo& font, int codepoint) {
    stbtt_vertex* edges = nullptr;
    const int count = stbtt_GetCodepointShape(&font, codepoint, &edges);
    bool straight = count > 0;
    for (int i = 1; i < count; ++i) {
        const stbtt_vertex& edge = edges[i];
        if (edge.type == STBTT_vmove) continue;
        straight =
            straight && edge.type == STBTT_vline && (edge.x == edges[i - 1].x || edge.y == edges[i - 1].y);
    }
    stbtt_FreeShape(&font, edges);
    return straight;
}

std::uint32_t numberAt(std::string_view bytes, std::size_t at, std::size_t size) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < size; ++i) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
    return number;
}

/// True when the table of contents names nothing outside the file: stb_truetype trusts what it is given.
bool hasSoundContents(std::string_view bytes) {
    constexpr std::size_t kHeader = 12;
    constexpr std::size_t kRecord = 16;
    if (bytes.size() < kHeader) return false;
    const std::size_t tables = numberAt(bytes, 4, 2);
    if (tables == 0 || bytes.size() < kHeader + tables * kRecord) return false;
    for (std::size_t i = 0; i < tables; ++i) {
        const std::size_t record = kHeader + i * kRecord;
        const std::size_t end = std::size_t{numberAt(bytes, record + 8, 4)} + numberAt(bytes, record + 12, 4);
        if (end > bytes.size()) return false;
    }
    return true;
}

}  // namespace

struct Font::Parts {
    std::string bytes;
    stbtt_fontinfo info{};
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
    const auto* data = reinterpret_cast<const unsigned char*>(parts->bytes.data());
    const int offset = hasSoundContents(parts->bytes) ? stbtt_GetFontOffsetForIndex(data, 0) : -1;
    if (offset < 0 || stbtt_InitFont(&parts->info, data, offset) == 0) {
        return Error{where, "not a TrueType or OpenType font", "use a .ttf or .otf file"};
    }
    int ascent = 0;
    int descent = 0;
    int gap = 0;
    stbtt_GetFontVMetrics(&parts->info, &ascent, &descent, &gap);
    parts->scale = stbtt_ScaleForMappingEmToPixels(&parts->info, 1.0f);
    parts->ascent = static_cast<float>(ascent) * parts->scale;
    parts->lineHeight = std::max(static_cast<float>(ascent - descent + gap) * parts->scale, 1.0f);
    parts->pixelFont = hasOnlyStraightEdges(parts->info, 'A') && hasOnlyStraightEdges(parts->info, 'O');
    for (char32_t letter = 0; letter < kCommonLetters; ++letter) {
        parts->commonGlyphs[letter] = stbtt_FindGlyphIndex(&parts->info, static_cast<int>(letter));
    }
    static std::atomic<std::uint32_t> lastId{0};
    parts->id = ++lastId;
    return Font{std::move(parts)};
}

int Font::glyphOf(char32_t codepoint) const {
    if (codepoint < kCommonLetters) return parts_->commonGlyphs[codepoint];
    return stbtt_FindGlyphIndex(&parts_->info, static_cast<int>(codepoint));
}

float Font::advance(int glyph) const {
    int width = 0;
    stbtt_GetGlyphHMetrics(&parts_->info, glyph, &width, nullptr);
    return static_cast<float>(width) * parts_->scale;
}

float Font::kerning(int left, int right) const {
    if (parts_->pixelFont) return 0.0f;  // letters stay on their grid
    return static_cast<float>(stbtt_GetGlyphKernAdvance(&parts_->info, left, right)) * parts_->scale;
}

float Font::ascent() const { return parts_->ascent; }
float Font::lineHeight() const { return parts_->lineHeight; }
bool Font::isPixelFont() const { return parts_->pixelFont; }
std::uint32_t Font::id() const { return parts_->id; }

Font::Glyph Font::draw(int glyph, int size) const {
    const float scale = parts_->scale * static_cast<float>(size);
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;
    stbtt_GetGlyphBitmapBox(&parts_->info, glyph, scale, scale, &left, &top, &right, &bottom);
    Glyph drawn;
    drawn.left = left;
    drawn.top = top;
    if (right <= left || bottom <= top) return drawn;
    const auto width = static_cast<std::size_t>(right - left);
    const auto height = static_cast<std::size_t>(bottom - top);
    std::vector<std::uint8_t> coverage(width * height);
    stbtt_MakeGlyphBitmap(&parts_->info, coverage.data(), right - left, bottom - top, right - left, scale,
                          scale, glyph);
    drawn.image = {right - left, bottom - top, {}};
    drawn.image.rgba.reserve(coverage.size() * 4);
    for (std::uint8_t covered : coverage) {
        if (parts_->pixelFont) covered = covered >= kHalfCovered ? 255 : 0;
        drawn.image.rgba.insert(drawn.image.rgba.end(), {255, 255, 255, covered});
    }
    return drawn;
}

}  // namespace plumb
