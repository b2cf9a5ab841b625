// Reads cubic outlines of OpenType fonts.
// Sources: Adobe's Technical Notes 5176 (CFF) and 5177 (Type 2 charstrings).

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "render/glyph_outline.hpp"

namespace plumb {
namespace {

using Kind = OutlineStep::Kind;

/// An INDEX: a list of byte strings.
struct Index {
    FontBytes bytes;
    std::size_t count = 0;
    std::size_t width = 1;  ///< bytes per offset
    std::size_t end = 2;    ///< bytes from the start to the end of the INDEX

    static Index at(FontBytes cff, std::size_t begin) {
        Index index;
        index.bytes = cff.slice(begin);
        index.count = index.bytes.u16(0);
        if (index.count == 0) return index;
        index.width = std::clamp<std::size_t>(index.bytes.u8(2), 1, 4);
        index.end = index.dataAt() + index.offset(index.count);
        return index;
    }
    [[nodiscard]] FontBytes item(std::size_t i) const {
        if (i >= count) return {};
        const std::size_t from = offset(i);
        const std::size_t to = offset(i + 1);
        return from <= to ? bytes.slice(dataAt() + from, to - from) : FontBytes{};
    }

private:
    /// Base of the offsets: the byte before the data.
    [[nodiscard]] std::size_t dataAt() const { return 2 + (count + 1) * width; }
    [[nodiscard]] std::size_t offset(std::size_t i) const {
        std::size_t value = 0;
        for (std::size_t k = 0; k < width; ++k) value = value << 8 | bytes.u8(3 + i * width + k);
        return value;
    }
};

/// Returns the first two operands of an operator in a dictionary; no value if the operator is missing.
std::optional<std::array<int, 2>> entryOf(FontBytes dictionary, std::uint32_t wanted) {
    std::array<int, 2> numbers{};
    std::size_t count = 0;
    const auto push = [&](int number) {
        if (count < numbers.size()) numbers[count] = number;
        ++count;
    };
    FontCursor cursor{dictionary};
    while (!cursor.ended()) {
        const auto first = static_cast<int>(cursor.u8());
        if (first <= 21) {
            const std::uint32_t second =
                first == 12 ? 0x100 | cursor.u8() : static_cast<std::uint32_t>(first);
            if (second == wanted) return numbers;
            numbers = {};
            count = 0;
        } else if (first == 28) {
            push(cursor.i16());
        } else if (first == 29) {
            push(static_cast<int>(cursor.u32()));
        } else if (first == 30) {  // a real number: digits of four bits, ended by 15
            push(0);
            for (std::uint32_t digits = 0; (digits & 15) != 15 && !cursor.ended();) digits = cursor.u8();
        } else if (first >= 32 && first <= 246) {
            push(first - 139);
        } else if (first >= 247 && first <= 250) {
            push((first - 247) * 256 + static_cast<int>(cursor.u8()) + 108);
        } else if (first >= 251 && first <= 254) {
            push(-(first - 251) * 256 - static_cast<int>(cursor.u8()) - 108);
        }
    }
    return std::nullopt;
}

/// Returns an offset stored in a dictionary; 0 if it is missing.
std::size_t offsetIn(FontBytes dictionary, std::uint32_t wanted) {
    const int offset = entryOf(dictionary, wanted).value_or(std::array<int, 2>{})[0];
    return offset > 0 ? static_cast<std::size_t>(offset) : 0;
}

/// Returns the local subroutines of a dictionary.
Index subroutinesOf(FontBytes cff, FontBytes dictionary) {
    constexpr std::uint32_t kPrivate = 18, kSubroutines = 19;
    const std::array<int, 2> found = entryOf(dictionary, kPrivate).value_or(std::array<int, 2>{});
    if (found[0] <= 0 || found[1] <= 0) return {};
    const auto begin = static_cast<std::size_t>(found[1]);
    const std::size_t offset = offsetIn(cff.slice(begin, static_cast<std::size_t>(found[0])), kSubroutines);
    return offset == 0 ? Index{} : Index::at(cff, begin + offset);
}

/// Returns the index of the dictionary of a glyph, for fonts with several dictionaries (FDSelect).
std::size_t dictionaryOf(FontBytes select, std::size_t glyph) {
    if (select.u8(0) == 0) return select.u8(1 + glyph);
    const std::size_t ranges = select.u8(0) == 3 ? select.u16(1) : 0;
    for (std::size_t i = 0; i < ranges && 3 + i * 3 < select.size(); ++i) {
        const std::size_t range = 3 + i * 3;
        if (glyph >= select.u16(range) && glyph < select.u16(range + 3)) return select.u8(range + 2);
    }
    return 0;
}

/// The charstring of a glyph and the subroutines it can call.
struct Program {
    FontBytes code;
    Index shared;  ///< global subroutines
    Index own;     ///< local subroutines of its dictionary
};

std::optional<Program> programOf(FontBytes cff, int glyph) {
    constexpr std::uint32_t kCharstrings = 17, kForm = 0x106, kDictionaries = 0x124, kSelect = 0x125;
    const Index names = Index::at(cff, cff.u8(2));
    const std::size_t topAt = cff.u8(2) + names.end;
    const Index tops = Index::at(cff, topAt);
    const Index texts = Index::at(cff, topAt + tops.end);
    const FontBytes top = tops.item(0);
    const std::size_t charstrings = offsetIn(top, kCharstrings);
    const bool isType2 = entryOf(top, kForm).value_or(std::array{2, 0})[0] == 2;
    if (charstrings == 0 || !isType2 || glyph < 0) return std::nullopt;
    const auto letter = static_cast<std::size_t>(glyph);
    const Index letters = Index::at(cff, charstrings);
    if (letter >= letters.count) return std::nullopt;
    Program program{letters.item(letter), Index::at(cff, topAt + tops.end + texts.end), {}};
    FontBytes dictionary = top;
    if (const std::size_t list = offsetIn(top, kDictionaries)) {
        const std::size_t select = offsetIn(top, kSelect);
        if (select == 0) return std::nullopt;
        dictionary = Index::at(cff, list).item(dictionaryOf(cff.slice(select), letter));
    }
    program.own = subroutinesOf(cff, dictionary);
    return program;
}

/// Appends steps to an outline; tracks the current point and the bounding box of all points.
class Pen {
public:
    explicit Pen(GlyphOutline& outline) : outline_{outline} {}

