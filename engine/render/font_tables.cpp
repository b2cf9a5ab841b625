#include "render/font_tables.hpp"

#include <array>
#include <bit>

#include "core/text.hpp"

namespace plumb {
namespace {

constexpr std::size_t kHeader = 12;
constexpr std::size_t kRecord = 16;
constexpr int kMinUnits = 16;  // per em, by the OpenType specification
constexpr int kMaxUnits = 16384;

Error notAFont(std::string_view where, std::string what) {
    return {std::string{where}, "not a TrueType or OpenType font: " + std::move(what),
            "use another copy of the .ttf or .otf file"};
}

// ---- from characters to glyphs

bool isKnownFormat(std::uint32_t format) {
    return format == 0 || format == 4 || format == 6 || format == 12 || format == 13;
}

/// Returns the last Unicode subtable of a supported format, because later ones contain more characters.
FontBytes unicodeTable(FontBytes cmap) {
    FontBytes found;
    const std::size_t count = std::min<std::size_t>(cmap.u16(2), cmap.size() / 8);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t record = 4 + i * 8;
        const std::uint32_t platform = cmap.u16(record);
        const std::uint32_t encoding = cmap.u16(record + 2);
        const bool isUnicode = platform == 0 || (platform == 3 && (encoding == 1 || encoding == 10));
        const FontBytes table = cmap.slice(cmap.u32(record + 4));
        if (isUnicode && !table.empty() && isKnownFormat(table.u16(0))) found = table;
    }
    return found;
}

/// Binary search. Returns the index of the first of `count` sorted items for which isBefore is false.
template <class IsBefore>
std::size_t firstNotBefore(std::size_t count, IsBefore isBefore) {
    std::size_t low = 0;
    std::size_t high = count;
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (isBefore(middle)) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

/// Reads format 4: ranges of characters, each with an offset from character to glyph or a list of glyphs.
std::uint32_t glyphInSegments(FontBytes map, std::uint32_t code) {
    const std::size_t segments = map.u16(6) / 2;
    const std::size_t ends = 14;
    const std::size_t starts = ends + segments * 2 + 2;
    const std::size_t deltas = starts + segments * 2;
    const std::size_t offsets = deltas + segments * 2;
    const std::size_t i =
        firstNotBefore(segments, [&](std::size_t at) { return map.u16(ends + at * 2) < code; });
    if (i == segments) return 0;
    const std::uint32_t start = map.u16(starts + i * 2);
    if (code < start) return 0;
    const std::uint32_t offset = map.u16(offsets + i * 2);
    if (offset == 0) return (code + map.u16(deltas + i * 2)) & 0xffff;
    return map.u16(offsets + i * 2 + offset + std::size_t{code - start} * 2);
}

/// Reads formats 12 (ranges of characters with consecutive glyphs, `counts`) and 13 (with one glyph for all).
std::uint32_t glyphInGroups(FontBytes map, std::uint32_t code, bool counts) {
    const std::size_t groups = std::min<std::size_t>(map.u32(12), map.size() / 12);
    const auto group = [](std::size_t i) { return 16 + i * 12; };
    const std::size_t i =
        firstNotBefore(groups, [&](std::size_t at) { return map.u32(group(at) + 4) < code; });
    const std::uint32_t start = map.u32(group(i));
    if (i == groups || code < start) return 0;
    return map.u32(group(i) + 8) + (counts ? code - start : 0);
}

// ---- kerning

/// Returns the kerning of a pair in the first subtable of "kern", if it contains horizontal pairs; else 0.
int kernPair(FontBytes kern, std::uint32_t left, std::uint32_t right) {
    if (kern.u16(2) < 1 || kern.u16(8) != 1) return 0;
    const std::size_t pairs = kern.u16(10);
    const std::uint32_t wanted = left << 16 | right;
    const std::size_t i =
        firstNotBefore(pairs, [&](std::size_t at) { return kern.u32(18 + at * 6) < wanted; });
    return i < pairs && kern.u32(18 + i * 6) == wanted ? kern.i16(18 + i * 6 + 4) : 0;
}

/// Returns the index of a glyph in a coverage table; -1 if it is not in the table.
int coverageOf(FontBytes table, std::uint32_t glyph) {
    const std::size_t count = table.u16(2);
    if (table.u16(0) == 1) {
        const std::size_t i =
            firstNotBefore(count, [&](std::size_t at) { return table.u16(4 + at * 2) < glyph; });
        return i < count && table.u16(4 + i * 2) == glyph ? static_cast<int>(i) : -1;
    }
    if (table.u16(0) != 2) return -1;
    const std::size_t i =
        firstNotBefore(count, [&](std::size_t at) { return table.u16(4 + at * 6 + 2) < glyph; });
    const std::size_t range = 4 + i * 6;
    if (i == count || glyph < table.u16(range)) return -1;
    return static_cast<int>(table.u16(range + 4) + glyph - table.u16(range));
}

/// Returns the class of a glyph in a class definition table; 0 for glyphs that are not in the table.
std::uint32_t classOf(FontBytes table, std::uint32_t glyph) {
    if (table.u16(0) == 1) {
        const std::uint32_t first = table.u16(2);
        const bool inside = glyph >= first && glyph < first + table.u16(4);
        return inside ? table.u16(6 + std::size_t{glyph - first} * 2) : 0;
    }
    const std::size_t count = table.u16(0) == 2 ? table.u16(2) : 0;
    const std::size_t i =
        firstNotBefore(count, [&](std::size_t at) { return table.u16(4 + at * 6 + 2) < glyph; });
    const bool inside = i < count && glyph >= table.u16(4 + i * 6);
    return inside ? table.u16(4 + i * 6 + 4) : 0;
}

/// Layout of a GPOS value record, bytes: its size, and the offset of the horizontal advance in it.
struct ValueForm {
    std::size_t size;
    std::size_t advanceAt;
    bool hasAdvance;
};
ValueForm formOf(std::uint32_t bits) {
    constexpr std::uint32_t kAdvance = 4;
    return {static_cast<std::size_t>(std::popcount(bits)) * 2,
            static_cast<std::size_t>(std::popcount(bits & (kAdvance - 1))) * 2, (bits & kAdvance) != 0};
}

/// Reads the kerning of a pair from a list of pairs for each first glyph. @return false if it is not listed
bool listedPair(FontBytes table, int covered, std::uint32_t right, int& value) {
    const ValueForm first = formOf(table.u16(4));
    const std::size_t pairSize = 2 + first.size + formOf(table.u16(6)).size;
    if (static_cast<std::uint32_t>(covered) >= table.u16(8)) return false;
    const FontBytes pairs = table.slice(table.u16(10 + static_cast<std::size_t>(covered) * 2));
    const std::size_t count = pairs.u16(0);
    const std::size_t i =
        firstNotBefore(count, [&](std::size_t at) { return pairs.u16(2 + at * pairSize) < right; });
    if (i == count || pairs.u16(2 + i * pairSize) != right) return false;
    value = first.hasAdvance ? pairs.i16(2 + i * pairSize + 2 + first.advanceAt) : 0;
    return true;
}

/// Reads the kerning of a pair from a table of glyph classes. @return false if the table has no such classes
bool classPair(FontBytes table, std::uint32_t left, std::uint32_t right, int& value) {
    const ValueForm first = formOf(table.u16(4));
    const std::size_t pairSize = first.size + formOf(table.u16(6)).size;
    const std::uint32_t leftClass = classOf(table.slice(table.u16(8)), left);
    const std::uint32_t rightClass = classOf(table.slice(table.u16(10)), right);
    const std::uint32_t rightClasses = table.u16(14);
    if (leftClass >= table.u16(12) || rightClass >= rightClasses) return false;
    const std::size_t pair = std::size_t{leftClass} * rightClasses + rightClass;
    value = first.hasAdvance ? table.i16(16 + pair * pairSize + first.advanceAt) : 0;
    return true;
}

bool pairIn(FontBytes table, std::uint32_t left, std::uint32_t right, int& value) {
    const int covered = coverageOf(table.slice(table.u16(2)), left);
    if (covered < 0) return false;
    if (table.u16(0) == 1) return listedPair(table, covered, right, value);
    return table.u16(0) == 2 && classPair(table, left, right, value);
}

/// Returns the kerning of a pair in the first pair subtable of "GPOS" that contains it; else 0.
int gposPair(FontBytes gpos, std::uint32_t left, std::uint32_t right) {
    constexpr std::uint32_t kPairs = 2;
    const FontBytes lookups = gpos.slice(gpos.u16(8));
    for (std::size_t i = 0; i < lookups.u16(0); ++i) {
        const FontBytes lookup = lookups.slice(lookups.u16(2 + i * 2));
        if (lookup.u16(0) != kPairs) continue;
        for (std::size_t k = 0; k < lookup.u16(4); ++k) {
            int value = 0;
            if (pairIn(lookup.slice(lookup.u16(6 + k * 2)), left, right, value)) return value;
        }
    }
    return 0;
}

// ---- the table directory

class Contents {
public:
    Contents(std::string_view bytes, std::string_view where) : file_{bytes}, where_{where} {
        constexpr std::uint32_t kCollection = 0x74746366;  // "ttcf": several fonts; the first one is used
        start_ = file_.u32(0) == kCollection ? file_.u32(12) : 0;
    }

    /// @error a table extends beyond the file
    [[nodiscard]] Result<Done> check() const {
        const std::size_t count = file_.u16(start_ + 4);
        if (count == 0 || file_.size() < start_ + kHeader + count * kRecord)
            return notAFont(where_, "the file has no table directory");
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t record = recordOf(i);
            if (std::uint64_t{file_.u32(record + 8)} + file_.u32(record + 12) > file_.size())
                return notAFont(where_, "a table extends beyond the end of the file");
        }
        return Done{};
    }

    [[nodiscard]] FontBytes find(std::string_view tag) const {
        const auto letter = [&](std::size_t i) { return std::uint32_t{static_cast<unsigned char>(tag[i])}; };
        const std::uint32_t wanted = letter(0) << 24 | letter(1) << 16 | letter(2) << 8 | letter(3);
        for (std::size_t i = 0; i < file_.u16(start_ + 4); ++i) {
            const std::size_t record = recordOf(i);
            if (file_.u32(record) == wanted)
                return file_.slice(file_.u32(record + 8), file_.u32(record + 12));
        }
        return {};
    }

private:
    [[nodiscard]] std::size_t recordOf(std::size_t i) const { return start_ + kHeader + i * kRecord; }

    FontBytes file_;
    std::string_view where_;
    std::size_t start_ = 0;
};

}  // namespace

