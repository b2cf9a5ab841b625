// Reads quadratic outlines of TrueType fonts. Source: "glyf" table in the OpenType specification 1.9.

#include <algorithm>

#include "render/glyph_outline.hpp"

namespace plumb {
namespace {

using Kind = OutlineStep::Kind;

constexpr int kMaxDepth = 8;         // nested composite glyphs; fonts use 1 or 2
constexpr int kMaxComponents = 256;  // components of one glyph, including nested ones

struct Point {
    int x = 0;
    int y = 0;
    bool onCurve = false;
};

std::int16_t narrow(int value) { return static_cast<std::int16_t>(value); }

/// Transform of a component: a 2 by 2 matrix and a translation.
struct Placing {
    float xx = 1.0f, xy = 0.0f, yx = 0.0f, yy = 1.0f;
    float dx = 0.0f, dy = 0.0f;

    void apply(std::int16_t& x, std::int16_t& y) const {
        const auto whole = [](float value) {
            return static_cast<std::int16_t>(std::clamp(value, -32768.0f, 32767.0f));
        };
        const auto fromX = static_cast<float>(x);
        const auto fromY = static_cast<float>(y);
        x = whole(xx * fromX + yx * fromY + dx);
        y = whole(xy * fromX + yy * fromY + dy);
    }
};

/// Converts a closed contour to outline steps; points that are not on the curve are control points.
class Contour {
public:
    explicit Contour(std::vector<OutlineStep>& steps) : steps_{steps} {}

    void add(const Point* points, std::size_t count) {
        if (count < 2) return;  // encloses nothing
        std::size_t at = 1;
        const Point first = points[0];
        Point start = first;
        if (!first.onCurve) {
            start = points[1].onCurve ? points[1] : middle(first, points[1]);
            if (points[1].onCurve) at = 2;
        }
        step(Kind::Move, start, {});
        bent_ = false;
        for (; at < count; ++at) go(points[at]);
        if (!first.onCurve) go(first);
        go({start.x, start.y, true});
    }

private:
    static Point middle(const Point& a, const Point& b) { return {(a.x + b.x) >> 1, (a.y + b.y) >> 1, true}; }

    void go(const Point& to) {
        if (!to.onCurve) {
            if (bent_) step(Kind::Quadratic, middle(control_, to), control_);
            control_ = to;
        } else if (bent_) {
            step(Kind::Quadratic, to, control_);
        } else {
            step(Kind::Line, to, {});
        }
        bent_ = !to.onCurve;
    }
    void step(Kind kind, const Point& to, const Point& control) {
        steps_.push_back({kind, narrow(to.x), narrow(to.y), narrow(control.x), narrow(control.y)});
    }

    std::vector<OutlineStep>& steps_;
    Point control_;
    bool bent_ = false;
};

class GlyfReader {
public:
    GlyfReader(const FontTables& tables, std::vector<OutlineStep>& steps) : tables_{tables}, steps_{steps} {}

    /// Finds the data of a glyph. @return false if its offsets are outside the tables
    bool find(int glyph, FontBytes& data) const {
        const std::size_t width = tables_.longOffsets ? 4 : 2;
        const std::size_t at = static_cast<std::size_t>(glyph) * width;
        if (glyph < 0 || glyph >= tables_.glyphs || at + 2 * width > tables_.loca.size()) return false;
        const auto offset = [&](std::size_t index) {
            return tables_.longOffsets ? std::size_t{tables_.loca.u32(index)}
                                       : std::size_t{tables_.loca.u16(index)} * 2;
        };
        const std::size_t begin = offset(at);
        const std::size_t end = offset(at + width);
        if (begin > end || end > tables_.glyf.size()) return false;
        data = tables_.glyf.slice(begin, end - begin);
        return true;
    }

    bool read(int glyph, int depth) {
        FontBytes data;
        if (!find(glyph, data)) return false;
        if (data.empty()) return true;
        FontCursor cursor{data};
        const int contours = cursor.i16();
        cursor.skip(8);  // bounding box
        return contours >= 0 ? readPoints(cursor, static_cast<std::size_t>(contours))
                             : depth < kMaxDepth && readComponents(cursor, depth);
    }

private:
    bool readPoints(FontCursor& cursor, std::size_t contours) {
        if (contours == 0) return true;
        std::vector<std::size_t> ends;  // index after the last point of each contour
        for (std::size_t i = 0; i < contours; ++i) {
            ends.push_back(std::size_t{cursor.u16()} + 1);
            if (cursor.failed() || (i > 0 && ends[i] < ends[i - 1])) return false;
        }
        cursor.skip(cursor.u16());  // instructions
        if (cursor.failed() || steps_.size() + ends.back() > GlyphOutline::kMaxSteps) return false;
        std::vector<Point> points(ends.back());
        if (!readPositions(cursor, points)) return false;
        std::size_t first = 0;
        for (const std::size_t end : ends) {
            Contour{steps_}.add(points.data() + first, end - first);
            first = end;
        }
        return true;
    }

