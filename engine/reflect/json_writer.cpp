#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/text.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"

namespace plumb {
namespace {

constexpr std::size_t kLineWidth = 110;  // characters
constexpr std::size_t kShortText = 16;   // bytes; longer texts, such as rows of tiles, get lines of their own

void writeEscaped(std::string& out, char c) {
    switch (c) {
        case '"': out += "\\\""; break;
        case '\\': out += "\\\\"; break;
        case '\n': out += "\\n"; break;
        case '\r': out += "\\r"; break;
        case '\t': out += "\\t"; break;
        default: out += "\\u" + hexText(static_cast<unsigned char>(c)).substr(12);
    }
}

/// Copies the characters between two escapes at once: packed tiles have none at all.
void writeText(std::string& out, std::string_view text) {
    const auto isPlain = [](char c) {
        return static_cast<unsigned char>(c) >= 0x20 && c != '"' && c != '\\';
    };
    out += '"';
    std::size_t from = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (isPlain(text[at])) continue;
        out.append(text, from, at - from);
        writeEscaped(out, text[at]);
        from = at + 1;
    }
    out.append(text, from);
    out += '"';
}

/// Readers parse doubles, so a float's shortest text is used only if the parsed double gives the same float.
void writeReal(std::string& out, double value) {
    if (!std::isfinite(value)) {
        out += "null";
        return;
    }
    const auto narrow = static_cast<float>(value);
    if (static_cast<double>(narrow) == value) {
        const std::string text = shortestText(narrow);
        double read = 0.0;
        std::from_chars(text.data(), text.data() + text.size(), read);
        if (static_cast<float>(read) == narrow) {
            out += text;
            return;
        }
    }
    out += shortestText(value);
}

void writeScalar(std::string& out, const Json& json) {
    switch (json.type()) {
        case Json::value_t::boolean: out += json.get<bool>() ? "true" : "false"; break;
        case Json::value_t::number_integer: out += format("{}", json.get<long long>()); break;
        case Json::value_t::number_unsigned: out += format("{}", json.get<unsigned long long>()); break;
        case Json::value_t::number_float: writeReal(out, json.get<double>()); break;
        case Json::value_t::string: writeText(out, *json.get_ptr<const std::string*>()); break;
        default: out += "null"; break;
    }
}

/// True for numbers and short words, and arrays of them such as the corners of a polygon.
bool mayStandInline(const Json& array, int depth = 0) {
    return std::all_of(array.begin(), array.end(), [depth](const Json& item) {
        if (item.is_array()) return depth < 1 && mayStandInline(item, depth + 1);
        if (item.is_string()) return item.get_ptr<const std::string*>()->size() <= kShortText;
        return !item.is_object();
    });
}

void writeInline(std::string& out, const Json& array) {
    out += '[';
    bool first = true;
    for (const Json& item : array) {
        if (!first) out += ", ";
        first = false;
        item.is_array() ? writeInline(out, item) : writeScalar(out, item);
    }
    out += ']';
}

/// Writes the value on one line. Returns false, after writing a part of it, if it is wider than `room`.
bool writeFlat(std::string& out, const Json& json, std::size_t start, std::size_t room) {
    if (!json.is_structured()) {
        writeScalar(out, json);
        return out.size() - start < room;
    }
    out += json.is_object() ? '{' : '[';
    bool first = true;
    const auto next = [&] {
        if (!first) out += ", ";
        first = false;
    };
    if (json.is_object()) {
        for (const auto& [key, value] : *json.get_ptr<const Json::object_t*>()) {
            next();
            writeText(out, key);
            out += ": ";
            if (!writeFlat(out, value, start, room)) return false;
        }
    } else {
        for (const Json& item : json) {
            next();
            if (!writeFlat(out, item, start, room)) return false;
        }
    }
    out += json.is_object() ? '}' : ']';
    return out.size() - start < room;
}

enum class Layout : std::uint8_t { OnePropertyALine, Compact };

class JsonWriter {
public:
    explicit JsonWriter(std::string& text, Layout layout = Layout::OnePropertyALine)
        : out{text}, lineStart_{text.rfind('\n') + 1}, layout_{layout} {}

    void write(const Json& json, std::size_t indent) {
        if (layout_ == Layout::Compact && indent > 0 && indent < kLineWidth) {
            const std::size_t start = out.size();
            if (writeFlat(out, json, start, kLineWidth - 2 - indent)) return;
            out.resize(start);
        }
        if (json.is_object()) {
            writeObject(json, indent);
        } else if (json.is_array()) {
            writeArray(json, indent);
        } else {
            writeScalar(out, json);
        }
    }

private:
    void startLine(std::size_t indent) {
        out += '\n';
        out.append(indent, ' ');
        lineStart_ = out.size() - indent;
    }

    void writeObject(const Json& object, std::size_t indent) {
        out += '{';
        bool first = true;
        for (const auto& [key, value] : *object.get_ptr<const Json::object_t*>()) {
            if (!first) out += ',';
            first = false;
            startLine(indent + 2);
            writeText(out, key);
            out += ": ";
            write(value, indent + 2);
        }
        if (!first) startLine(indent);
        out += '}';
    }

    void writeArray(const Json& array, std::size_t indent) {
        const std::size_t start = out.size();
        // Each item takes at least two characters: do not try what cannot fit.
        if (layout_ == Layout::OnePropertyALine && array.size() <= kLineWidth / 2 && mayStandInline(array)) {
            writeInline(out, array);
            if (array.empty() || out.size() - lineStart_ <= kLineWidth) return;
            out.resize(start);
        }
        out += '[';
        bool first = true;
        for (const Json& item : array) {
            if (!first) out += ',';
            first = false;
            startLine(indent + 2);
            write(item, indent + 2);
        }
        startLine(indent);
        out += ']';
    }

    std::string& out;
    std::size_t lineStart_;  // npos + 1 is 0: the first line
    Layout layout_;
};

}  // namespace

std::string writeJson(const Json& json) {
    std::string out;
    appendJson(out, json, 0);
    out += '\n';
    return out;
}

std::string writeCompactJson(const Json& json) {
    std::string out;
    JsonWriter writer{out, Layout::Compact};
    writer.write(json, 0);
    out += '\n';
    return out;
}

void appendJson(std::string& out, const Json& json, std::size_t indent) {
    JsonWriter writer{out};
    writer.write(json, indent);
}

}  // namespace plumb
