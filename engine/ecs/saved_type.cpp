#include "ecs/saved_type.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "ecs/component_type.hpp"
#include "reflect/convert_component.hpp"

namespace plumb {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 20;  ///< of a component
constexpr std::size_t kMostFields = 1024;
constexpr std::size_t kMostNames = 1024;  ///< of an enum

/// The bytes of one value of this kind; 0: several are possible.
std::size_t bytesOf(FieldKind kind) {
    switch (kind) {
        case FieldKind::Bool: return 1;
        case FieldKind::Float:
        case FieldKind::Color:
        case FieldKind::Tiles: return 4;
        case FieldKind::Vec2:
        case FieldKind::Text:
        case FieldKind::Asset:
        case FieldKind::Entity: return 8;
        case FieldKind::Rect: return 16;
        case FieldKind::Int:
        case FieldKind::Enum:
        case FieldKind::List: return 0;
    }
    return 0;
}

bool isWhole(std::size_t bytes) { return bytes == 1 || bytes == 2 || bytes == 4 || bytes == 8; }

/// True if reading the field from a value of its type stays inside the value.
bool isSafe(const FieldInfo& field, std::size_t typeBytes) {
    if (field.kind > FieldKind::List || field.element > FieldKind::List || field.size == 0 ||
        field.size > typeBytes || field.offset > typeBytes - field.size)
        return false;
    if (field.kind == FieldKind::Int || field.kind == FieldKind::Enum) return isWhole(field.size);
    if (field.kind != FieldKind::List) return field.size == bytesOf(field.kind);
    return field.elementSize > 0 && field.elementSize <= field.size &&
           field.capacity <= field.size / field.elementSize && field.countOffset % 4 == 0 &&
           field.offset % 4 == 0 && field.size >= 4 && field.countOffset <= field.size - 4;
}

/// The numbers of a field that its values depend on.
struct FieldNumbers {
    std::uint8_t kind, element, asset, isSigned;
    float min, max;
    std::uint32_t size, capacity, elementSize, offset, countOffset;
};

FieldNumbers numbersOf(const FieldInfo& field) {
    const auto narrow = [](std::size_t number) { return static_cast<std::uint32_t>(number); };
    return {static_cast<std::uint8_t>(field.kind),
            static_cast<std::uint8_t>(field.element),
            static_cast<std::uint8_t>(field.asset),
            static_cast<std::uint8_t>(field.isSigned),
            field.min,
            field.max,
            narrow(field.size),
            narrow(field.capacity),
            narrow(field.elementSize),
            narrow(field.offset),
            narrow(field.countOffset)};
}

void setNumbers(FieldInfo& field, const FieldNumbers& numbers) {
    field.kind = static_cast<FieldKind>(numbers.kind);
    field.element = static_cast<FieldKind>(numbers.element);
    field.asset = static_cast<AssetKind>(numbers.asset);
    field.isSigned = numbers.isSigned != 0;
    field.min = numbers.min;
    field.max = numbers.max;
    field.size = numbers.size;
    field.capacity = numbers.capacity;
    field.elementSize = numbers.elementSize;
    field.offset = numbers.offset;
    field.countOffset = numbers.countOffset;
}

void writeText(StateArchive& archive, std::string_view text) {
    std::string copy{text};
    archive.text(copy);
}

std::string_view readText(StateArchive& archive, SavedType& type) {
    std::string& text = type.names.emplace_back();
    archive.text(text);
    return text;
}

}  // namespace

void writeType(StateArchive& archive, std::string_view name, const TypeInfo& type) {
    writeText(archive, name);
    std::uint64_t size = type.size;
    archive.number(size);
    archive.count(type.fields.size());
    for (const FieldInfo& field : type.fields) {
        writeText(archive, field.name);
        FieldNumbers numbers = numbersOf(field);
        archive.value(numbers);
        archive.count(field.names.size());
        for (const EnumName& each : field.names) {
            writeText(archive, each.name);
            int value = each.value;
            archive.value(value);
        }
    }
}

void readType(StateArchive& archive, SavedType& type) {
    archive.text(type.name);
    type.info.name = type.name;
    std::uint64_t size = 0;
    archive.number(size);
    if (size > kMostBytes) archive.fail();
    type.info.size = static_cast<std::size_t>(size);
    const std::size_t fields = archive.count(0);
    if (fields > kMostFields) archive.fail();
    for (std::size_t i = 0; i < fields && archive.ok(); ++i) {
        FieldInfo& field = type.info.fields.emplace_back();
        field.name = readText(archive, type);
        FieldNumbers numbers{};
        archive.value(numbers);
        setNumbers(field, numbers);
        if (!isSafe(field, type.info.size)) archive.fail();
        const std::size_t names = archive.count(0);
        if (names > kMostNames) archive.fail();
        for (std::size_t k = 0; k < names && archive.ok(); ++k) {
            EnumName& each = field.names.emplace_back();
            each.name = readText(archive, type);
            archive.value(each.value);
        }
    }
}

bool sameFields(const TypeInfo& saved, const TypeInfo& now) {
    if (saved.fields.empty() || now.fields.empty())
        return saved.fields.empty() && now.fields.empty() && saved.size == now.size;
    TypeInfo same = saved;
    same.key = now.key;
    same.alignment = now.alignment;
    same.defaults = now.defaults;
    return sameLayout(same, now);
}

void archiveFields(StateArchive& archive, const TypeInfo& type, void* value) {
    if (!archive.reading()) {
        writeType(archive, type.name, type);
        archive.block(value, type.size);
        return;
    }
    SavedType saved;
    readType(archive, saved);
    if (!archive.ok()) return;
    std::vector<std::byte> bytes(saved.info.size);
    archive.block(bytes.data(), bytes.size());
    if (!archive.ok()) return;
    if (sameFields(saved.info, type)) {
        std::memcpy(value, bytes.data(), type.size);
    } else {
        convertComponent(saved.info, bytes.data(), type, value);
    }
}

void archiveKey(StateArchive& archive, TypeKey& key) {
    const ComponentType* const type = archive.reading() ? nullptr : findComponentType(key);
    std::string name{type != nullptr ? std::string_view{type->name} : typeNameOf(key)};
    if (key >= kMaxTypes) name.clear();
    archive.text(name);
    if (!archive.reading()) return;
    const ComponentType* const found = findComponentType(std::string_view{name});
    key = name.empty() ? kMaxTypes : found != nullptr ? found->info.key : findTypeKey(name);
}

}  // namespace plumb
