#include "tests/app/code_reference/header_reader.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <regex>

#include "core/text.hpp"

namespace plumb::test {
namespace {

std::string replaced(const std::string& text, const char* pattern, const char* by) {
    return std::regex_replace(text, std::regex{pattern}, by);
}

bool isWordCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The text between two words with single spaces.
std::string inOneLine(std::string_view text) {
    return std::string{trimmed(replaced(std::string{text}, "\\s+", " "))};
}

/// Reads the declarations of one level: of a namespace or of a class.
class LevelReader {
public:
    LevelReader(std::string_view text, bool isPublic) : text_{text}, isPublic_{isPublic} {}

    std::vector<Declaration> read() {
        while (at_ < text_.size()) readNext();
        return std::move(found_);
    }

private:
    [[nodiscard]] bool begins(std::string_view word) const { return text_.substr(at_, word.size()) == word; }

    void readNext() {
        if (begins("//")) return readComment();
        if (begins("#")) {
            skipDirective();
        } else if (text_[at_] == '\n') {
            if (begins("\n\n")) endGroup();
            ++at_;
        } else if (text_[at_] == ' ' || text_[at_] == ';' || text_[at_] == '}') {
            ++at_;
        } else {
            readDeclaration();
        }
    }

    void endGroup() { isInGroup_ = false; }

    std::string_view takeLine() {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        const std::string_view line = text_.substr(at_, end - at_);
        at_ = end;
        return line;
    }

    void readComment() {
        const std::string_view line = takeLine();
        if (!startsWith(line, "///")) return endGroup();
        const std::string_view words = line.substr(3);
        if (startsWith(words, "     ")) return;  // code of an example
        if (!doc_.empty() && !trimmed(words).empty()) doc_ += ' ';
        doc_ += trimmed(words);
    }

    void skipDirective() {
        while (endsWith(takeLine(), "\\")) ++at_;
    }

    /// Reads up to the end of a declaration: its `;`, or the end of its body.
    void readDeclaration() {
        const std::size_t start = at_;
        int depth = 0;
        std::optional<std::size_t> body;
        for (; at_ < text_.size(); ++at_) {
            const char c = text_[at_];
            if (c == '(') ++depth;
            if (c == ')') --depth;
            if (depth > 0) continue;
            if (begins("//")) {
                takeLine();
            } else if (c == ';' || (c == ':' && isLabel(start))) {
                break;
            } else if (c == '{') {
                if (isNamespace(start)) return static_cast<void>(++at_);
                body = body.value_or(at_);
                skipBraces();
                if (isBodyOfFunction(start, *body)) break;
            }
        }
        const std::size_t end = at_;
        ++at_;
        add(text_.substr(start, end - start), body ? *body - start : end - start);
    }

    [[nodiscard]] bool isLabel(std::size_t start) const {
        const std::string_view word = text_.substr(start, at_ - start);
        return word == "public" || word == "private" || word == "protected";
    }
    [[nodiscard]] bool isNamespace(std::size_t start) const {
        const std::string_view words = text_.substr(start, at_ - start);
        return startsWith(words, "namespace ") || startsWith(words, "extern ");
    }
    /// Skips a block; afterwards at_ is at its closing brace.
    void skipBraces() {
        int depth = 0;
        for (; at_ < text_.size(); ++at_) {
            if (begins("//")) takeLine();
            if (begins("'{'") || begins("'}'")) at_ += 3;
            if (text_[at_] == '{') ++depth;
            if (text_[at_] == '}' && --depth == 0) return;
        }
    }
    /// True if the block that just ended is not the value of a variable or of a member in a constructor's
    /// list, and no type, after which a `;` follows.
    [[nodiscard]] bool isBodyOfFunction(std::size_t start, std::size_t body) const {
        if (text_.substr(start, body - start).find('(') == std::string_view::npos) return false;
        const std::size_t next = text_.find_first_not_of(" \n", at_ + 1);
        return next == std::string_view::npos ||
               (text_[next] != ',' && text_[next] != '{' && text_[next] != ';');
    }

