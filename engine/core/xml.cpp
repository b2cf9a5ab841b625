#include "core/xml.hpp"

#include <optional>

#include "core/limits.hpp"
#include "core/text.hpp"

namespace plumb {
namespace {

constexpr bool isSpace(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

/// Neither punctuation of XML nor white space; letters of other scripts have bytes >= 128.
constexpr bool isNameCharacter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.' || c == ':' || static_cast<unsigned char>(c) >= 128;
}

void appendUtf8(std::string& text, std::uint32_t code) {
    const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xc0 | code >> 6), put(0x80 | (code & 63));
    } else if (code < 0x10000) {
        put(0xe0 | code >> 12), put(0x80 | (code >> 6 & 63)), put(0x80 | (code & 63));
    } else {
        put(0xf0 | code >> 18), put(0x80 | (code >> 12 & 63)), put(0x80 | (code >> 6 & 63)),
            put(0x80 | (code & 63));
    }
}

/// The character of a reference `&#...;`, given without `&#` and `;`.
std::optional<std::uint32_t> numericCharacter(std::string_view digits) {
    const bool hex = startsWith(digits, "x");
    if (hex) digits.remove_prefix(1);
    std::uint32_t code = 0;
    if (digits.empty() || digits.size() > 8) return {};
    if (hex) {
        const std::optional<std::uint64_t> value = parseHex(digits);
        if (!value || *value > 0x10ffff) return {};
        code = static_cast<std::uint32_t>(*value);
    } else {
        for (const char c : digits) {
            if (c < '0' || c > '9') return {};
            code = code * 10 + static_cast<std::uint32_t>(c - '0');
        }
    }
    const bool allowed = code == '\t' || code == '\n' || code == '\r' || (code >= 0x20 && code < 0xd800) ||
                         (code >= 0xe000 && code <= 0x10ffff && code != 0xfffe && code != 0xffff);
    return allowed ? std::optional{code} : std::nullopt;
}

std::optional<char> namedCharacter(std::string_view name) {
    if (name == "amp") return '&';
    if (name == "lt") return '<';
    if (name == "gt") return '>';
    if (name == "quot") return '"';
    if (name == "apos") return '\'';
    return {};
}

/// Parses a document from front to back. The first error is kept and ends parsing.
class XmlReader {
public:
    XmlReader(std::string_view document, std::string_view where) : rest_{document}, where_{where} {}

    Result<XmlElement> read() {
        if (startsWith(rest_, "\xef\xbb\xbf")) rest_.remove_prefix(3);
        XmlElement root;
        if (!isUtf8(rest_)) {
            fail("the text is not UTF-8", "save the file as UTF-8");
        } else if (skipBetweenElements() && readElement(root, 0) && skipBetweenElements() && !rest_.empty()) {
            fail("something follows the end of the root element", "keep one element at the top");
        }
        if (failed_) return error_;
        return root;
    }

private:
    bool fail(std::string what, std::string remedy) {
        if (!failed_) error_ = {format("{}:{}", where_, line_), std::move(what), std::move(remedy)};
        failed_ = true;
        return false;
    }
    bool failCut() {
        return fail("the file ends in the middle", "it was cut off; export or download it again");
    }

    std::string_view take(std::size_t count) {
        const std::string_view taken = rest_.substr(0, count);
        for (const char c : taken) line_ += c == '\n';
        rest_.remove_prefix(taken.size());
        return taken;
    }
    bool skip(std::string_view expected) {
        return startsWith(rest_, expected) && (take(expected.size()), true);
    }
    void skipSpace() {
        std::size_t count = 0;
        while (count < rest_.size() && isSpace(rest_[count])) ++count;
        take(count);
    }
    /// Takes everything up to `end`, which is skipped too.
    bool takeUntil(std::string_view end, std::string_view& taken) {
        const std::size_t at = rest_.find(end);
        if (at == std::string_view::npos) return failCut();
        taken = take(at);
        take(end.size());
        return true;
    }

    /// Skips white space, comments, processing instructions and the document type around the root element.
    bool skipBetweenElements() {
        for (;;) {
            skipSpace();
            std::string_view skipped;
            if (skip("<?")) {
                if (!takeUntil("?>", skipped)) return false;
            } else if (skip("<!--")) {
                if (!takeUntil("-->", skipped)) return false;
            } else if (skip("<!DOCTYPE")) {
                if (!takeUntil(">", skipped)) return false;
                if (skipped.find('[') != std::string_view::npos) {
                    return fail("declarations inside the document type are not read",
                                "remove the part in [ ]");
                }
            } else {
                return true;
            }
        }
    }

    bool takeName(std::string& name) {
        std::size_t count = 0;
        while (count < rest_.size() && isNameCharacter(rest_[count])) ++count;
        if (count == 0) {
            return rest_.empty() ? failCut()
                                 : fail("a name is expected here", "check the characters after '<' or ' '");
        }
        name = take(count);
        return true;
    }