    void move(float dx, float dy) {
        close();
        x_ += dx, y_ += dy;
        startX_ = x_, startY_ = y_;
        put({Kind::Move, whole(x_), whole(y_)});
    }
    void line(float dx, float dy) {
        x_ += dx, y_ += dy;
        put({Kind::Line, whole(x_), whole(y_)});
    }
    void curve(float dx1, float dy1, float dx2, float dy2, float dx3, float dy3) {
        const float x1 = x_ + dx1, y1 = y_ + dy1;
        const float x2 = x1 + dx2, y2 = y1 + dy2;
        x_ = x2 + dx3, y_ = y2 + dy3;
        surround(whole(x1), whole(y1));
        surround(whole(x2), whole(y2));
        put({Kind::Cubic, whole(x_), whole(y_), whole(x1), whole(y1), whole(x2), whole(y2)});
    }
    void close() {
        if (startX_ != x_ || startY_ != y_) put({Kind::Line, whole(startX_), whole(startY_)});
    }

private:
    static std::int16_t whole(float value) {
        return static_cast<std::int16_t>(std::clamp(value, -32768.0f, 32767.0f));
    }
    void put(OutlineStep step) {
        surround(step.x, step.y);
        outline_.steps.push_back(step);
    }
    void surround(int x, int y) {
        const bool first = outline_.steps.empty() && !any_;
        outline_.left = first ? x : std::min(outline_.left, x);
        outline_.right = first ? x : std::max(outline_.right, x);
        outline_.bottom = first ? y : std::min(outline_.bottom, y);
        outline_.top = first ? y : std::max(outline_.top, y);
        any_ = true;
    }

