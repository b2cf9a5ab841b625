#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "core/hash.hpp"
#include "core/text.hpp"
#include "ecs/world.hpp"
#include "math/curve.hpp"
#include "tests/code/reload/layout.hpp"

// The component Changing as a test expects it: its fields, and what a value becomes when its field changes.

namespace plumb::test {

/// What a field may be.
struct FieldType {
    FieldKind kind = FieldKind::Float;
    std::uint32_t size = 4;
    bool isSigned = true;

    [[nodiscard]] bool isNumber() const {
        return kind == FieldKind::Bool || kind == FieldKind::Int || kind == FieldKind::Float ||
               kind == FieldKind::Enum;
    }
    friend bool operator==(const FieldType&, const FieldType&) = default;
};
inline constexpr std::array kNumberTypes{
    FieldType{FieldKind::Bool, 1}, FieldType{FieldKind::Int, 1},        FieldType{FieldKind::Int, 1, false},
    FieldType{FieldKind::Int, 2},  FieldType{FieldKind::Int, 4},        FieldType{FieldKind::Int, 4, false},
    FieldType{FieldKind::Int, 8},  FieldType{FieldKind::Int, 8, false}, FieldType{FieldKind::Float, 4}};
inline constexpr std::array kOtherTypes{
    FieldType{FieldKind::Enum, 4}, FieldType{FieldKind::Vec2, 8},
    FieldType{FieldKind::Text, 8}, FieldType{FieldKind::Entity, 8},
    FieldType{FieldKind::List, 0}, FieldType{FieldKind::List, sizeof(Curve)}};

/// The value of a field of any type.
struct Value {
    long double number = 0.0L;  ///< exact for every number
    std::string text;
    std::vector<float> floats;  ///< of a vector, a list or a curve
    int shape = 0;              ///< of a curve
    EntityId entity;

    friend bool operator==(const Value& a, const Value& b) {
        const bool numbers = a.number == b.number || (std::isnan(a.number) && std::isnan(b.number));
        return numbers && a.text == b.text && a.floats == b.floats && a.shape == b.shape &&
               a.entity == b.entity;
    }
};

/// For messages.
inline std::string textOf(const Value& value) {
    std::string text = format("{} '{}' entity {} shape {}", shortestText(static_cast<double>(value.number)),
                              value.text, value.entity.index, value.shape);
    for (const float number : value.floats) text += " " + shortestText(number);
    return text;
}

struct ExpectedField {
    std::string name, was;
    FieldType type;
    bool limited = false;
    float min = 0.0f, max = 0.0f;
    std::uint32_t capacity = 0;                      ///< of a list
    std::vector<std::pair<std::string, int>> names;  ///< of an enum
    Value preset;                                    ///< the default
    std::uint32_t offset = 0;

