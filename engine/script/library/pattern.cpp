#include "script/library/pattern.hpp"

namespace plumb::script {
namespace {

// Letters and digits are those of ASCII, whatever the language of the system.
bool isLower(unsigned char c) { return c >= 'a' && c <= 'z'; }
bool isUpper(unsigned char c) { return c >= 'A' && c <= 'Z'; }
bool isDigit(unsigned char c) { return c >= '0' && c <= '9'; }
bool isLetter(unsigned char c) { return isLower(c) || isUpper(c); }
bool isVisible(unsigned char c) { return c > ' ' && c < 127; }

/// True if a character is of the class that a letter after '%' names; other letters stand for themselves.
bool ofClass(unsigned char c, unsigned char name) {
    bool is = false;
    switch (isUpper(name) ? name + ('a' - 'A') : name) {
        case 'a': is = isLetter(c); break;
        case 'c': is = c < ' ' || c == 127; break;
        case 'd': is = isDigit(c); break;
        case 'g': is = isVisible(c); break;
        case 'l': is = isLower(c); break;
        case 'p': is = isVisible(c) && !isLetter(c) && !isDigit(c); break;
        case 's': is = c == ' ' || (c >= '\t' && c <= '\r'); break;
        case 'u': is = isUpper(c); break;
        case 'w': is = isLetter(c) || isDigit(c); break;
        case 'x': is = isDigit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); break;
        case 'z': is = c == 0; break;  // of Lua 5.1, still accepted
        default: return name == c;
    }
    return isUpper(name) ? !is : is;
}

constexpr std::size_t kSetPerStep = 16;  // characters of a set that cost a step

unsigned char at(std::string_view text, std::size_t index) { return static_cast<unsigned char>(text[index]); }

}  // namespace

std::size_t PatternMatcher::match(std::size_t start) {
    captureCount_ = 0;
    depth_ = 0;
    return matchFrom(start, 0);
}

/// Counts steps. @return false if there are too many
bool PatternMatcher::spend(std::size_t steps) {
    steps_ += static_cast<std::int64_t>(steps);
    if (steps_ > kMaxSteps) fail(Problem::TooManySteps);
    return steps_ <= kMaxSteps;
}

/// Matches the rest of the pattern, from an item on.
std::size_t PatternMatcher::matchFrom(std::size_t start, std::size_t item) {
    if (++depth_ > kMaxDepth) return fail(Problem::TooComplex);
    std::size_t position = start;
    std::size_t result = kNone;
    while (problem_ == Problem::None) {
        if (!spend(1)) break;
        if (item == pattern_.size()) {
            result = position;
            break;
        }
        bool isSpecial = false;
        result = matchSpecial(position, item, isSpecial);
        if (isSpecial) break;
        const std::size_t end = endOfItem(item);
        if (problem_ != Problem::None) break;
        const char suffix = end < pattern_.size() ? pattern_[end] : '\0';
        const bool one = matchesOne(position, item, end);
        if (suffix == '?') {
            if (one) result = matchFrom(position + 1, end + 1);
            if (one && result != kNone) break;
            item = end + 1;
        } else if (suffix == '*' || suffix == '+') {
            result = suffix == '+' && !one ? kNone : matchMost(position, item, end);
            break;
        } else if (suffix == '-') {
            result = matchLeast(position, item, end);
            break;
        } else if (one) {
            ++position;
            item = end;
        } else {
            break;
        }
    }
    --depth_;
    return problem_ == Problem::None ? result : kNone;
}

/// Matches the rest of the pattern if the item is no character, set or class.
std::size_t PatternMatcher::matchSpecial(std::size_t position, std::size_t item, bool& isSpecial) {
    isSpecial = true;
    const char next = item + 1 < pattern_.size() ? pattern_[item + 1] : '\0';
    switch (pattern_[item]) {
        case '(':
            return next == ')' ? openCapture(position, item + 2, true)
                               : openCapture(position, item + 1, false);
        case ')': return closeCapture(position, item + 1);
        case '$':
            if (item + 1 == pattern_.size()) return position == text_.size() ? position : kNone;
            break;
        case '%':
            if (next == 'b') return matchBalanced(position, item + 2);
            if (next == 'f') return matchFrontier(position, item + 2);
            if (isDigit(static_cast<unsigned char>(next))) return matchBack(position, item + 1);
            break;
        default: break;
    }
    isSpecial = false;
    return kNone;
}

std::size_t PatternMatcher::openCapture(std::size_t position, std::size_t item, bool isPosition) {
    if (captureCount_ == kMaxCaptures) return fail(Problem::TooManyCaptures);
    captures_[static_cast<std::size_t>(captureCount_++)] = {position, 0, isPosition, !isPosition};
    const std::size_t result = matchFrom(position, item);
    if (result == kNone) --captureCount_;
    return result;
}

std::size_t PatternMatcher::closeCapture(std::size_t position, std::size_t item) {
    for (int i = captureCount_ - 1; i >= 0; --i) {
        Capture& capture = captures_[static_cast<std::size_t>(i)];
        if (!capture.isOpen) continue;
        capture.isOpen = false;
        capture.length = position - capture.begin;
        const std::size_t result = matchFrom(position, item);
        if (result == kNone) capture.isOpen = true;
        return result;
    }
    return fail(Problem::BadCapture);
}

