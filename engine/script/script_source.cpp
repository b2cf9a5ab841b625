#include "script/script_source.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/text.hpp"

namespace plumb {
namespace {

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// The parts of a Lua text that matter here; everything else is a symbol of one character.
struct Token {
    enum class Kind : unsigned char { End, Word, Number, String, Symbol };
    Kind kind = Kind::End;
    std::string_view text;
    std::size_t end = 0;  // offset after it

    [[nodiscard]] bool is(std::string_view other) const {
        return (kind == Kind::Word || kind == Kind::Symbol) && text == other;
    }
};

/// Splits a Lua text into tokens; comments and white space are skipped. Source: Lua 5.4 reference
/// manual, 3.1.
class Lexer {
public:
    explicit Lexer(std::string_view text) : text_{text} {}

    Token next() {
        skipSpace();
        const std::size_t start = at_;
        if (start >= text_.size()) return {Token::Kind::End, {}, text_.size()};
        const char c = text_[start];
        Token::Kind kind = Token::Kind::Symbol;
        if (isLetter(c)) {
            kind = Token::Kind::Word;
            while (at_ < text_.size() && (isLetter(text_[at_]) || isDigit(text_[at_]))) ++at_;
        } else if (isDigit(c) || (c == '.' && isDigit(peek(1)))) {
            kind = Token::Kind::Number;
            skipNumber();
        } else if (c == '"' || c == '\'') {
            kind = Token::Kind::String;
            skipQuoted(c);
        } else if (const std::size_t level = longBracket(); level != kNone) {
            kind = Token::Kind::String;
            skipLong(level);
        } else {
            ++at_;
        }
        return {kind, text_.substr(start, at_ - start), at_};
    }
    void skipLine() { at_ = std::min(text_.find_first_of("\r\n", at_), text_.size()); }
    [[nodiscard]] std::size_t lineOf(std::size_t offset) const {
        return 1 + static_cast<std::size_t>(
                       std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
    }

private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    [[nodiscard]] char peek(std::size_t ahead) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }
    void skipSpace() {
        for (;;) {
            while (isSpace(peek(0))) ++at_;
            if (peek(0) != '-' || peek(1) != '-') return;
            at_ += 2;
            if (const std::size_t level = longBracket(); level != kNone) {
                skipLong(level);
            } else {
                skipLine();
            }
        }
    }
    void skipNumber() {
        const bool isHex = peek(0) == '0' && (peek(1) == 'x' || peek(1) == 'X');
        if (isHex) at_ += 2;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            const bool exponent = isHex ? c == 'p' || c == 'P' : c == 'e' || c == 'E';
            if (exponent && (peek(1) == '+' || peek(1) == '-')) {
                at_ += 2;
            } else if (isDigit(c) || isLetter(c) || c == '.') {
                ++at_;
            } else {
                return;
            }
        }
    }
    void skipQuoted(char quote) {
        for (++at_; at_ < text_.size() && text_[at_] != quote; ++at_) {
            if (text_[at_] == '\n' || text_[at_] == '\r') return;  // an error that Lua reports
            if (text_[at_] == '\\') skipEscape();
        }
        at_ = std::min(at_ + 1, text_.size());
    }
    /// Moves to the last character of an escape sequence that may contain the end of a line; of the others,
    /// the first character is enough.
    void skipEscape() {
        ++at_;
        if (peek(0) == 'z') {
            while (isSpace(peek(1))) ++at_;
        } else if ((peek(0) == '\r' && peek(1) == '\n') || (peek(0) == '\n' && peek(1) == '\r')) {
            ++at_;
        }
    }
    /// The level of a long bracket "[==[" that starts here.
    [[nodiscard]] std::size_t longBracket() const {
        if (peek(0) != '[') return kNone;
        std::size_t level = 0;
        while (peek(1 + level) == '=') ++level;
        return peek(1 + level) == '[' ? level : kNone;
    }
    void skipLong(std::size_t level) {
        const std::string close = "]" + std::string(level, '=') + "]";
        const std::size_t found = text_.find(close, at_ + level + 2);
        at_ = found == std::string_view::npos ? text_.size() : found + close.size();
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

/// Copies a script and inserts the checks of the budget.
class Preparation {
public:
    Preparation(std::string_view text, std::string_view name) : text_{text}, name_{name}, lexer_{text} {}

    Result<std::string> run() {
        out_.reserve(text_.size() * 2);
        if (startsWith(text_, "#")) {  // "#!/usr/bin/lua": a comment
            out_ = "--";
            lexer_.skipLine();
        }
        for (Token token = lexer_.next(); token.kind != Token::Kind::End; token = lexer_.next()) {
            if (token.is("^")) {
                const Token exponent = lexer_.next();
                if (exponent.kind != Token::Kind::Number || exponent.text != "2")
                    return powerError(token.end);
                before_ = exponent;
                continue;
            }
            if (std::optional<Error> error = problemOf(token)) return std::move(*error);
            visit(token);
            before_ = token;
        }
        copyTo(text_.size());
        if (needsCount_) out_.insert(0, format("local {}=select ", kVarargCount));
        return std::move(out_);
    }

private:
    enum class Block : unsigned char { Plain, LoopHead, Table };

    /// What would lead out of the function around the script or past its budget.
    [[nodiscard]] std::optional<Error> problemOf(const Token& token) const {
        if (token.is(kBudget) || token.is(kOverBudget) || token.is(kVarargCount))
            return errorAt(token.end, format("the name {} is reserved", token.text), "use another name");
        if ((token.is("end") || token.is("until")) && open_.empty())
            return errorAt(token.end, format("'{}' closes nothing", token.text), "remove it");
        if (token.text == "__mode" || (token.kind == Token::Kind::String && isText(token.text, "__mode")))
            return errorAt(token.end, "__mode is not available: when it acts would differ between runs",
                           "set entries to nil");
        if (isCallOfMetatable(token) && !mayNameCall(token))
            return errorAt(token.end, "__call can be assigned by its function or in a constructor only",
                           "write function NAME.__call(...), or { __call = NAME } before setmetatable()");
        return std::nullopt;
    }
    [[nodiscard]] static bool isCallOfMetatable(const Token& token) {
        return token.is("__call") || (token.kind == Token::Kind::String && isText(token.text, "__call"));
    }
    /// A metatable whose __call is a table can make Lua hang. setmetatable() looks at it, so this is about
    /// what comes after: assignments other than of a function.
    [[nodiscard]] bool mayNameCall(const Token& token) const {
        if (!open_.empty() && open_.back() == Block::Table) return true;
        if (token.kind == Token::Kind::String) return !before_.is("[");
        Lexer ahead = lexer_;
        return ahead.next().is("(");
    }
    /// True for this text in quotes or long brackets: weak tables that get their mode after setmetatable().
    [[nodiscard]] static bool isText(std::string_view token, std::string_view text) {
        const std::size_t at = token.find(text);
        const std::string_view after = at == std::string_view::npos ? token : token.substr(at + text.size());
        return at != std::string_view::npos && token.find_first_not_of("'\"[=\r\n") == at &&
               after.find_first_not_of("'\"]=") == std::string_view::npos;
    }

    void visit(const Token& token) {
        if (inHead_) return visitHead(token);
        if (token.is("{")) open_.push_back(Block::Table);
        if (token.is("}") && !open_.empty() && open_.back() == Block::Table) open_.pop_back();
        if (token.kind != Token::Kind::Word) return;
        if (token.text == "while" || token.text == "for") {
            open_.push_back(Block::LoopHead);
        } else if (token.text == "do") {
            // The "do" of a loop ends its head, others open a block.
            if (!open_.empty() && open_.back() == Block::LoopHead) {
                open_.back() = Block::Plain;
                insertAfter(token.end);
            } else {
                open_.push_back(Block::Plain);
            }
        } else if (token.text == "repeat") {
            open_.push_back(Block::Plain);
            insertAfter(token.end);
        } else if (token.text == "function") {
            open_.push_back(Block::Plain);
            inHead_ = true;
            dots_ = 0;
        } else if (token.text == "if") {
            open_.push_back(Block::Plain);
        } else if (token.text == "end" || token.text == "until") {
            open_.pop_back();
        } else if (token.text == "goto") {
            insertAfter(token.end - token.text.size());
        }
    }

    /// The name and the parameters of a function, which contain no parentheses.
    void visitHead(const Token& token) {
        if (token.is(".")) ++dots_;
        if (token.is("(")) dots_ = 0;  // those of the name
        if (!token.is(")")) return;
        inHead_ = false;
        insertAfter(token.end, dots_ == 3);
    }

    void copyTo(std::size_t offset) {
        out_ += text_.substr(copied_, offset - copied_);
        copied_ = offset;
    }
    /// Each use of `...` copies all of its values, so a function with very many is stopped too.
    void insertAfter(std::size_t offset, bool hasVarargs = false) {
        constexpr int kMaxVarargs = 250;
        copyTo(offset);
        const std::string tooMany = hasVarargs ? format(" or {}('#',...)>{}", kVarargCount, kMaxVarargs) : "";
        out_ += format(" {}={}-1 if {}<0{} then {}() end ", kBudget, kBudget, kBudget, tooMany, kOverBudget);
        needsCount_ = needsCount_ || hasVarargs;
    }
    [[nodiscard]] Error errorAt(std::size_t offset, std::string what, std::string advice) const {
        return {format("{}:{}", name_, lexer_.lineOf(offset)), std::move(what), std::move(advice)};
    }
    [[nodiscard]] Error powerError(std::size_t offset) const {
        return errorAt(offset, "powers other than ^2 have different last digits on different machines",
                       "write math.pow(x, y), or products");
    }

    std::string_view text_;
    std::string_view name_;
    Lexer lexer_;
    std::string out_;
    std::size_t copied_ = 0;   // offset up to which the text was copied
    std::vector<Block> open_;  // blocks and heads of loops that are open
    bool inHead_ = false;      // in the name or the parameters of a function
    int dots_ = 0;             // of these
    bool needsCount_ = false;
    Token before_;  // the token before the one that is looked at
};

}  // namespace

Result<std::string> prepareScript(std::string_view text, std::string_view name) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (startsWith(text, kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    if (!isUtf8(text)) return Error{std::string{name}, "the file is not UTF-8 text", "save it as UTF-8"};
    return Preparation{text, name}.run();
}

}  // namespace plumb
