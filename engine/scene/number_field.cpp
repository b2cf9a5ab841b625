#include "scene/number_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "math/vec2.hpp"

namespace plumb {

namespace {

/// "gravity.y" is part 1 of gravity. @return  -1 for no part
int takePart(std::string_view& path) {
    if (path.size() < 3 || path[path.size() - 2] != '.') return -1;
    const char letter = path.back();
    if (letter != 'x' && letter != 'y') return -1;
    path.remove_suffix(2);
    return letter == 'x' ? 0 : 1;
}

bool isNumber(FieldKind kind, int part) {
    if (kind == FieldKind::Vec2) return part >= 0;
    const bool one = kind == FieldKind::Bool || kind == FieldKind::Int || kind == FieldKind::Float ||
                     kind == FieldKind::Enum;
    return one && part < 0;
}

template <class T>
T bytesAs(const void* from) {
    T value;
    std::memcpy(&value, from, sizeof(T));
    return value;
}

std::int64_t wholeAt(const void* from, const FieldInfo& field) {
    const bool isSigned = field.kind == FieldKind::Int && field.isSigned;
    switch (field.size) {
        case 1: return isSigned ? bytesAs<std::int8_t>(from) : bytesAs<std::uint8_t>(from);
        case 2: return isSigned ? bytesAs<std::int16_t>(from) : bytesAs<std::uint16_t>(from);
        case 4: return isSigned ? bytesAs<std::int32_t>(from) : bytesAs<std::uint32_t>(from);
        default: return bytesAs<std::int64_t>(from);
    }
}

/// The same bytes whether they have a sign or not.
void putWhole(void* to, std::size_t size, std::int64_t value) {
    const auto put = [to](auto narrow) { std::memcpy(to, &narrow, sizeof(narrow)); };
    switch (size) {
        case 1: return put(static_cast<std::uint8_t>(value));
        case 2: return put(static_cast<std::uint16_t>(value));
        case 4: return put(static_cast<std::uint32_t>(value));
        default: return put(value);
    }
}

}  // namespace

std::optional<NumberField> NumberField::find(const TypeRegistry& types, std::string_view component,
                                             std::string_view path) {
    const TypeInfo* type = types.find(component);
    if (type == nullptr) return {};
    const int part = takePart(path);
    const FieldInfo* field = type->find(path);
    if (field == nullptr || !isNumber(field->kind, part)) return {};
    return NumberField{*type, *field, part};
}

float NumberField::read(const void* component) const {
    const void* at = field_->in(component);
    switch (field_->kind) {
        case FieldKind::Bool: return bytesAs<bool>(at) ? 1.0f : 0.0f;
        case FieldKind::Float: return bytesAs<float>(at);
        case FieldKind::Vec2: return part_ == 0 ? bytesAs<Vec2>(at).x : bytesAs<Vec2>(at).y;
        default: return static_cast<float>(wholeAt(at, *field_));
    }
}

void NumberField::write(void* component, float value) const {
    void* at = field_->in(component);
    value = std::clamp(value, field_->min, field_->max);
    if (field_->kind == FieldKind::Float) {
        std::memcpy(at, &value, sizeof(value));
    } else if (field_->kind == FieldKind::Vec2) {
        auto vector = bytesAs<Vec2>(at);
        (part_ == 0 ? vector.x : vector.y) = value;
        std::memcpy(at, &vector, sizeof(vector));
    } else if (field_->kind == FieldKind::Bool) {
        const bool on = value >= 0.5f;
        std::memcpy(at, &on, sizeof(on));
    } else {
        putWhole(at, field_->size, static_cast<std::int64_t>(std::floor(value + 0.5f)));
    }
}

}  // namespace plumb