/// "%bxy", `item` is at x: from x to the y that closes it.
std::size_t PatternMatcher::matchBalanced(std::size_t position, std::size_t item) {
    if (item + 1 >= pattern_.size()) return fail(Problem::Malformed);
    if (position >= text_.size() || text_[position] != pattern_[item]) return kNone;
    int open = 1;
    for (std::size_t i = position + 1; i < text_.size(); ++i) {
        if (!spend(1)) return kNone;
        if (text_[i] == pattern_[item + 1]) {
            if (--open == 0) return matchFrom(i + 1, item + 2);
        } else if (text_[i] == pattern_[item]) {
            ++open;
        }
    }
    return kNone;
}

/// "%f[set]", `item` is at the set: the border between a character outside of the set and one in it. The ends
/// of the text count as the character 0.
std::size_t PatternMatcher::matchFrontier(std::size_t position, std::size_t item) {
    if (item >= pattern_.size() || pattern_[item] != '[') return fail(Problem::Malformed);
    const std::size_t end = endOfItem(item);
    if (problem_ != Problem::None) return kNone;
    const unsigned char before = position == 0 ? 0 : at(text_, position - 1);
    const unsigned char after = position < text_.size() ? at(text_, position) : 0;
    if (inSet(before, item, end - 1) || !inSet(after, item, end - 1)) return kNone;
    return matchFrom(position, end);
}

/// "%1", `item` is at the digit: the text of a capture again.
std::size_t PatternMatcher::matchBack(std::size_t position, std::size_t item) {
    const int index = pattern_[item] - '1';
    if (index < 0 || index >= captureCount_ || capture(index).isOpen || capture(index).isPosition)
        return fail(Problem::BadCapture);
    const std::string_view captured = text_.substr(capture(index).begin, capture(index).length);
    if (!spend(captured.size())) return kNone;
    if (text_.substr(position, captured.size()) != captured) return kNone;
    return matchFrom(position + captured.size(), item + 1);
}

/// As many as possible of the item, which ends at `after`, the place of its suffix; then fewer.
std::size_t PatternMatcher::matchMost(std::size_t position, std::size_t item, std::size_t after) {
    const std::size_t least = pattern_[after] == '+' ? 1 : 0;
    std::size_t count = 0;
    while (matchesOne(position + count, item, after) && spend(1)) ++count;
    for (std::size_t i = count + 1; i > least && problem_ == Problem::None; --i) {
        const std::size_t result = matchFrom(position + i - 1, after + 1);
        if (result != kNone) return result;
    }
    return kNone;
}

/// As few as possible of the item, then more.
std::size_t PatternMatcher::matchLeast(std::size_t position, std::size_t item, std::size_t after) {
    while (problem_ == Problem::None) {
        const std::size_t result = matchFrom(position, after + 1);
        if (result != kNone) return result;
        if (!matchesOne(position, item, after)) return kNone;
        ++position;
    }
    return kNone;
}

/// The end of a character, class or set.
std::size_t PatternMatcher::endOfItem(std::size_t item) {
    if (pattern_[item] == '%') {
        if (item + 1 >= pattern_.size()) return fail(Problem::Malformed);
        return item + 2;
    }
    if (pattern_[item] != '[') return item + 1;
    std::size_t i = item + 1;
    if (i < pattern_.size() && pattern_[i] == '^') ++i;
    // The first character of a set is part of it, even ']'.
    do {
        if (i >= pattern_.size()) return fail(Problem::Malformed);
        i += pattern_[i] == '%' ? 2 : 1;
    } while (i >= pattern_.size() || pattern_[i] != ']');
    spend((i - item) / kSetPerStep);
    return i + 1;
}

bool PatternMatcher::matchesOne(std::size_t position, std::size_t item, std::size_t end) {
    if (position >= text_.size()) return false;
    const unsigned char c = at(text_, position);
    switch (pattern_[item]) {
        case '.': return true;
        case '%': return ofClass(c, at(pattern_, item + 1));
        case '[': return spend((end - item) / kSetPerStep) && inSet(c, item, end - 1);
        default: return at(pattern_, item) == c;
    }
}

/// True if a character is in the set between two brackets.
bool PatternMatcher::inSet(unsigned char c, std::size_t open, std::size_t close) const {
    std::size_t i = open + 1;
    const bool negated = pattern_[i] == '^';
    if (negated) ++i;
    bool found = false;
    while (i < close && !found) {
        if (pattern_[i] == '%' && i + 1 < close) {
            found = ofClass(c, at(pattern_, i + 1));
            i += 2;
        } else if (i + 2 < close && pattern_[i + 1] == '-') {
            found = at(pattern_, i) <= c && c <= at(pattern_, i + 2);
            i += 3;
        } else {
            found = at(pattern_, i) == c;
            ++i;
        }
    }
    return found != negated;
}

}  // namespace plumb::script
