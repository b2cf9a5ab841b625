#include "scene/number_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "math/vec2.hpp"
#include "reflect/whole_number.hpp"

namespace plumb {

namespace {

/// Removes ".x" or ".y" from the end of a path. @return 0 for x, 1 for y, -1 for neither
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
        default:
            return static_cast<float>(
                loadWhole(at, field_->size, field_->kind == FieldKind::Int && field_->isSigned));
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
        storeWhole(at, field_->size,
                   static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value + 0.5f))));
    }
}

}  // namespace plumb