Result<FontTables> FontTables::read(std::string_view bytes, std::string_view where) {
    const Contents contents{bytes, where};
    if (const Result<Done> sound = contents.check(); !sound) return sound.error();
    const FontBytes head = contents.find("head");
    const FontBytes hhea = contents.find("hhea");
    const FontBytes maxp = contents.find("maxp");
    FontTables tables;
    tables.cmap = unicodeTable(contents.find("cmap"));
    tables.hmtx = contents.find("hmtx");
    tables.kern = contents.find("kern");
    tables.gpos = contents.find("GPOS");
    tables.loca = contents.find("loca");
    tables.glyf = contents.find("glyf");
    tables.cff = contents.find("CFF ");
    constexpr std::size_t kHeadBytes = 54;
    constexpr std::size_t kHheaBytes = 36;
    if (head.size() < kHeadBytes || hhea.size() < kHheaBytes || maxp.size() < 6)
        return notAFont(where, "a table \"head\", \"hhea\" or \"maxp\" is missing or too short");
    if (tables.cmap.empty()) return notAFont(where, "there is no \"cmap\" table for Unicode characters");
    if ((tables.glyf.empty() || tables.loca.empty()) && tables.cff.empty())
        return notAFont(where, "the file has no glyph outlines");
    tables.glyphs = static_cast<int>(maxp.u16(4));
    tables.unitsPerEm = static_cast<int>(head.u16(18));
    tables.ascent = hhea.i16(4);
    tables.descent = hhea.i16(6);
    tables.lineGap = hhea.i16(8);
    tables.advances = static_cast<int>(hhea.u16(34));
    tables.longOffsets = head.u16(50) != 0;
    if (tables.unitsPerEm < kMinUnits || tables.unitsPerEm > kMaxUnits) {
        return notAFont(where, format("the file has {} units per em, expected {} to {}", tables.unitsPerEm,
                                      kMinUnits, kMaxUnits));
    }
    if (tables.advances == 0 || tables.hmtx.size() < static_cast<std::size_t>(tables.advances) * 4)
        return notAFont(where, "the table \"hmtx\" of glyph widths is missing or too short");
    return tables;
}

