#include "reflect/convert_component.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include "reflect/compare.hpp"
#include "reflect/curve_field.hpp"
#include "reflect/whole_number.hpp"

namespace plumb {
namespace {

template <class Number>
const EnumName* nameOf(const FieldInfo& field, Number number) {
    const auto found = std::find_if(field.names.begin(), field.names.end(), [&](const EnumName& name) {
        if constexpr (std::is_same_v<Number, double>) {
            return static_cast<double>(name.value) == number;
        } else {
            return std::cmp_equal(name.value, number);
        }
    });
    return found == field.names.end() ? nullptr : &*found;
}

std::int64_t wholeIn(const FieldInfo& field, const void* at) {
    const bool isSigned = field.kind == FieldKind::Int ? field.isSigned : field.size != 1;
    return loadWhole(at, field.size, isSigned);
}

/// Limits a number that an Int field can hold to the field's range.
template <class Whole>
Whole inRange(const FieldInfo& field, Whole number) {
    const auto value = static_cast<double>(number);
    const double low = std::ceil(double{field.min}), high = std::floor(double{field.max});
    if (value < low) {
        constexpr auto kMost = static_cast<double>(std::numeric_limits<Whole>::max());
        number = low < kMost ? static_cast<Whole>(low) : std::numeric_limits<Whole>::max();
    } else if (value > high) {
        constexpr auto kLeast = static_cast<double>(std::numeric_limits<Whole>::min());
        number = high > kLeast ? static_cast<Whole>(high) : std::numeric_limits<Whole>::min();
    }
    return number;
}

/// Limits a number to those from `low` to `high`. @param number  of any type, rounded if it is a double
template <class Whole, class Number>
Whole toWhole(Number number, Whole low, Whole high) {
    if constexpr (std::is_same_v<Number, double>) {
        number = std::round(number);
        // The largest numbers of 8 bytes are no doubles: they become the power of two above them.
        if (number <= static_cast<double>(low)) return low;
        return number >= static_cast<double>(high) ? high : static_cast<Whole>(number);
    } else {
        if (std::cmp_less(number, low)) return low;
        return std::cmp_greater(number, high) ? high : static_cast<Whole>(number);
    }
}

template <class Whole, class Number>
void storeWithin(const FieldInfo& field, void* at, Number number, Whole low, Whole high) {
    // Limited twice, as the range of a field may include numbers for which it has too few bytes.
    const Whole kept = toWhole(inRange(field, toWhole(number, low, high)), low, high);
    storeWhole(at, field.size, static_cast<std::uint64_t>(kept));
}

template <class Number>
void storeInt(const FieldInfo& field, void* at, Number number) {
    const std::size_t unused = 64 - field.size * 8;  // bits
    if (field.isSigned) {
        const std::int64_t high = std::numeric_limits<std::int64_t>::max() >> unused;
        storeWithin(field, at, number, -high - 1, high);
    } else {
        const std::uint64_t high = std::numeric_limits<std::uint64_t>::max() >> unused;
        storeWithin(field, at, number, std::uint64_t{0}, high);
    }
}

/// Stores a float; one without limits may also be infinite.
void storeFloat(const FieldInfo& field, void* at, float value) {
    if (value < field.min && field.min != std::numeric_limits<float>::lowest()) value = field.min;
    if (value > field.max && field.max != std::numeric_limits<float>::max()) value = field.max;
    std::memcpy(at, &value, sizeof value);
}

template <class Number>
void storeNumber(const FieldInfo& field, void* at, Number number) {
    switch (field.kind) {
        case FieldKind::Bool: storeWhole(at, field.size, number != Number{} ? 1 : 0); return;
        case FieldKind::Float: storeFloat(field, at, static_cast<float>(number)); return;
        case FieldKind::Enum:
            if (const EnumName* name = nameOf(field, number))
                storeWhole(at, field.size, static_cast<std::uint64_t>(name->value));
            return;
        default: storeInt(field, at, number);
    }
}

void convertFloat(float value, const FieldInfo& now, void* to) {
    if (now.kind == FieldKind::Float) {
        storeFloat(now, to, value);
    } else if (!std::isnan(value)) {
        storeNumber(now, to, double{value});
    }
}

void convertEnum(const FieldInfo& before, const void* from, const FieldInfo& now, void* to) {
    const EnumName* name = nameOf(before, wholeIn(before, from));
    if (name == nullptr) return;
    for (const EnumName& other : now.names) {
        if (other.name == name->name) storeNumber(now, to, std::int64_t{other.value});
    }
}

void convertNumber(const FieldInfo& before, const void* from, const FieldInfo& now, void* to) {
    if (before.kind == FieldKind::Float) {
        float value = 0.0f;
        std::memcpy(&value, from, sizeof value);
        convertFloat(value, now, to);
    } else if (before.kind == FieldKind::Enum && now.kind == FieldKind::Enum) {
        convertEnum(before, from, now, to);
    } else if (before.kind == FieldKind::Int && !before.isSigned) {
        storeNumber(now, to, static_cast<std::uint64_t>(wholeIn(before, from)));
    } else {
        storeNumber(now, to, wholeIn(before, from));
    }
}

void copyList(const FieldInfo& before, const void* from, const FieldInfo& now, void* to) {
    const std::size_t count = std::min<std::size_t>({before.countOf(from), before.capacity, now.capacity});
    std::memset(to, 0, now.capacity * now.elementSize);  // unused items have no value: see FixedList
    std::memcpy(to, from, count * now.elementSize);
    now.countOf(to) = static_cast<std::uint32_t>(count);
}

/// True if two fields, perhaps of other names and places, have the same values.
bool sameValues(const FieldInfo& a, const FieldInfo& b) {
    const auto sameName = [](const EnumName& x, const EnumName& y) {
        return x.name == y.name && x.value == y.value;
    };
    return a.kind == b.kind && a.element == b.element && a.asset == b.asset && a.size == b.size &&
           a.isSigned == b.isSigned && a.capacity == b.capacity && a.elementSize == b.elementSize &&
           a.min == b.min && a.max == b.max &&
           std::equal(a.names.begin(), a.names.end(), b.names.begin(), b.names.end(), sameName);
}

bool sameField(const FieldInfo& a, const FieldInfo& b) {
    return a.name == b.name && a.offset == b.offset && sameValues(a, b);
}

void convertField(const FieldInfo& before, const void* from, const FieldInfo& now, void* to) {
    if (sameValues(before, now)) {
        std::memcpy(to, from, now.size);
        return;
    }
    if (isNumber(before.kind) && isNumber(now.kind)) return convertNumber(before, from, now, to);
    if (before.kind != now.kind || before.asset != now.asset || isCurve(before) != isCurve(now)) return;
    if (now.kind != FieldKind::List || isCurve(now)) {
        if (before.size == now.size) std::memcpy(to, from, now.size);
    } else if (before.element == now.element && before.elementSize == now.elementSize) {
        copyList(before, from, now, to);
    }
}

bool hasDefault(const TypeInfo& type, const FieldInfo& field, const void* object) {
    return !type.defaults.empty() && fieldsEqual(field, type.defaults.data(), object);
}

}  // namespace

bool isNumber(FieldKind kind) {
    return kind == FieldKind::Bool || kind == FieldKind::Int || kind == FieldKind::Float ||
           kind == FieldKind::Enum;
}

const FieldInfo* formerField(const TypeInfo& before, const FieldInfo& field) {
    if (const FieldInfo* former = before.find(field.name)) return former;
    return field.was.empty() ? nullptr : before.find(field.was);
}

void convertComponent(const TypeInfo& before, const void* from, const TypeInfo& now, void* to) {
    for (const FieldInfo& field : now.fields) {
        const FieldInfo* former = formerField(before, field);
        if (former != nullptr && !hasDefault(before, *former, from))
            convertField(*former, former->in(from), field, field.in(to));
    }
}

bool sameLayout(const TypeInfo& a, const TypeInfo& b) {
    return a.key == b.key && a.size == b.size && a.alignment == b.alignment && a.defaults == b.defaults &&
           std::equal(a.fields.begin(), a.fields.end(), b.fields.begin(), b.fields.end(), sameField);
}

}  // namespace plumb
