#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "tests/editor/support/changing_component.hpp"

// Random edits of the fields of the component Changing, as a programmer makes them, and random values.

namespace plumb::test {

/// Makes one edit at a time.
class LayoutEdits {
public:
    /// @param forFiles  only edits after which a scene's text says the same as a world: no value is lost
    explicit LayoutEdits(bool forFiles) : forFiles_{forFiles} {}

    [[nodiscard]] ExpectedField made(std::string name, Random& random) const {
        ExpectedField field;
        field.name = std::move(name);
        const std::size_t all = kNumberTypes.size() + (forFiles_ ? 0 : kOtherTypes.size());
        setType(field, random.below(static_cast<std::uint32_t>(all)), random);
        return field;
    }
    [[nodiscard]] std::string newName() { return format("p{}", ++made_); }

    void edit(std::vector<ExpectedField>& fields, bool& listed, Random& random) {
        for (ExpectedField& field : fields) {
            if (random.below(4) == 0) field.was.clear();  // most programmers do not leave it there for ever
        }
        if (fields.empty()) fields.push_back(ticks());
        if (!forFiles_ && random.below(12) == 0) listed = !listed;
        if (fields.size() < 2 || (fields.size() < kMost && random.below(4) == 0))
            return fields.push_back(made(newName(), random));
        ExpectedField& chosen = fields[1 + random.below(static_cast<std::uint32_t>(fields.size() - 1))];
        switch (random.below(forFiles_ ? 6 : 11)) {
            case 0: fields.erase(fields.begin() + (&chosen - fields.data())); return;
            case 1: rename(chosen, true); return;
            case 2: rename(chosen, false); return;
            case 3: setPreset(chosen, random); return;
            case 4: retype(chosen, random); return;
            case 5: return;  // the code has changed, but not the component
            case 6: return renameAndReuse(fields, chosen, random);
            case 7: limit(chosen, random); return;
            case 8: setNames(chosen, random); return;
            case 9: setCapacity(chosen, random); return;
            default: return reorder(fields, random);
        }
    }

    /// A value that code, or for files the inspector, may give a field.
    [[nodiscard]] Value value(const ExpectedField& field, Random& random) const {
        Value value;
        const auto some = [&](std::uint32_t count) {
            for (std::uint32_t i = 0; i < count; ++i)
                value.floats.push_back(static_cast<float>(random.below(100)) + 0.5f);
        };
        switch (field.type.kind) {
            case FieldKind::Bool: value.number = random.below(2); break;
            case FieldKind::Int: value.number = wholeOf(field.type, random); break;
            case FieldKind::Float: value.number = static_cast<long double>(floatOf(random)); break;
            case FieldKind::Enum:
                value.number = random.below(8) == 0 ? 99 : field.names[random.below(3)].second;
                break;
            case FieldKind::Text: value.text = format("text {}", random.below(9)); break;
            case FieldKind::Entity: value.entity = {1 + random.below(9), 1}; break;
            case FieldKind::Vec2: some(2); break;
            default: some(field.isCurve() ? 2 + 2 * random.below(3) : random.below(field.capacity + 1));
        }
        if (field.isCurve()) value.shape = static_cast<int>(random.below(2));
        return value;
    }

    static ExpectedField ticks() {
        ExpectedField field;
        field.name = "ticks";
        field.type = {FieldKind::Int, 4};
        return field;
    }

private:
    static constexpr std::size_t kMost = 12;  // fields

    void setType(ExpectedField& field, std::uint32_t index, Random& random) const {
        field.limited = false;
        field.names.clear();
        field.capacity = 0;
        field.type =
            index < kNumberTypes.size() ? kNumberTypes[index] : kOtherTypes[index - kNumberTypes.size()];
        if (field.type.kind == FieldKind::Enum) setNames(field, random);
        if (field.isList()) setCapacity(field, random);
        setPreset(field, random);
    }
    /// Texts and references to entities have no default other than none.
    void setPreset(ExpectedField& field, Random& random) const {
        const bool isNone = field.type.kind == FieldKind::Text || field.type.kind == FieldKind::Entity;
        field.preset = isNone ? Value{} : value(field, random);
    }
    void retype(ExpectedField& field, Random& random) const {
        const ExpectedField other = made(field.name, random);
        field = {field.name, field.was,      other.type,  other.limited, other.min,
                 other.max,  other.capacity, other.names, other.preset,  0};
    }
    void rename(ExpectedField& field, bool withFormerName) {
        field.was = withFormerName ? field.name : "";
        field.name = newName();
    }
    void renameAndReuse(std::vector<ExpectedField>& fields, ExpectedField& chosen, Random& random) {
        rename(chosen, true);
        if (fields.size() < kMost) fields.push_back(made(std::string{chosen.was}, random));
    }
    static void limit(ExpectedField& field, Random& random) {
        field.limited = !field.limited;
        field.min = -static_cast<float>(random.below(50));
        field.max = static_cast<float>(random.below(100));
    }
    static void setNames(ExpectedField& field, Random& random) {
        if (field.type.kind != FieldKind::Enum) return;
        static const std::array<const char*, 6> kNames{"calm", "angry", "asleep", "lost", "happy", "gone"};
        const std::uint32_t first = random.below(6);
        const int base = static_cast<int>(random.below(5)) - 2;
        field.names.clear();
        for (std::uint32_t i = 0; i < 4; ++i)
            field.names.emplace_back(kNames[(first + i) % 6], base + static_cast<int>(i));
        if (field.preset.number != 99.0L) field.preset.number = field.names[0].second;
    }
    void setCapacity(ExpectedField& field, Random& random) const {
        if (!field.isList()) return;
        field.capacity = 1 + random.below(6);
        field.preset = value(field, random);
    }
    static void reorder(std::vector<ExpectedField>& fields, Random& random) {
        for (std::size_t i = fields.size(); i > 1; --i)
            std::swap(fields[i - 1], fields[random.below(static_cast<std::uint32_t>(i))]);
        const auto isTicks = [](const ExpectedField& field) { return field.name == "ticks"; };
        std::iter_swap(fields.begin(), std::find_if(fields.begin(), fields.end(), isTicks));
    }

    [[nodiscard]] long double wholeOf(const FieldType& type, Random& random) const {
        const auto small = static_cast<long double>(random.below(100));
        if (forFiles_) return small;
        switch (random.below(5)) {
            case 0: return lowest(type);
            case 1: return highest(type);
            case 2: return std::min(std::exp2(60.0L) + 1.0L + small, highest(type));  // not exact as a double
            case 3: return std::max(-small, lowest(type));
            default: return small;
        }
    }
    [[nodiscard]] float floatOf(Random& random) const {
        const float small = static_cast<float>(random.below(200)) / 2.0f;
        if (forFiles_) return small;
        switch (random.below(8)) {
            case 0: return 1e30f * (small - 50.0f);
            case 1: return std::numeric_limits<float>::infinity();
            case 2: return std::numeric_limits<float>::quiet_NaN();
            case 3: return -0.5f - small;
            default: return small;
        }
    }

    bool forFiles_;
    int made_ = 0;
};

}  // namespace plumb::test
