#include "editor/model/document/expression.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "core/text.hpp"

namespace plumb::editor {
namespace {

constexpr int kDeepest = 64;               // nesting depth of parentheses, signs and powers
constexpr std::size_t kMostArguments = 4;  // maximum number of a function's arguments

struct Function {
    std::string_view name;
    std::size_t arguments;
    double (*work)(const double* a);
};

double degreesFrom(double radians) { return radians * 180.0 / std::numbers::pi; }
double radiansFrom(double degrees) { return degrees * std::numbers::pi / 180.0; }

// sin, cos and tan take radians; rad(30) converts from degrees.
constexpr std::array kFunctions{
    Function{"sqrt", 1, [](const double* a) { return std::sqrt(a[0]); }},
    Function{"abs", 1, [](const double* a) { return std::fabs(a[0]); }},
    Function{"floor", 1, [](const double* a) { return std::floor(a[0]); }},
    Function{"ceil", 1, [](const double* a) { return std::ceil(a[0]); }},
    Function{"round", 1, [](const double* a) { return std::round(a[0]); }},
    Function{"min", 2, [](const double* a) { return std::fmin(a[0], a[1]); }},
    Function{"max", 2, [](const double* a) { return std::fmax(a[0], a[1]); }},
    Function{"clamp", 3, [](const double* a) { return std::fmin(std::fmax(a[0], a[1]), a[2]); }},
    Function{"lerp", 3, [](const double* a) { return a[0] + (a[1] - a[0]) * a[2]; }},
    Function{"pow", 2, [](const double* a) { return std::pow(a[0], a[1]); }},
    Function{"sin", 1, [](const double* a) { return std::sin(a[0]); }},
    Function{"cos", 1, [](const double* a) { return std::cos(a[0]); }},
    Function{"tan", 1, [](const double* a) { return std::tan(a[0]); }},
    Function{"asin", 1, [](const double* a) { return std::asin(a[0]); }},
    Function{"acos", 1, [](const double* a) { return std::acos(a[0]); }},
    Function{"atan", 1, [](const double* a) { return std::atan(a[0]); }},
    Function{"atan2", 2, [](const double* a) { return std::atan2(a[0], a[1]); }},
    Function{"deg", 1, [](const double* a) { return degreesFrom(a[0]); }},
    Function{"rad", 1, [](const double* a) { return radiansFrom(a[0]); }},
};

constexpr std::array kConstants{NamedNumber{"pi", std::numbers::pi},
                                NamedNumber{"tau", 2.0 * std::numbers::pi}};

// Not std::isdigit and std::isalpha, which depend on the locale.
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Recursive descent parser. Only the first error is kept; results after it are meaningless.
class Reader {
public:
    Reader(std::string_view text, std::size_t from, std::span<const NamedNumber> known)
        : text_{text}, at_{from}, known_{known} {}

    Result<double> whole() {
        const double value = sum();
        skipSpace();
        if (!error_ && at_ < text_.size()) fail(at_, format("expected an operator, found {}", found()));
        if (error_) return *error_;
        return value;
    }

private:
    double sum() {
        double value = product();
        while (!error_) {
            if (take('+')) {
                value += product();
            } else if (take('-')) {
                value -= product();
            } else {
                break;
            }
        }
        return value;
    }

    double product() {
        double value = signedNumber();
        while (!error_) {
            skipSpace();
            const std::size_t sign = at_;
            if (take('*')) {
                value *= signedNumber();
            } else if (take('/')) {
                value = divided(sign, value, signedNumber());
            } else if (take('%')) {
                const double by = signedNumber();
                if (by == 0.0) fail(sign, "division by 0");
                value = error_ ? 0.0 : std::fmod(value, by);
            } else {
                break;
            }
        }
        return value;
    }

    double divided(std::size_t sign, double value, double by) {
        if (!error_ && by == 0.0) fail(sign, "division by 0");
        return error_ ? 0.0 : value / by;
    }

    /// A power binds more tightly than a sign: -2^2 is -4.
    double signedNumber() {
        if (++depth_ > kDeepest) fail(at_, "the expression is nested too deeply");
        double value = 0.0;
        if (!error_) value = take('-') ? -signedNumber() : take('+') ? signedNumber() : power();
        --depth_;
        return value;
    }

    double power() {
        const double base = number();
        skipSpace();
        const std::size_t sign = at_;
        if (error_ || !take('^')) return base;
        return finite(sign, std::pow(base, signedNumber()), "the power is not a finite number");
    }

    double number() {
        skipSpace();
        const std::size_t start = at_;
        if (take('(')) {
            const double value = sum();
            close(start);
            return value;
        }
        const char next = at_ < text_.size() ? text_[at_] : '\0';
        if (isDigit(next) || next == '.') return digits();
        if (isLetter(next)) return word();
        fail(at_, format("expected a number, found {}", found()));
        return 0.0;
    }