    [[nodiscard]] bool isCurve() const { return type.kind == FieldKind::List && type.size != 0; }
    [[nodiscard]] bool isList() const { return type.kind == FieldKind::List && type.size == 0; }
    /// True if only the name, the place or the default differs.
    [[nodiscard]] bool holdsSameAs(const ExpectedField& other) const {
        const bool sameRange =
            limited == other.limited && (!limited || (min == other.min && max == other.max));
        return type == other.type && sameRange && capacity == other.capacity && names == other.names;
    }
    [[nodiscard]] std::uint32_t size() const { return isList() ? capacity * 4 + 4 : type.size; }
};

inline long double lowest(const FieldType& type) {
    return type.isSigned ? -std::exp2(static_cast<long double>(type.size) * 8.0L - 1.0L) : 0.0L;
}
inline long double highest(const FieldType& type) {
    return std::exp2(static_cast<long double>(type.size) * 8.0L - (type.isSigned ? 1.0L : 0.0L)) - 1.0L;
}

/// The rule for a number that becomes one of another type.
inline Value numberAs(const ExpectedField& before, const Value& value, const ExpectedField& now) {
    long double number = value.number;
    if (before.type.kind == FieldKind::Enum && now.type.kind == FieldKind::Enum) {
        for (const auto& [name, former] : before.names) {
            for (const auto& [other, present] : now.names) {
                if (static_cast<long double>(former) == number && name == other)
                    return {static_cast<long double>(present), "", {}, 0, {}};
            }
        }
        return now.preset;
    }
    if (std::isnan(number) && now.type.kind != FieldKind::Float) return now.preset;
    switch (now.type.kind) {
        case FieldKind::Bool: number = number != 0.0L ? 1.0L : 0.0L; break;
        case FieldKind::Enum:
            if (std::none_of(now.names.begin(), now.names.end(), [&](const auto& name) {
                    return static_cast<long double>(name.second) == number;
                }))
                return now.preset;
            break;
        case FieldKind::Int:
            number = std::clamp(std::round(number), lowest(now.type), highest(now.type));
            break;
        default: number = static_cast<long double>(static_cast<float>(number)); break;
    }
    const bool hasRange = now.type.kind == FieldKind::Int || now.type.kind == FieldKind::Float;
    if (now.limited && hasRange && !std::isnan(number)) {
        number = std::clamp(number, static_cast<long double>(now.min), static_cast<long double>(now.max));
    }
    return {number, "", {}, 0, {}};
}

/// The rule for a value of a former version. @param before  null: there was no such field
inline Value valueAs(const ExpectedField* before, const Value& value, const ExpectedField& now) {
    if (before == nullptr || value == before->preset) return now.preset;
    if (before->holdsSameAs(now)) return value;
    if (before->type.isNumber() && now.type.isNumber()) return numberAs(*before, value, now);
    if (!(before->type == now.type)) return now.preset;
    Value kept = value;
    if (now.isList() && kept.floats.size() > now.capacity) kept.floats.resize(now.capacity);
    return kept;
}

// ---- bytes

template <class T>
void put(void* at, T value) {
    std::memcpy(at, &value, sizeof value);
}
template <class T>
T get(const void* at) {
    T value{};
    std::memcpy(&value, at, sizeof value);
    return value;
}

/// Writes a value as the module's code would. @param texts  may be null for a text that is empty
inline void write(const ExpectedField& field, const Value& value, void* at, TextStore* texts) {
    switch (field.type.kind) {
        case FieldKind::Float: put(at, static_cast<float>(value.number)); return;
        case FieldKind::Int:
        case FieldKind::Enum:
        case FieldKind::Bool: {
            const auto bits = value.number < 0.0L
                                  ? static_cast<std::uint64_t>(static_cast<std::int64_t>(value.number))
                                  : static_cast<std::uint64_t>(value.number);
            std::memcpy(at, &bits, field.type.size);
            return;
        }
        case FieldKind::Text: put(at, texts == nullptr ? TextId{} : texts->add(value.text)); return;
        case FieldKind::Entity: put(at, value.entity); return;
        default: break;
    }
    if (!value.floats.empty()) std::memcpy(at, value.floats.data(), value.floats.size() * sizeof(float));
    auto* after = static_cast<std::byte*>(at);
    if (field.isList()) {
        std::memset(after + value.floats.size() * 4, 0, field.size() - value.floats.size() * 4);
        put(after + field.capacity * 4, static_cast<std::uint32_t>(value.floats.size()));
    }
    if (field.isCurve()) {
        Curve curve;
        curve.keys = {};
        curve.count = static_cast<std::uint32_t>(value.floats.size() / 2);
        for (std::uint32_t i = 0; i < curve.count; ++i)
            curve.keys[i] = {value.floats[i * 2], value.floats[i * 2 + 1]};
        curve.shape = static_cast<CurveShape>(value.shape);
        put(at, curve);
    }
}

inline Value read(const ExpectedField& field, const void* at, const TextStore& texts) {
    Value value;
    const auto floats = [&](std::size_t count) {
        value.floats.resize(count);
        if (count != 0) std::memcpy(value.floats.data(), at, count * sizeof(float));
    };
    switch (field.type.kind) {
        case FieldKind::Float: value.number = static_cast<long double>(get<float>(at)); break;
        case FieldKind::Bool: value.number = get<std::uint8_t>(at); break;
        case FieldKind::Enum: value.number = get<std::int32_t>(at); break;
        case FieldKind::Int: {
            std::uint64_t bits = 0;
            std::memcpy(&bits, at, field.type.size);
            const std::uint32_t unused = 64 - field.type.size * 8;
            value.number = field.type.isSigned
                               ? static_cast<long double>(static_cast<std::int64_t>(bits << unused) >> unused)
                               : static_cast<long double>(bits);
            break;
        }
        case FieldKind::Text: value.text = texts.find(get<TextId>(at)); break;
        case FieldKind::Entity: value.entity = get<EntityId>(at); break;
        case FieldKind::Vec2: floats(2); break;
        default:
            if (field.isCurve()) {
                const auto curve = get<Curve>(at);
                floats(std::size_t{curve.count} * 2);
                value.shape = static_cast<int>(curve.shape);
            } else {
                floats(get<std::uint32_t>(static_cast<const std::byte*>(at) + field.capacity * 4));
            }
    }
    return value;
}

// ---- layouts

/// Gives the fields their places, in the order in which they are, with gaps.
inline Layout layOut(std::vector<ExpectedField>& fields, bool listed) {
    Layout layout;
    layout.listed = listed;
    std::uint32_t offset = 0;
    for (ExpectedField& field : fields) {
        const auto gap = static_cast<std::uint32_t>(hashText(field.name) % 3) * 4;
        offset = (offset + gap + 7) / 8 * 8;
        field.offset = offset;
        offset += field.size();
        LayoutField& out = layout.fields[layout.fieldCount++];
        out.name = Word{field.name};
        out.was = Word{field.was};
        out.kind = field.type.kind;
        out.isSigned = field.type.isSigned;
        out.size = field.size();
        out.offset = field.offset;
        out.capacity = field.capacity;
        if (field.limited) out.min = field.min, out.max = field.max;
        for (std::size_t i = 0; i < field.names.size(); ++i) {
            out.enumNames[i] = Word{field.names[i].first};
            out.enumValues[i] = field.names[i].second;
        }
        write(field, field.preset, layout.defaults.data() + field.offset, nullptr);
    }
    layout.size = (offset + 7) / 8 * 8;
    return layout;
}

}  // namespace plumb::test