int FontTables::glyphOf(char32_t codepoint) const {
    const auto code = static_cast<std::uint32_t>(codepoint);
    std::uint32_t glyph = 0;
    switch (cmap.u16(0)) {
        case 0: glyph = code < 256 ? cmap.u8(6 + code) : 0; break;
        case 4: glyph = code < 0x10000 ? glyphInSegments(cmap, code) : 0; break;
        case 6: {
            const std::uint32_t first = cmap.u16(6);
            const bool inside = code >= first && code - first < cmap.u16(8);
            glyph = inside ? cmap.u16(10 + std::size_t{code - first} * 2) : 0;
            break;
        }
        case 12: glyph = glyphInGroups(cmap, code, true); break;
        case 13: glyph = glyphInGroups(cmap, code, false); break;
        default: break;
    }
    return glyph < static_cast<std::uint32_t>(glyphs) ? static_cast<int>(glyph) : 0;
}

int FontTables::advance(int glyph) const {
    const int own = std::clamp(glyph, 0, advances - 1);
    return static_cast<int>(hmtx.u16(static_cast<std::size_t>(own) * 4));
}

int FontTables::kerning(int left, int right) const {
    const auto first = static_cast<std::uint32_t>(left);
    const auto second = static_cast<std::uint32_t>(right);
    return gpos.empty() ? kernPair(kern, first, second) : gposPair(gpos, first, second);
}

}  // namespace plumb
