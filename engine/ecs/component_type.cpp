#include "ecs/component_type.hpp"

#include <algorithm>
#include <cstring>
#include <deque>
#include <mutex>

#include "reflect/convert_component.hpp"
#include "reflect/curve_field.hpp"

namespace plumb {

namespace {

struct KnownTypes {
    std::mutex mutex;
    std::deque<ComponentType> types;

    ComponentType* find(TypeKey key) {
        for (ComponentType& type : types) {
            if (type.info.key == key) return &type;
        }
        return nullptr;
    }
};

KnownTypes& knownTypes() {
    static KnownTypes known;
    return known;
}

void describe(ComponentType& type, const TypeInfo& info) {
    type.info = info;
    type.name = info.name;
    type.info.name = type.name;
    type.nameHash = hashText(type.name);
    type.namesTiles = std::any_of(info.fields.begin(), info.fields.end(),
                                  [](const FieldInfo& field) { return field.kind == FieldKind::Tiles; });
}

}  // namespace

const ComponentType& componentTypeOf(const TypeInfo& info) {
    KnownTypes& known = knownTypes();
    const std::lock_guard lock{known.mutex};
    if (ComponentType* type = known.find(info.key)) {
        if (isReloadable(info.key) && !sameLayout(type->info, info)) describe(*type, info);
        return *type;
    }
    ComponentType& type = known.types.emplace_back();
    describe(type, info);
    return type;
}

const ComponentType& updateComponentType(const TypeInfo& info) {
    KnownTypes& known = knownTypes();
    const std::lock_guard lock{known.mutex};
    ComponentType* const type = known.find(info.key);
    ComponentType& updated = type != nullptr ? *type : known.types.emplace_back();
    describe(updated, info);
    return updated;
}

const ComponentType* findComponentType(TypeKey key) {
    KnownTypes& known = knownTypes();
    const std::lock_guard lock{known.mutex};
    return known.find(key);
}

const ComponentType* findComponentType(std::string_view name) {
    KnownTypes& known = knownTypes();
    const std::lock_guard lock{known.mutex};
    const auto found = std::find_if(known.types.begin(), known.types.end(),
                                    [name](const ComponentType& type) { return type.name == name; });
    return found == known.types.end() ? nullptr : &*found;
}

namespace {

std::uint64_t readWord(const void* at, std::size_t size) {
    std::uint64_t word = 0;
    std::memcpy(&word, at, size < 8 ? size : 8);  // little-endian machines only, as everywhere in the engine
    return word;
}

void hashFloats(Hasher& hasher, const void* at, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        float value = 0.0f;
        std::memcpy(&value, static_cast<const std::byte*>(at) + i * sizeof(float), sizeof(float));
        hasher.add(value);
    }
}

void hashValue(Hasher& hasher, FieldKind kind, const void* at, std::size_t size) {
    switch (kind) {
        case FieldKind::Float:
        case FieldKind::Vec2:
        case FieldKind::Rect: hashFloats(hasher, at, size / sizeof(float)); return;
        case FieldKind::Bool:
        case FieldKind::Int:
        case FieldKind::Enum:
        case FieldKind::Color:
        case FieldKind::Text:
        case FieldKind::Entity:
        case FieldKind::Asset:
        case FieldKind::Tiles: hasher.add(readWord(at, size)); return;
        case FieldKind::List: return;  // lists of lists do not exist
    }
}

void hashField(Hasher& hasher, const FieldInfo& field, const void* component) {
    const void* at = field.in(component);
    if (isCurve(field)) hasher.add(static_cast<std::uint64_t>(static_cast<const Curve*>(at)->shape));
    if (field.kind != FieldKind::List) {
        hashValue(hasher, field.kind, at, field.size);
        return;
    }
    const std::uint32_t count = field.countOf(at);
    hasher.add(std::uint64_t{count});
    for (std::uint32_t i = 0; i < count && i < field.capacity; ++i) {
        hashValue(hasher, field.element, static_cast<const std::byte*>(at) + i * field.elementSize,
                  field.elementSize);
    }
}

}  // namespace

void hashComponent(Hasher& hasher, const TypeInfo& type, const void* component) {
    if (type.size == 0) return;
    if (type.fields.empty()) {
        hasher.addBytes(component, type.size);
        return;
    }
    for (const FieldInfo& field : type.fields) {
        hashField(hasher, field, component);
    }
}

}  // namespace plumb
