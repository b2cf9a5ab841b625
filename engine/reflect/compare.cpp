#include "reflect/compare.hpp"

#include <algorithm>
#include <cstring>

#include "reflect/curve_field.hpp"

namespace plumb {
namespace {

std::size_t listBytes(const FieldInfo& field, const void* list) {
    return std::min<std::size_t>(field.countOf(list), field.capacity) * field.elementSize;
}

}  // namespace

bool valuesEqual(const FieldInfo& field, const void* a, const void* b) {
    if (isCurve(field)) return std::memcmp(a, b, sizeof(Curve)) == 0;
    switch (field.kind) {
        case FieldKind::List: {
            const std::size_t bytes = listBytes(field, a);
            return bytes == listBytes(field, b) && std::memcmp(a, b, bytes) == 0;
        }
        case FieldKind::Bool:
        case FieldKind::Int:
        case FieldKind::Float:
        case FieldKind::Vec2:
        case FieldKind::Rect:
        case FieldKind::Color:
        case FieldKind::Text:
        case FieldKind::Enum:
        case FieldKind::Entity:
        case FieldKind::Asset:
        case FieldKind::Tiles: break;
    }
    return std::memcmp(a, b, field.size) == 0;
}

bool fieldsEqual(const FieldInfo& field, const void* a, const void* b) {
    return valuesEqual(field, field.in(a), field.in(b));
}

bool componentsEqual(const TypeInfo& type, const void* a, const void* b) {
    return std::all_of(type.fields.begin(), type.fields.end(),
                       [a, b](const FieldInfo& field) { return fieldsEqual(field, a, b); });
}

void copyField(const FieldInfo& field, void* to, const void* from) {
    std::memcpy(field.in(to), field.in(from), field.size);
}

}  // namespace plumb
