#pragma once

// Parts of C++20 that the standard library of emscripten 3.1.6 (Debian 12) lacks: std::bit_cast,
// std::atomic_ref (a page has one thread), and <charconv> for floating point numbers. The toolchain file
// includes it in every file. It rounds as the others do, because strtod() and printf() of this C library are
// exact and know no locale.

#include <atomic>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <type_traits>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 14000

namespace plumb::web {

inline void parse(const char* text, char** end, float& value) { value = std::strtof(text, end); }
inline void parse(const char* text, char** end, double& value) { value = std::strtod(text, end); }

/// Length of the decimal number at the start of a text: digits, a point, an exponent; no sign but '-'.
inline std::size_t decimalLength(const char* first, const char* last) {
    const auto digits = [&](const char* at) {
        while (at != last && *at >= '0' && *at <= '9') ++at;
        return at;
    };
    const char* at = first;
    if (at != last && *at == '-') ++at;
    const char* whole = at;
    at = digits(at);
    std::size_t count = static_cast<std::size_t>(at - whole);
    if (at != last && *at == '.') {
        const char* fraction = at + 1;
        at = digits(fraction);
        count += static_cast<std::size_t>(at - fraction);
    }
    if (count == 0) return 0;
    if (at != last && (*at == 'e' || *at == 'E')) {
        const char* exponent = at + 1;
        if (exponent != last && (*exponent == '-' || *exponent == '+')) ++exponent;
        const char* end = digits(exponent);
        if (end != exponent) at = end;
    }
    return static_cast<std::size_t>(at - first);
}

template <class Number>
std::from_chars_result read(const char* first, const char* last, Number& value) {
    const std::size_t length = decimalLength(first, last);
    if (length == 0) return {first, std::errc::invalid_argument};
    const std::string text(first, length);
    Number number{};
    parse(text.c_str(), nullptr, number);
    const bool isZero = text.find_first_of("123456789") >= text.find_first_of("eE");
    if (std::isinf(number) || (number == 0 && !isZero))
        return {first + length, std::errc::result_out_of_range};
    value = number;
    return {first + length, std::errc{}};
}

inline std::to_chars_result put(char* first, char* last, const char* text, int count) {
    if (last - first < count) return {last, std::errc::value_too_large};
    std::memcpy(first, text, static_cast<std::size_t>(count));
    return {first + count, std::errc{}};
}

/// The shortest digits that are read back as the same number; in scientific notation only where that is
/// shorter.
template <class Number>
std::to_chars_result shortest(char* first, char* last, Number value) {
    if (std::isnan(value))
        return std::signbit(value) ? put(first, last, "-nan", 4) : put(first, last, "nan", 3);
    if (std::isinf(value)) return value < 0 ? put(first, last, "-inf", 4) : put(first, last, "inf", 3);
    char scientific[48];
    int count = 0;
    for (int digits = 0; digits < 17; ++digits) {
        count = std::snprintf(scientific, sizeof scientific, "%.*e", digits, static_cast<double>(value));
        Number again{};
        parse(scientific, nullptr, again);
        if (again == value) break;
    }
    const int exponent = std::atoi(std::strchr(scientific, 'e') + 1);
    const char* point = std::strchr(scientific, '.');
    const int decimals = point == nullptr ? 0 : static_cast<int>(std::strchr(scientific, 'e') - point) - 1;
    char plain[400];
    const int places = decimals > exponent ? decimals - exponent : 0;
    const int plainCount = std::snprintf(plain, sizeof plain, "%.*f", places, static_cast<double>(value));
    return plainCount <= count ? put(first, last, plain, plainCount) : put(first, last, scientific, count);
}

}  // namespace plumb::web

namespace std {

template <class T>
class atomic_ref {
public:
    explicit atomic_ref(T& value) : value_{value} {}
    T load(memory_order = memory_order_seq_cst) const { return value_; }
    void store(T value, memory_order = memory_order_seq_cst) const { value_ = value; }
    bool compare_exchange_weak(T& expected, T wanted, memory_order = memory_order_seq_cst,
                               memory_order = memory_order_seq_cst) const {
        if (value_ == expected) {
            value_ = wanted;
            return true;
        }
        expected = value_;
        return false;
    }
    bool compare_exchange_strong(T& expected, T wanted, memory_order first = memory_order_seq_cst,
                                 memory_order second = memory_order_seq_cst) const {
        return compare_exchange_weak(expected, wanted, first, second);
    }
    T fetch_add(T count, memory_order = memory_order_seq_cst) const {
        const T before = value_;
        value_ = before + count;
        return before;
    }
    T fetch_or(T bits, memory_order = memory_order_seq_cst) const {
        const T before = value_;
        value_ = before | bits;
        return before;
    }

private:
    T& value_;
};

template <class To, class From>
requires(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> &&
         is_trivially_copyable_v<From>) constexpr To bit_cast(const From& from) noexcept {
    return __builtin_bit_cast(To, from);
}

inline from_chars_result from_chars(const char* first, const char* last, float& value) {
    return plumb::web::read(first, last, value);
}
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
    return plumb::web::read(first, last, value);
}
inline to_chars_result to_chars(char* first, char* last, float value) {
    return plumb::web::shortest(first, last, value);
}
inline to_chars_result to_chars(char* first, char* last, double value) {
    return plumb::web::shortest(first, last, value);
}
inline to_chars_result to_chars(char* first, char* last, double value, chars_format, int precision) {
    char text[400];
    const int count = snprintf(text, sizeof text, "%.*f", precision, value);
    return plumb::web::put(first, last, text, count);
}

}  // namespace std

#endif