    bool appendEntity(std::string& text) {
        const std::size_t end = rest_.substr(0, 16).find(';');
        const std::string_view name = end == std::string_view::npos ? "" : rest_.substr(1, end - 1);
        if (startsWith(name, "#")) {
            const std::optional<std::uint32_t> code = numericCharacter(name.substr(1));
            if (!code) return fail(format("&{}; names no character", name), "write the character itself");
            appendUtf8(text, *code);
        } else {
            const std::optional<char> character = namedCharacter(name);
            if (!character)
                return fail("an unknown entity or a lone '&'", "write &amp; for the character '&'");
            text += *character;
        }
        take(end + 1);
        return true;
    }

    /// Appends characters up to one of `ends`, not consumed. In attributes white space becomes spaces.
    bool appendCharacters(std::string& text, char end, bool attribute) {
        while (!rest_.empty() && rest_[0] != end && rest_[0] != '<') {
            if (rest_[0] == '&') {
                if (!appendEntity(text)) return false;
            } else if (rest_[0] == '\r') {
                take(1);
                if (rest_.empty() || rest_[0] != '\n') text += attribute ? ' ' : '\n';
            } else {
                const char c = take(1)[0];
                if (static_cast<unsigned char>(c) < 0x20 && !isSpace(c)) {
                    return fail("a control character in the text", "remove it; the file may be damaged");
                }
                text += attribute && isSpace(c) ? ' ' : c;
            }
        }
        return true;
    }

    bool readAttributes(XmlElement& element) {
        for (;;) {
            const std::size_t before = rest_.size();
            skipSpace();
            if (rest_.empty()) return failCut();
            if (rest_[0] == '>' || rest_[0] == '/') return true;
            if (rest_.size() == before) return fail("a space is missing between attributes", "add it");
            XmlAttribute attribute;
            if (!takeName(attribute.name)) return false;
            if (element.find(attribute.name) || element.attributes.size() >= kAttributes) {
                return fail(format("attribute {} is there twice, or there are too many", attribute.name),
                            "keep one");
            }
            skipSpace();
            const bool equals = skip("=");
            skipSpace();
            if (rest_.empty()) return failCut();
            const char quote = rest_[0];
            if (!equals || (quote != '"' && quote != '\'')) {
                return fail(format("attribute {} has no value in quotes", attribute.name),
                            "write name=\"value\"");
            }
            take(1);
            if (!appendCharacters(attribute.value, quote, true)) return false;
            if (rest_.empty()) return failCut();
            if (take(1)[0] != quote) return fail("'<' inside an attribute", "write &lt;");
            element.attributes.push_back(std::move(attribute));
        }
    }

    bool readElement(XmlElement& element, int depth) {
        element.line = line_;
        if (depth >= limits::kXmlDepth) return fail("elements are nested too deep", "take levels out");
        if (++elements_ > limits::kXmlElements)
            return fail("too many elements", "split the file, or use csv data");
        if (!skip("<"))
            return rest_.empty() ? failCut() : fail("an element is expected here", "start it with '<'");
        if (!takeName(element.name) || !readAttributes(element)) return false;
        if (skip("/>")) return true;
        if (!skip(">")) return fail("'/' without '>'", "end the tag with '/>'");
        return readContent(element, depth);
    }

    bool readContent(XmlElement& element, int depth) {
        for (;;) {
            if (!appendCharacters(element.text, '<', false)) return false;
            std::string_view taken;
            if (rest_.empty()) return failCut();
            if (skip("</")) return readEnd(element);
            if (skip("<!--")) {
                if (!takeUntil("-->", taken)) return false;
            } else if (skip("<![CDATA[")) {
                if (!takeUntil("]]>", taken)) return false;
                element.text += taken;
            } else if (skip("<?")) {
                if (!takeUntil("?>", taken)) return false;
            } else if (!readElement(element.children.emplace_back(), depth + 1)) {
                return false;
            }
        }
    }

    bool readEnd(const XmlElement& element) {
        std::string name;
        if (!takeName(name)) return false;
        skipSpace();
        if (name != element.name) {
            return fail(format("</{}> ends <{}> of line {}", name, element.name, element.line),
                        format("write </{}>", element.name));
        }
        return skip(">") || (rest_.empty() ? failCut() : fail("'>' is missing", "end the tag with '>'"));
    }

    static constexpr std::size_t kAttributes = 256;

    std::string_view rest_;
    std::string_view where_;
    int line_ = 1;
    std::size_t elements_ = 0;
    bool failed_ = false;
    Error error_;
};

}  // namespace

const std::string* XmlElement::find(std::string_view attribute) const {
    for (const XmlAttribute& candidate : attributes) {
        if (candidate.name == attribute) return &candidate.value;
    }
    return nullptr;
}

const XmlElement* XmlElement::child(std::string_view element) const {
    for (const XmlElement& candidate : children) {
        if (candidate.name == element) return &candidate;
    }
    return nullptr;
}

Result<XmlElement> parseXml(std::string_view document, std::string_view where) {
    return XmlReader{document, where}.read();
}

}  // namespace plumb
