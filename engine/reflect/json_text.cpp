#include "reflect/json_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_set>
#include <utility>

#include "core/text.hpp"
#include "reflect/json.hpp"

namespace plumb {
namespace {

constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf";

bool isDigit(char c) { return c >= '0' && c <= '9'; }

void appendUtf8(std::string& out, std::uint32_t code) {
    const auto put = [&](std::uint32_t byte) { out += static_cast<char>(static_cast<unsigned char>(byte)); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xc0 | code >> 6), put(0x80 | (code & 0x3f));
    } else if (code < 0x10000) {
        put(0xe0 | code >> 12), put(0x80 | (code >> 6 & 0x3f)), put(0x80 | (code & 0x3f));
    } else {
        put(0xf0 | code >> 18), put(0x80 | (code >> 12 & 0x3f)), put(0x80 | (code >> 6 & 0x3f));
        put(0x80 | (code & 0x3f));
    }
}

/// Parses a text from front to back. Each read function advances `at_`, or returns false and sets the error.
class JsonReader {
public:
    JsonReader(std::string_view text, std::string_view where, std::vector<Error>* warnings,
               const JsonLimits& limits)
        : text_{text}, where_{where}, warnings_{warnings}, limits_{limits} {}

    Result<Json> read() {
        Json json;
        if (!admit() || !readValue(json, 0) || !atEnd()) return *std::move(error_);
        return json;
    }

private:
    [[nodiscard]] bool ended() const { return at_ >= text_.size(); }
    [[nodiscard]] char peek() const { return ended() ? '\0' : text_[at_]; }

    [[nodiscard]] std::ptrdiff_t lineOf(std::size_t position) const {
        const std::string_view before = text_.substr(0, position);
        return std::count(before.begin(), before.end(), '\n') + 1;
    }
    [[nodiscard]] std::string placeOf(std::size_t position) const {
        const std::string_view before = text_.substr(0, position);
        const auto line = lineOf(position);
        const std::size_t lineStart = before.rfind('\n') + 1;  // npos + 1 is 0: the first line
        return format("{}:{}:{}", where_, line, position - lineStart + 1);
    }

    [[nodiscard]] std::string found() const {
        if (ended()) return "the end of the file";
        const unsigned char c = static_cast<unsigned char>(text_[at_]);
        if (c == '"') return "a string";
        return c < 0x20 || c > 0x7e ? format("a character {}", static_cast<int>(c))
                                    : format("\"{}\"", text_[at_]);
    }

    bool fail(std::size_t position, std::string what, std::string remedy) {
        error_ = Error{placeOf(position), std::move(what), std::move(remedy)};
        return false;
    }
    bool failExpecting(std::string_view expected, std::string remedy) {
        return fail(at_, format("expected {}, found {}", expected, found()), std::move(remedy));
    }

    /// An unexpected token in an array or object. If no value can start with it, the closing bracket
    /// is missing: then the error refers to the opening bracket, because that is the place to fix.
    bool failInside(std::size_t openedAt, std::string_view expected, std::string_view remedy) {
        const char bracket = text_[openedAt];
        const bool isArray = bracket == '[';
        const bool unclosed = ended() || (isArray ? peek() == '}' || peek() == ':' : peek() == ']');
        const auto line = lineOf(openedAt);
        if (!unclosed)
            return failExpecting(
                expected, format("{}; the \"{}\" of line {} is not closed yet", remedy, bracket, line));
        const std::string where = ended() ? std::string{} : format(" in line {}", lineOf(at_));
        return fail(openedAt,
                    format("the \"{}\" that opens here is not closed: expected {}, found {}{}", bracket,
                           expected, found(), where),
                    format("add the missing \"{}\"", isArray ? ']' : '}'));
    }

    bool admit() {
        if (text_.size() > limits_.bytes) {
            return fail(0, format("the text has {} bytes, the limit is {}", text_.size(), limits_.bytes),
                        "split it or make it smaller");
        }
        if (!isUtf8(text_)) return fail(0, "the text is not UTF-8", "save the file as UTF-8");
        if (startsWith(text_, kUtf8Mark)) text_.remove_prefix(kUtf8Mark.size());
        return true;
    }

    bool atEnd() {
        skipBlank();
        return ended() || failExpecting("the end of the file", "remove what follows the last bracket");
    }