    static bool readPositions(FontCursor& cursor, std::vector<Point>& points) {
        constexpr std::uint32_t kOnCurve = 1, kRepeat = 8;
        std::vector<std::uint32_t> flags;
        flags.reserve(points.size());
        while (flags.size() < points.size() && !cursor.failed()) {
            const std::uint32_t flag = cursor.u8();
            const std::size_t times = 1 + ((flag & kRepeat) != 0 ? cursor.u8() : 0);
            flags.insert(flags.end(), std::min(times, points.size() - flags.size()), flag);
        }
        if (cursor.failed()) return false;
        for (std::size_t i = 0; i < points.size(); ++i) points[i].onCurve = (flags[i] & kOnCurve) != 0;
        readCoordinates(cursor, points, flags, 2, 16, &Point::x);
        readCoordinates(cursor, points, flags, 4, 32, &Point::y);
        return !cursor.failed();
    }

    /// Reads x or y of all points, stored as distances from the previous point.
    /// @param isByte flag of points whose distance has one byte
    /// @param isSame flag of points whose byte is positive or, without a byte, whose distance is 0
    static void readCoordinates(FontCursor& cursor, std::vector<Point>& points,
                                const std::vector<std::uint32_t>& flags, std::uint32_t isByte,
                                std::uint32_t isSame, int Point::*coordinate) {
        int value = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool same = (flags[i] & isSame) != 0;
            if ((flags[i] & isByte) != 0) {
                const int distance = static_cast<int>(cursor.u8());
                value += same ? distance : -distance;
            } else if (!same) {
                value += cursor.i16();
            }
            value = narrow(value);
            points[i].*coordinate = value;
        }
    }

    bool readComponents(FontCursor& cursor, int depth) {
        constexpr std::uint32_t kMore = 32;
        std::uint32_t flags = kMore;
        while ((flags & kMore) != 0) {
            flags = cursor.u16();
            const int glyph = static_cast<int>(cursor.u16());
            const Placing placing = readPlacing(cursor, flags);
            const std::size_t first = steps_.size();
            if (cursor.failed() || ++components_ > kMaxComponents || !read(glyph, depth + 1)) return false;
            for (std::size_t i = first; i < steps_.size(); ++i) {
                placing.apply(steps_[i].x, steps_[i].y);
                placing.apply(steps_[i].cx, steps_[i].cy);
            }
        }
        return true;
    }

    static Placing readPlacing(FontCursor& cursor, std::uint32_t flags) {
        constexpr std::uint32_t kWords = 1, kOffsets = 2, kScale = 8, kTwoScales = 64, kMatrix = 128;
        const auto ratio = [&] { return static_cast<float>(cursor.i16()) / 16384.0f; };  // 2.14 bits
        Placing placing;
        const int first = (flags & kWords) != 0 ? cursor.i16() : cursor.i8();
        const int second = (flags & kWords) != 0 ? cursor.i16() : cursor.i8();
        if ((flags & kOffsets) != 0) {  // otherwise point indices, which are not supported: no offset
            placing.dx = static_cast<float>(first);
            placing.dy = static_cast<float>(second);
        }
        if ((flags & kScale) != 0) {
            placing.xx = placing.yy = ratio();
        } else if ((flags & kTwoScales) != 0) {
            placing.xx = ratio();
            placing.yy = ratio();
        } else if ((flags & kMatrix) != 0) {
            placing.xx = ratio();
            placing.xy = ratio();
            placing.yx = ratio();
            placing.yy = ratio();
        }
        return placing;
    }

    const FontTables& tables_;
    std::vector<OutlineStep>& steps_;
    int components_ = 0;
};

}  // namespace

bool readGlyfOutline(const FontTables& tables, int glyph, GlyphOutline& outline) {
    GlyfReader reader{tables, outline.steps};
    FontBytes data;
    if (!reader.find(glyph, data) || !reader.read(glyph, 0)) return false;
    outline.left = data.i16(2);
    outline.bottom = data.i16(4);
    outline.right = data.i16(6);
    outline.top = data.i16(8);
    return true;
}

bool readOutline(const FontTables& tables, int glyph, GlyphOutline& outline) {
    return tables.glyf.empty() ? readCffOutline(tables.cff, glyph, outline)
                               : readGlyfOutline(tables, glyph, outline);
}

}  // namespace plumb
