#include "editor/model/document/field_number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/text.hpp"
#include "reflect/curve_field.hpp"
#include "reflect/whole_number.hpp"

namespace plumb::editor {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Returns the shortest decimal number that rounds to this float.
double asTyped(float number) {
    const std::string text = shortestText(number);
    double typed = double{number};
    std::from_chars(text.data(), text.data() + text.size(), typed);
    return typed;
}

FieldKind kindOfNumbers(const FieldInfo& field) {
    return field.kind == FieldKind::List ? field.element : field.kind;
}

bool isWhole(const FieldInfo& field) { return kindOfNumbers(field) == FieldKind::Int; }

/// Returns the factor from a number in memory to the number shown.
double shownFactor(const FieldInfo& field) {
    return field.unit == Unit::Radians || field.unit == Unit::RadiansPerSecond ? kDegrees : 1.0;
}

/// Returns the range of the field's type. Integers are limited to 2^53, above which a double is not exact.
NumberRange rangeOfBytes(const FieldInfo& field) {
    if (!isWhole(field)) {
        const double max = double{std::numeric_limits<float>::max()};
        return {-max, max, false};
    }
    const double values = std::exp2(std::min<double>(static_cast<double>(numberSize(field)) * 8.0, 53.0));
    return field.isSigned ? NumberRange{-values / 2.0, values / 2.0 - 1.0, false}
                          : NumberRange{0.0, values - 1.0, false};
}

}  // namespace

bool hasNumbers(const FieldInfo& field) {
    if (isCurve(field)) return false;
    switch (kindOfNumbers(field)) {
        case FieldKind::Int: return !field.layerBits;
        case FieldKind::Float:
        case FieldKind::Vec2:
        case FieldKind::Rect: return true;
        default: return false;
    }
}

std::size_t numberSize(const FieldInfo& field) {
    if (!isWhole(field)) return sizeof(float);
    return field.kind == FieldKind::List ? field.elementSize : field.size;
}

double numberAt(const FieldInfo& field, const FieldValue& value, std::size_t at) {
    const std::byte* from = value.bytes.data() + at;
    if (isWhole(field)) {
        const std::int64_t whole = loadWhole(from, numberSize(field), field.isSigned);
        return field.isSigned ? static_cast<double>(whole)
                              : static_cast<double>(static_cast<std::uint64_t>(whole));
    }
    float number = 0.0f;
    std::memcpy(&number, from, sizeof number);
    const float shown = static_cast<float>(double{number} * shownFactor(field));
    if (!std::isfinite(shown)) return double{shown};
    return asTyped(shown);
}

void setNumberAt(const FieldInfo& field, FieldValue& value, double number, std::size_t at) {
    const NumberRange range = numberRange(field);
    // Typing the number that is already shown must not change the last digits of the value in memory.
    if (number == numberAt(field, value, at) && number >= range.min && number <= range.max) return;
    number = std::clamp(number, range.min, range.max);
    std::byte* to = value.bytes.data() + at;
    if (isWhole(field)) {
        const double whole = std::round(number);
        const auto bits = whole < 0.0 ? static_cast<std::uint64_t>(static_cast<std::int64_t>(whole))
                                      : static_cast<std::uint64_t>(whole);
        storeWhole(to, numberSize(field), bits);
        return;
    }
    const double factor = shownFactor(field);
    auto exact = static_cast<float>(number / factor);
    // Rounding in the conversion can put a value at a limit, like 90 degrees, just outside the range.
    if (range.limited) exact = std::clamp(exact, field.min, field.max);
    std::memcpy(to, &exact, sizeof exact);
}

NumberRange numberRange(const FieldInfo& field) {
    NumberRange range = rangeOfBytes(field);
    const double factor = shownFactor(field);
    const bool lower = field.min > std::numeric_limits<float>::lowest();
    const bool upper = field.max < std::numeric_limits<float>::max();
    if (lower) range.min = std::max(range.min, double{field.min} * factor);
    if (upper) range.max = std::min(range.max, double{field.max} * factor);
    range.limited = lower || upper;
    return range;
}

double numberStep(const FieldInfo& field) {
    if (field.step > 0.0f) return asTyped(field.step) * shownFactor(field);
    if (isWhole(field)) return 0.2;
    switch (field.unit) {
        case Unit::Ratio:
        case Unit::Seconds: return 0.01;
        case Unit::Radians:
        case Unit::RadiansPerSecond:
        case Unit::Degrees:
        case Unit::Pixels:
        case Unit::PixelsPerSecond: return 1.0;
        case Unit::PixelsPerSecondSquared: return 5.0;
        default: return 0.1;
    }
}

std::string numberText(double number) {
    constexpr double kWide = 1e7;  // floats this large have no digits after the decimal point
    constexpr double kTiny = 1e-3;
    const double size = std::fabs(number);
    if (!std::isfinite(number) || size >= kWide || (size > 0.0 && size < kTiny)) return shortestText(number);
    std::string text = fixedText(number, 4);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

}  // namespace plumb::editor
