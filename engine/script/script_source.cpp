#include "script/script_source.hpp"

#include <algorithm>
#include <vector>

#include "core/text.hpp"

namespace plumb {
namespace {

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

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
    void skipLine() { at_ = std::min(text_.find('\n', at_), text_.size()); }
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
            while (at_ < text_.size() && (text_[at_] == ' ' || (text_[at_] >= '\t' && text_[at_] <= '\r')))
                ++at_;
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
            if (text_[at_] == '\n') return;  // an error that Lua reports
            if (text_[at_] == '\\') ++at_;
        }
        at_ = std::min(at_ + 1, text_.size());
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
                continue;
            }
            visit(token);
        }
        copyTo(text_.size());
        return std::move(out_);
    }

private:
    enum class Block : unsigned char { Plain, LoopHead };

    void visit(const Token& token) {
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
            skipParameters();
        } else if (token.text == "if") {
            open_.push_back(Block::Plain);
        } else if (token.text == "end" || token.text == "until") {
            if (!open_.empty()) open_.pop_back();
        } else if (token.text == "goto") {
            insertAfter(token.end - token.text.size());
        }
    }

    /// Parameters contain no parentheses.
    void skipParameters() {
        Token token = lexer_.next();
        while (token.kind != Token::Kind::End && !token.is(")")) token = lexer_.next();
        if (token.kind != Token::Kind::End) insertAfter(token.end);
    }

    void copyTo(std::size_t offset) {
        out_ += text_.substr(copied_, offset - copied_);
        copied_ = offset;
    }
    void insertAfter(std::size_t offset) {
        copyTo(offset);
        out_ += format(" {}={}-1 if {}<0 then {}() end ", kBudget, kBudget, kBudget, kOverBudget);
    }
    [[nodiscard]] Error powerError(std::size_t offset) const {
        return {format("{}:{}", name_, lexer_.lineOf(offset)),
                "powers other than ^2 have different last digits on different machines",
                "write math.pow(x, y), or products"};
    }

    std::string_view text_;
    std::string_view name_;
    Lexer lexer_;
    std::string out_;
    std::size_t copied_ = 0;   // offset up to which the text was copied
    std::vector<Block> open_;  // blocks and heads of loops that are open
};

}  // namespace

Result<std::string> prepareScript(std::string_view text, std::string_view name) {
    if (!isUtf8(text)) return Error{std::string{name}, "the file is not UTF-8 text", "save it as UTF-8"};
    return Preparation{text, name}.run();
}

}  // namespace plumb
