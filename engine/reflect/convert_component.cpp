#include "reflect/convert_component.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include "reflect/whole_number.hpp"

namespace plumb {
namespace {

bool isNumber(FieldKind kind) {
    return kind == FieldKind::Bool || kind == FieldKind::Int || kind == FieldKind::Float ||
           kind == FieldKind::Enum;
}

double numberIn(const FieldInfo& field, const void* at) {
    if (field.kind == FieldKind::Float) {
        float number = 0.0f;
        std::memcpy(&number, at, sizeof number);
        return static_cast<double>(number);
    }
    return static_cast<double>(loadWhole(at, field.size, field.kind == FieldKind::Int && field.isSigned));
}

const EnumName* nameOf(const FieldInfo& field, double value) {
    const auto found = std::find_if(field.names.begin(), field.names.end(), [&](const EnumName& name) {
        return static_cast<double>(name.value) == value;
    });
    return found == field.names.end() ? nullptr : &*found;
}

/// The limits of an Int: those of the field, and of its bytes up to 2^53, above which a double is not exact.
double limited(const FieldInfo& field, double number) {
    const double values = std::exp2(std::min(static_cast<double>(field.size) * 8.0, 53.0));
    const double low = field.isSigned ? -values / 2.0 : 0.0;
    const double high = field.isSigned ? values / 2.0 - 1.0 : values - 1.0;
    number = std::clamp(std::round(number), low, high);
    return std::clamp(number, std::min(std::ceil(double{field.min}), high),
                      std::max(std::floor(double{field.max}), low));
}

void storeNumber(const FieldInfo& field, void* at, double number) {
    switch (field.kind) {
        case FieldKind::Bool: storeWhole(at, field.size, number != 0.0 ? 1 : 0); return;
        case FieldKind::Float: {
            const auto value = std::clamp(static_cast<float>(number), field.min, field.max);
            std::memcpy(at, &value, sizeof value);
            return;
        }
        case FieldKind::Enum:
            if (const EnumName* name = nameOf(field, number))
                storeWhole(at, field.size, static_cast<std::uint64_t>(name->value));
            return;
        default:
            storeWhole(at, field.size,
                       static_cast<std::uint64_t>(static_cast<std::int64_t>(limited(field, number))));
    }
}

void convertNumber(const FieldInfo& before, const void* from, const FieldInfo& now, void* to) {
    const double number = numberIn(before, from);
    if (std::isnan(number)) return;
    if (before.kind == FieldKind::Enum && now.kind == FieldKind::Enum) {
        const EnumName* name = nameOf(before, number);
        if (name == nullptr) return;
        for (const EnumName& other : now.names) {
            if (other.name == name->name) storeNumber(now, to, static_cast<double>(other.value));
        }
        return;
    }
    storeNumber(now, to, number);
}

void copyList(const FieldInfo& before, const void* from, const FieldInfo& now, void* to) {
    const std::size_t count = std::min<std::size_t>({before.countOf(from), before.capacity, now.capacity});
    std::memcpy(to, from, count * now.elementSize);
    now.countOf(to) = static_cast<std::uint32_t>(count);
}

void convertField(const FieldInfo& before, const void* from, const FieldInfo& now, void* to) {
    if (isNumber(before.kind) && isNumber(now.kind)) return convertNumber(before, from, now, to);
    if (before.kind != now.kind || before.asset != now.asset) return;
    if (now.kind != FieldKind::List) {
        if (before.size == now.size) std::memcpy(to, from, now.size);
    } else if (before.element == now.element && before.elementSize == now.elementSize) {
        copyList(before, from, now, to);
    }
}

bool sameField(const FieldInfo& a, const FieldInfo& b) {
    const auto sameName = [](const EnumName& x, const EnumName& y) {
        return x.name == y.name && x.value == y.value;
    };
    return a.name == b.name && a.kind == b.kind && a.element == b.element && a.asset == b.asset &&
           a.size == b.size && a.isSigned == b.isSigned && a.offset == b.offset && a.capacity == b.capacity &&
           a.elementSize == b.elementSize &&
           std::equal(a.names.begin(), a.names.end(), b.names.begin(), b.names.end(), sameName);
}

}  // namespace

namespace {

bool hasDefault(const TypeInfo& type, const FieldInfo& field, const void* object) {
    return !type.defaults.empty() &&
           std::memcmp(field.in(type.defaults.data()), field.in(object), field.size) == 0;
}

}  // namespace

void convertComponent(const TypeInfo& before, const void* from, const TypeInfo& now, void* to) {
    for (const FieldInfo& field : now.fields) {
        const FieldInfo* former = before.find(field.name);
        if (former == nullptr && !field.was.empty()) former = before.find(field.was);
        if (former != nullptr && !hasDefault(before, *former, from))
            convertField(*former, former->in(from), field, field.in(to));
    }
}

bool sameLayout(const TypeInfo& a, const TypeInfo& b) {
    return a.key == b.key && a.size == b.size && a.alignment == b.alignment && a.defaults == b.defaults &&
           std::equal(a.fields.begin(), a.fields.end(), b.fields.begin(), b.fields.end(), sameField);
}

}  // namespace plumb