    double digits() {
        double value = 0.0;
        const char* const first = text_.data() + at_;
        const auto [end, problem] = std::from_chars(first, text_.data() + text_.size(), value);
        if (problem == std::errc::result_out_of_range) {
            fail(at_, "the number is too large or too small");
        } else if (problem != std::errc{}) {
            fail(at_, "expected digits next to the decimal point");
        }
        const std::size_t start = std::exchange(at_, at_ + static_cast<std::size_t>(end - first));
        if (!error_ && at_ < text_.size() && (text_[at_] == '.' || isLetter(text_[at_])))
            fail(at_,
                 format("unexpected {} after the number \"{}\"", found(), text_.substr(start, at_ - start)));
        return value;
    }

    double word() {
        const std::size_t start = at_;
        while (at_ < text_.size() && (isLetter(text_[at_]) || isDigit(text_[at_]))) ++at_;
        const std::string_view name = text_.substr(start, at_ - start);
        const auto named = [name](const auto& one) { return one.name == name; };
        if (const auto word = std::find_if(known_.begin(), known_.end(), named); word != known_.end())
            return word->value;
        if (const auto word = std::find_if(kConstants.begin(), kConstants.end(), named);
            word != kConstants.end())
            return word->value;
        const auto function = std::find_if(kFunctions.begin(), kFunctions.end(), named);
        if (function != kFunctions.end()) return call(*function, start);
        fail(start, format("unknown name \"{}\"", name));
        if (error_) error_->remedy = format("use pi, tau, {}", expressionFunctions());
        return 0.0;
    }

    double call(const Function& function, std::size_t start) {
        skipSpace();
        const std::size_t bracket = at_;
        if (!take('(')) fail(at_, format("expected ( after {}, found {}", function.name, found()));
        std::array<double, kMostArguments> values{};
        for (std::size_t i = 0; i < function.arguments && !error_; ++i) {
            if (i > 0 && !take(','))
                fail(at_, format("{} needs {} numbers; expected a comma, found {}", function.name,
                                 function.arguments, found()));
            if (!error_) values[i] = sum();
        }
        close(bracket);
        return error_ ? 0.0
                      : finite(start, function.work(values.data()),
                               format("the result of {} is not a finite number", function.name));
    }

    double finite(std::size_t where, double value, std::string_view problem) {
        if (!error_ && !std::isfinite(value)) fail(where, std::string{problem});
        return error_ ? 0.0 : value;
    }

    void close(std::size_t opened) {
        if (error_ || take(')')) return;
        fail(at_, format("expected ) for the ( in column {}, found {}", opened + 1, found()));
    }

    [[nodiscard]] std::string found() const {
        if (at_ >= text_.size()) return "the end";
        // A character outside ASCII takes several bytes (UTF-8).
        std::size_t end = at_ + 1;
        while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xc0u) == 0x80u) ++end;
        const std::string_view letter = text_.substr(at_, end - at_);
        return isUtf8(letter) ? format("\"{}\"", letter) : std::string{"invalid UTF-8"};
    }

    bool take(char sign) {
        skipSpace();
        if (error_ || at_ >= text_.size() || text_[at_] != sign) return false;
        ++at_;
        return true;
    }

    void skipSpace() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    }

    void fail(std::size_t where, std::string what) {
        if (!error_) error_ = Error{format("column {}", where + 1), std::move(what), {}};
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::span<const NamedNumber> known_;
    int depth_ = 0;
    std::optional<Error> error_;
};

/// Returns the operator at the start of a text like `+=10` or `*2`, and the index after it; {0, 0} if there
/// is none.
std::pair<char, std::size_t> leadingSign(std::string_view text) {
    const std::size_t start = std::min(text.find_first_not_of(" \t"), text.size());
    const std::string_view rest = text.substr(start);
    if (rest.size() > 1 && rest[1] == '=' && std::string_view{"+-*/"}.find(rest[0]) != std::string_view::npos)
        return {rest[0], start + 2};
    if (!rest.empty() && (rest[0] == '*' || rest[0] == '/')) return {rest[0], start + 1};
    return {'\0', 0};
}

Result<double> finiteOr(double value, std::string_view problem) {
    if (std::isfinite(value)) return value;
    return Error{"column 1", std::string{problem}, {}};
}

}  // namespace

Result<double> evaluate(std::string_view text, std::span<const NamedNumber> known) {
    const Result<double> value = Reader{text, 0, known}.whole();
    return value ? finiteOr(*value, "the result is too large") : value;
}

std::string expressionFunctions() {
    std::string names;
    for (const Function& function : kFunctions) {
        names += names.empty() ? "" : ", ";
        names += function.name;
    }
    return names;
}

Result<double> typedNumber(std::string_view text, const TypedOver& old) {
    const std::array known{NamedNumber{"x", old.value}, NamedNumber{"i", static_cast<double>(old.index)},
                           NamedNumber{"n", static_cast<double>(old.count)}};
    const auto [sign, length] = leadingSign(text);
    const Result<double> typed = Reader{text, length, known}.whole();
    if (!typed) return typed;
    if (sign == '/' && *typed == 0.0) return Error{format("column {}", length), "division by 0", {}};
    const double value = sign == '+'   ? old.value + *typed
                         : sign == '-' ? old.value - *typed
                         : sign == '*' ? old.value * *typed
                         : sign == '/' ? old.value / *typed
                                       : *typed;
    return finiteOr(value, "the result is too large");
}

}  // namespace plumb::editor