    void add(std::string_view whole, std::size_t head) {
        Declaration made;
        made.doc = doc_.empty() ? docBehind() : doc_;
        doc_.clear();
        if (whole == "public" || whole == "private" || whole == "protected") {
            isPublic_ = whole == "public";
            return endGroup();
        }
        const std::string code = replaced(std::string{whole.substr(0, head)}, "//[^\n]*", "");
        made.signature = signatureOf(inOneLine(code));
        made.isType = std::regex_search(
            made.signature, std::regex{"^(template <[^{]*> )?(class|struct|enum class|enum) [A-Za-z]\\w*"});
        made.isFunction = !made.isType && made.signature.find('(') != std::string::npos;
        made.name = nameOf(made);
        if (!isPublic_ || !isForReaders(made, whole)) return;
        if (made.isType) readMembers(made, whole.substr(head));
        made.continues = made.doc.empty() && isInGroup_;
        isInGroup_ = isInGroup_ || !made.doc.empty();
        found_.push_back(std::move(made));
    }

    /// The comment behind the declaration that just ended.
    std::string docBehind() {
        std::string doc;
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        const std::size_t comment = text_.substr(at_, end - at_).find("///<");
        if (comment == std::string_view::npos) return doc;
        doc = trimmed(text_.substr(at_ + comment + 4, end - at_ - comment - 4));
        at_ = end;
        return doc;
    }

    /// Without attributes, list of initializers and value.
    static std::string signatureOf(std::string text) {
        text = replaced(text, "\\[\\[[^\\]]*\\]\\] ?", "");
        text = replaced(text, "\\b(inline|static constexpr|static|constexpr|explicit|virtual) ", "");
        text = replaced(text, "^(template <[^>]*>) requires .* (\\w+\\()", "$1 $2");
        text = replaced(text, "\\) ?: .*$", ")");
        text = replaced(text, "\\) (const )?(override|final)$", ") $1");
        return std::string{trimmed(text)};
    }

    static std::string nameOf(const Declaration& declaration) {
        std::string text = declaration.signature;
        if (declaration.isType)
            return replaced(text, "^(template <[^{]*> )?(class|struct|enum class|enum) (\\w+).*$", "$3");
        if (const std::size_t operators = text.find("operator"); operators != std::string::npos)
            return "operator";
        text = replaced(text, "^template <[^>]*> ", "");  // its parameters may be functions
        text = text.substr(0, text.find('('));
        text = replaced(text, " ?(=|\\[).*$", "");
        std::size_t start = text.size();
        while (start > 0 && isWordCharacter(text[start - 1])) --start;
        return text.substr(start);
    }

    /// False for what is in a header but of no use for the code of a game.
    static bool isForReaders(const Declaration& made, std::string_view whole) {
        for (const char* word : {"using ", "friend ", "static_assert", "~", "extern "})
            if (startsWith(made.signature, word)) return false;
        for (const char* word : {"= delete", "= default", "TypeInfo", "TypeKey"})
            if (whole.substr(0, whole.find('{')).find(word) != std::string_view::npos && !made.isType)
                return false;
        if (made.isFunction && made.signature.find("physics::") != std::string::npos) return false;
        if (made.isType && whole.find('{') == std::string_view::npos) return false;  // declared, not defined
        const bool isForEngine = made.name == "describe" || made.name == "addTo" || made.name == "operator";
        return !made.name.empty() && !isForEngine;
    }

    static void readMembers(Declaration& made, std::string_view body) {
        const std::string_view inside = body.substr(1, body.rfind('}') - 1);
        if (startsWith(made.signature, "enum")) {
            made.members = valuesOf(inside);
        } else {
            const bool isStruct = made.signature.find("struct ") != std::string::npos;
            made.members = LevelReader{inside, isStruct}.read();
        }
    }

    static std::vector<Declaration> valuesOf(std::string_view body) {
        std::vector<Declaration> values;
        static const std::regex kComment{"///?<?[^\n]*"};
        const std::string code = std::regex_replace(std::string{body}, kComment, "");
        for (const std::string_view part : split(code, ',')) {
            const std::string_view name = trimmed(part.substr(0, part.find('=')));
            if (name.empty()) continue;
            values.emplace_back();
            values.back().name = values.back().signature = name;
        }
        return values;
    }

    std::string_view text_;
    bool isPublic_;
    bool isInGroup_ = false;  ///< the declaration above has a comment, and no empty line follows it
    std::size_t at_ = 0;
    std::string doc_;
    std::vector<Declaration> found_;
};

}  // namespace

std::vector<Declaration> readHeader(std::string_view text) { return LevelReader{text, true}.read(); }

}  // namespace plumb::test