    GlyphOutline& outline_;
    float x_ = 0.0f, y_ = 0.0f;
    float startX_ = 0.0f, startY_ = 0.0f;
    bool any_ = false;
};

/// Interpreter of a glyph's charstring: numbers are pushed onto a stack, operators consume all of them.
class Charstring {
public:
    Charstring(const Program& program, GlyphOutline& outline)
        : program_{program}, outline_{outline}, pen_{outline} {}

    /// Appends the glyph's outline. @return false if the charstring is damaged
    bool run() { return run(program_.code, 0) && ended_; }

private:
    static constexpr std::size_t kMaxStack = 48;     // limit of the specification
    static constexpr int kMaxCalls = 10;             // nested calls, by the specification
    static constexpr int kMaxOperators = 1 << 16;    // limits the time of nested calls in damaged files
    static constexpr std::uint32_t kEscape = 0x100;  // marks operators of two bytes

    bool run(FontBytes code, int depth) {
        FontCursor cursor{code};
        while (!cursor.ended()) {
            const std::uint32_t byte = cursor.u8();
            if (byte >= 32 || byte == 28) {
                if (!push(numberFrom(byte, cursor))) return false;
                continue;
            }
            if (++operators_ > kMaxOperators || outline_.steps.size() > GlyphOutline::kMaxSteps) return false;
            switch (byte) {
                case 10:
                    if (!call(program_.own, depth)) return false;
                    break;
                case 29:
                    if (!call(program_.shared, depth)) return false;
                    break;
                case 11: return depth > 0;
                case 14: return pen_.close(), ended_ = true, true;
                case 19:
                case 20:
                    countHints();
                    cursor.skip((hints_ + 7) / 8);
                    count_ = 0;
                    break;
                default:
                    if (!draw(byte == 12 ? kEscape | cursor.u8() : byte)) return false;
                    count_ = 0;
                    break;
            }
            if (ended_) return true;
        }
        return false;  // a charstring must end with an explicit operator
    }

    static float numberFrom(std::uint32_t byte, FontCursor& cursor) {
        const int first = static_cast<int>(byte);
        if (first == 28) return static_cast<float>(cursor.i16());
        if (first <= 246) return static_cast<float>(first - 139);
        if (first <= 250)
            return static_cast<float>((first - 247) * 256 + static_cast<int>(cursor.u8()) + 108);
        if (first <= 254)
            return static_cast<float>(-(first - 251) * 256 - static_cast<int>(cursor.u8()) - 108);
        return static_cast<float>(static_cast<std::int32_t>(cursor.u32())) / 65536.0f;
    }
    bool push(float number) {
        if (count_ == kMaxStack) return false;
        stack_[count_++] = number;
        return true;
    }

    bool call(const Index& routines, int depth) {
        if (count_ == 0 || depth >= kMaxCalls) return false;
        const int bias = routines.count < 1240 ? 107 : routines.count < 33900 ? 1131 : 32768;
        const int number = static_cast<int>(stack_[--count_]) + bias;
        if (number < 0 || static_cast<std::size_t>(number) >= routines.count) return false;
        return run(routines.item(static_cast<std::size_t>(number)), depth + 1);
    }

    void countHints() { hints_ += count_ / 2; }

    /// Executes a drawing or hint operator. @return false if it is unknown or has too few operands
    bool draw(std::uint32_t code) {
        const std::span<const float> s{stack_.data(), count_};
        const std::size_t n = count_;
        switch (code) {
            case 1:
            case 3:
            case 18:
            case 23: return countHints(), true;
            case 4: return n >= 1 && (pen_.move(0.0f, s[n - 1]), true);
            case 21: return n >= 2 && (pen_.move(s[n - 2], s[n - 1]), true);
            case 22: return n >= 1 && (pen_.move(s[n - 1], 0.0f), true);
            case 5: return n >= 2 && (lines(s), true);
            case 6: return n >= 1 && (straightLines(s, true), true);
            case 7: return n >= 1 && (straightLines(s, false), true);
            case 8: return n >= 6 && (curves(s), true);
            case 24: return n >= 8 && (curves(s.first(n - 2)), lines(s.last(2)), true);
            case 25: return n >= 8 && (lines(s.first(n - 6)), curves(s.last(6)), true);
            case 26: return n >= 4 && (parallelCurves(s, false), true);
            case 27: return n >= 4 && (parallelCurves(s, true), true);
            case 30: return n >= 4 && (turningCurves(s, false), true);
            case 31: return n >= 4 && (turningCurves(s, true), true);
            default: return (code & kEscape) != 0 && flex(code & 0xff, s);
        }
    }