    void skipBlank() {
        while (!ended() &&
               (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\t' || text_[at_] == '\r')) {
            ++at_;
        }
    }

    bool readValue(Json& json, int depth) {
        skipBlank();
        if (++values_ > limits_.values) {
            return fail(at_, format("more than {} values", limits_.values), "split the file");
        }
        switch (peek()) {
            case '{': return enter(depth) && readObject(json, depth + 1);
            case '[': return enter(depth) && readArray(json, depth + 1);
            case '"': {
                json = std::string{};
                return readText(*json.get_ptr<std::string*>());
            }
            case 't': return readWord("true", json, true);
            case 'f': return readWord("false", json, false);
            case 'n': return readWord("null", json, nullptr);
            default: return readNumber(json);
        }
    }

    bool enter(int depth) {
        return depth < limits_.depth || fail(at_, format("nested deeper than {} levels", limits_.depth),
                                             "flatten the file; no file of the engine nests that deep");
    }

    bool readWord(std::string_view word, Json& json, const Json& value) {
        if (text_.substr(at_, word.size()) != word)
            return failExpecting("a value", "write true, false or null");
        at_ += word.size();
        json = value;
        return true;
    }

    bool readObject(Json& json, int depth) {
        json = Json::object();
        auto& properties = *json.get_ptr<Json::object_t*>();
        std::unordered_set<std::string> seen;  // lookup only, never iterated; used once an object is large
        const std::size_t openedAt = at_++;
        skipBlank();
        if (peek() == '}') return ++at_, true;
        for (;; ++at_) {
            skipBlank();
            const std::size_t keyAt = at_;
            if (peek() != '"')
                return failInside(openedAt, "a property's name",
                                  "write names in double quotes, and no comma after the last property");
            std::string key;
            if (!readText(key)) return false;
            skipBlank();
            if (peek() != ':') return failExpecting("\":\"", "write \"name\": value");
            ++at_;
            Json value;
            if (!readValue(value, depth)) return false;
            if (!addProperty(properties, seen, std::move(key), std::move(value), keyAt)) return false;
            skipBlank();
            if (peek() == '}') return ++at_, true;
            if (peek() != ',')
                return failInside(openedAt, "\",\" or \"}\"", "put a comma between properties");
        }
    }

    bool addProperty(Json::object_t& properties, std::unordered_set<std::string>& seen, std::string key,
                     Json value, std::size_t keyAt) {
        constexpr std::size_t kLarge = 16;
        const auto sameKey = [&](const auto& property) { return property.first == key; };
        if (properties.size() == kLarge) {
            for (const auto& property : properties) seen.insert(property.first);
        }
        const bool repeated = properties.size() < kLarge
                                  ? std::any_of(properties.begin(), properties.end(), sameKey)
                                  : !seen.insert(key).second;
        if (!repeated) {
            properties.emplace_back(std::move(key), std::move(value));
            return true;
        }
        fail(keyAt, format("the key \"{}\" appears twice in one object", key.substr(0, 80)),
             "keep one of the two");
        if (warnings_ == nullptr) return false;
        warnings_->push_back(*std::exchange(error_, std::nullopt));
        std::find_if(properties.begin(), properties.end(), sameKey)->second = std::move(value);
        return true;
    }

    bool readArray(Json& json, int depth) {
        json = Json::array();
        auto& items = *json.get_ptr<Json::array_t*>();
        const std::size_t openedAt = at_++;
        skipBlank();
        if (peek() == ']') return ++at_, true;
        for (;; ++at_) {
            skipBlank();
            if (ended() || peek() == '}') return failInside(openedAt, "a value", "");
            if (!readValue(items.emplace_back(), depth)) return false;
            skipBlank();
            if (peek() == ']') return ++at_, true;
            if (peek() != ',') return failInside(openedAt, "\",\" or \"]\"", "put a comma between items");
        }
    }

    bool readText(std::string& out) {
        const std::size_t start = at_++;
        for (;;) {
            const std::size_t plainStart = at_;
            while (!ended() && text_[at_] != '"' && text_[at_] != '\\' &&
                   static_cast<unsigned char>(text_[at_]) >= 0x20) {
                ++at_;
            }
            out.append(text_, plainStart, at_ - plainStart);
            if (out.size() > limits_.textBytes) {
                return fail(start, format("a string longer than {} bytes", limits_.textBytes),
                            "shorten it or split it");
            }
            if (ended()) return fail(start, "the string has no end", "close it with a double quote");
            if (text_[at_] == '"') return ++at_, true;
            if (text_[at_] != '\\')
                return failExpecting("a character or a closing quote", "write line ends as \\n, tabs as \\t");
            if (!readEscape(out)) return false;
        }
    }

    bool readEscape(std::string& out) {
        constexpr std::string_view kLetters = "\"\\/bfnrt";
        constexpr std::string_view kMeanings = "\"\\/\b\f\n\r\t";
        ++at_;
        const char letter = peek();
        if (const std::size_t which = kLetters.find(letter); !ended() && which != std::string_view::npos) {
            out += kMeanings[which];
            ++at_;
            return true;
        }
        if (letter != 'u') return failExpecting("an escape", "write \\\\ for a backslash");
        ++at_;
        const std::optional<std::uint32_t> first = readHex4();
        if (!first) return false;
        return readCodePoint(*first, out);
    }

    /// Combines the two \u escapes of a character beyond the first 65,536.
    bool readCodePoint(std::uint32_t first, std::string& out) {
        std::uint32_t code = first;
        if (first >= 0xd800 && first < 0xdc00 && text_.substr(at_, 2) == "\\u") {
            at_ += 2;
            const std::optional<std::uint32_t> second = readHex4();
            if (!second) return false;
            code = *second >= 0xdc00 && *second < 0xe000
                       ? 0x10000 + ((first - 0xd800) << 10) + (*second - 0xdc00)
                       : first;
        }
        if (code >= 0xd800 && code < 0xe000) {
            return fail(at_, "half of a pair of \\u escapes", "write both halves, or the character itself");
        }
        appendUtf8(out, code);
        return true;
    }

    std::optional<std::uint32_t> readHex4() {
        const std::string_view digits = text_.substr(std::min(at_, text_.size()), 4);
        const std::optional<std::uint64_t> value = digits.size() == 4 ? parseHex(digits) : std::nullopt;
        if (!value) {
            fail(at_, "expected four hex digits after \\u", "e.g. \\u00e9");
            return std::nullopt;
        }
        at_ += 4;
        return static_cast<std::uint32_t>(*value);
    }

    /// Length of a number in JSON's syntax, which is stricter than that of from_chars.
    [[nodiscard]] std::size_t numberLength(bool& whole) const {
        std::size_t i = at_;
        const auto digits = [&] {
            const std::size_t start = i;
            while (i < text_.size() && isDigit(text_[i])) ++i;
            return i - start;
        };
        const auto next = [&](std::string_view oneOf) {
            return i < text_.size() && oneOf.find(text_[i]) != std::string_view::npos;
        };
        whole = true;
        if (next("-")) ++i;
        const bool startsWithZero = next("0");
        if (const std::size_t count = digits(); count == 0 || (startsWithZero && count > 1)) return 0;
        if (next(".")) {
            whole = false;
            ++i;
            if (digits() == 0) return 0;
        }
        if (next("eE")) {
            whole = false;
            ++i;
            if (next("+-")) ++i;
            if (digits() == 0) return 0;
        }
        return i - at_;
    }

    bool readNumber(Json& json) {
        bool whole = true;
        const std::size_t length = numberLength(whole);
        if (length == 0)
            return failExpecting("a value", "write a number, a \"string\", true, false, null, { or [");
        const std::string_view text = text_.substr(at_, length);
        const char* end = text.data() + text.size();
        std::int64_t number = 0;
        std::uint64_t large = 0;
        double real = 0.0;
        if (whole && text != "-0" && std::from_chars(text.data(), end, number).ec == std::errc{}) {
            json = number;
        } else if (whole && text != "-0" && std::from_chars(text.data(), end, large).ec == std::errc{}) {
            json = large;
        } else if (std::from_chars(text.data(), end, real).ec == std::errc{}) {
            json = real;
        } else {
            return fail(at_, "the number is too large for a double", "write a smaller one");
        }
        at_ += length;
        return true;
    }

    std::string_view text_;
    std::string_view where_;
    std::vector<Error>* warnings_;
    JsonLimits limits_;
    std::size_t at_ = 0;
    std::size_t values_ = 0;
    std::optional<Error> error_;
};

}  // namespace

Result<Json> parseJson(std::string_view text, std::string_view where, std::vector<Error>* warnings,
                       const JsonLimits& limits) {
    return JsonReader{text, where, warnings, limits}.read();
}

}  // namespace plumb