    void lines(std::span<const float> s) {
        for (std::size_t i = 0; i + 1 < s.size(); i += 2) pen_.line(s[i], s[i + 1]);
    }
    /// Appends lines, alternately along x and y.
    void straightLines(std::span<const float> s, bool alongX) {
        for (const float length : s) {
            pen_.line(alongX ? length : 0.0f, alongX ? 0.0f : length);
            alongX = !alongX;
        }
    }
    void curves(std::span<const float> s) {
        for (std::size_t i = 0; i + 5 < s.size(); i += 6)
            pen_.curve(s[i], s[i + 1], s[i + 2], s[i + 3], s[i + 4], s[i + 5]);
    }
    /// Appends curves that begin and end along the same axis. If the number of operands is odd, the first one
    /// is the first curve's initial offset along the other axis.
    void parallelCurves(std::span<const float> s, bool alongX) {
        float beside = 0.0f;
        if (s.size() % 2 != 0) beside = s[0], s = s.subspan(1);
        for (std::size_t i = 0; i + 3 < s.size(); i += 4) {
            if (alongX) {
                pen_.curve(s[i], beside, s[i + 1], s[i + 2], s[i + 3], 0.0f);
            } else {
                pen_.curve(beside, s[i], s[i + 1], s[i + 2], 0.0f, s[i + 3]);
            }
            beside = 0.0f;
        }
    }
    /// Appends curves that begin along one axis and end along the other, alternately. A fifth operand of the
    /// last curve is the other component of its end.
    void turningCurves(std::span<const float> s, bool alongX) {
        for (std::size_t i = 0; i + 3 < s.size(); i += 4) {
            const float last = s.size() - i == 5 ? s[i + 4] : 0.0f;
            if (alongX) {
                pen_.curve(s[i], 0.0f, s[i + 1], s[i + 2], last, s[i + 3]);
            } else {
                pen_.curve(0.0f, s[i], s[i + 1], s[i + 2], s[i + 3], last);
            }
            alongX = !alongX;
        }
    }

    /// Appends two curves that form a shallow bend ("flex"); drawn as curves at every size.
    bool flex(std::uint32_t code, std::span<const float> s) {
        if (code == 34 && s.size() >= 7) {
            pen_.curve(s[0], 0.0f, s[1], s[2], s[3], 0.0f);
            pen_.curve(s[4], 0.0f, s[5], -s[2], s[6], 0.0f);
        } else if (code == 35 && s.size() >= 13) {
            curves(s.first(12));
        } else if (code == 36 && s.size() >= 9) {
            pen_.curve(s[0], s[1], s[2], s[3], s[4], 0.0f);
            pen_.curve(s[5], 0.0f, s[6], s[7], s[8], -(s[1] + s[3] + s[7]));
        } else if (code == 37 && s.size() >= 11) {
            const float dx = s[0] + s[2] + s[4] + s[6] + s[8];
            const float dy = s[1] + s[3] + s[5] + s[7] + s[9];
            const bool alongX = std::fabs(dx) > std::fabs(dy);
            pen_.curve(s[0], s[1], s[2], s[3], s[4], s[5]);
            pen_.curve(s[6], s[7], s[8], s[9], alongX ? s[10] : -dx, alongX ? -dy : s[10]);
        } else {
            return false;
        }
        return true;
    }

    const Program& program_;
    GlyphOutline& outline_;
    Pen pen_;
    std::array<float, kMaxStack> stack_{};
    std::size_t count_ = 0;
    std::size_t hints_ = 0;
    int operators_ = 0;
    bool ended_ = false;
};

}  // namespace

bool readCffOutline(FontBytes cff, int glyph, GlyphOutline& outline) {
    const std::optional<Program> program = programOf(cff, glyph);
    return program && Charstring{*program, outline}.run();
}

}  // namespace plumb
