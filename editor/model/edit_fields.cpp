#include "editor/model/edit_fields.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/commands/set_field.hpp"
#include "editor/model/field_number.hpp"
#include "editor/model/root_place.hpp"
#include "editor/model/workspace.hpp"
#include "reflect/compare.hpp"

namespace plumb::editor {
namespace {

const void* componentOf(const Workspace& workspace, const FieldTarget& target, ObjectId id) {
    return workspace.shownWorld().find(target.type, workspace.shownEntity(id));
}

bool floatsDiffer(const void* a, const void* b, std::size_t at) {
    float left = 0.0f;
    float right = 0.0f;
    std::memcpy(&left, static_cast<const std::byte*>(a) + at, sizeof left);
    std::memcpy(&right, static_cast<const std::byte*>(b) + at, sizeof right);
    return left != right && (left == left || right == right);
}

/// The component with the place that it cannot give: the first entity of a prefab stays where it is.
ComponentState inPlace(const Document& document, ObjectId id, ComponentState state) {
    const World& world = document.world;
    const void* now = world.find(*state.type, document.find(id));
    for (const FieldInfo& field : state.type->fields) {
        if (now == nullptr || !isPlaceOfRoot(document, id, *state.type, field.name)) continue;
        std::memcpy(field.in(static_cast<void*>(state.bytes.data())), field.in(now), field.size);
    }
    return state;
}

}  // namespace

std::vector<FieldValue> readFields(const Workspace& workspace, const FieldTarget& target) {
    std::vector<FieldValue> values;
    for (const ObjectId id : target.objects) {
        if (const void* component = componentOf(workspace, target, id))
            values.push_back(readField(workspace.shownNames(), target.field, component));
    }
    return values;
}

void editFields(Workspace& workspace, const FieldTarget& target, const ChangeValue& change) {
    std::vector<SetField::Change> changes;
    bool differs = false;
    for (std::size_t i = 0; i < target.objects.size(); ++i) {
        const ObjectId id = target.objects[i];
        const void* component = componentOf(workspace, target, id);
        if (component == nullptr || isPlaceOfRoot(workspace.document, id, target.type, target.field.name))
            continue;
        const FieldValue now = readField(workspace.shownNames(), target.field, component);
        FieldValue next = now;
        change(next, i);
        if (!workspace.play.running()) {
            differs |= next != now;
            changes.push_back({id, std::move(next)});
        } else if (next != now) {
            workspace.play.edit(id, target.type, target.field, next);
        }
    }
    if (differs)
        workspace.undo.push(std::make_unique<SetField>(target.type, target.field, std::move(changes)));
}

void setComponent(Workspace& workspace, const std::vector<ObjectId>& ids, const ComponentState& state,
                  std::string label) {
    if (!workspace.play.running()) {
        std::vector<ChangeComponents::Change> changes;
        for (const ObjectId id : ids) changes.push_back({id, inPlace(workspace.document, id, state)});
        return workspace.undo.push(
            std::make_unique<ChangeComponents>(std::move(label), *state.type, std::move(changes)));
    }
    for (const FieldInfo& field : state.type->fields) {
        if (field.transient) continue;
        const auto* from =
            static_cast<const std::byte*>(field.in(static_cast<const void*>(state.bytes.data())));
        const FieldValue value{{from, from + field.size}};
        editFields(workspace, {*state.type, field, ids}, [&](FieldValue& one, std::size_t) { one = value; });
    }
}

void resetComponent(Workspace& workspace, const std::vector<ObjectId>& ids, const TypeInfo& type) {
    setComponent(workspace, ids, defaultComponent(type), format("reset {}", type.name));
}

Result<Done> typeNumber(Workspace& workspace, const FieldTarget& target, std::size_t at,
                        std::string_view text) {
    std::vector<double> results(target.objects.size());
    for (std::size_t i = 0; i < target.objects.size(); ++i) {
        const void* component = componentOf(workspace, target, target.objects[i]);
        if (component == nullptr) continue;
        const FieldValue now = readField(workspace.shownNames(), target.field, component);
        const Result<double> result =
            typedNumber(text, {numberAt(target.field, now, at), i, target.objects.size()});
        if (!result) return result.error();
        results[i] = *result;
    }
    editFields(workspace, target,
               [&](FieldValue& value, std::size_t i) { setNumberAt(target.field, value, results[i], at); });
    return Done{};
}

void MixedBytes::compare(const FieldInfo& field, const void* a, const void* b) {
    const auto mark = [this](std::size_t at, std::size_t size) {
        std::fill_n(bytes_.begin() + static_cast<std::ptrdiff_t>(at), size, std::byte{0xff});
        any_ = true;
    };
    switch (field.kind) {
        case FieldKind::Float:
        case FieldKind::Vec2:
        case FieldKind::Rect:
            for (std::size_t at = 0; at < field.size; at += sizeof(float)) {
                if (floatsDiffer(a, b, at)) mark(at, sizeof(float));
            }
            return;
        case FieldKind::List: {
            // Lists of another length have no places in common.
            if (*field.listCount(const_cast<void*>(a)) != *field.listCount(const_cast<void*>(b))) {
                lengths_ = true;
                return mark(0, field.size);
            }
            if (!hasNumbers(field)) break;
            const std::size_t bytes = *field.listCount(const_cast<void*>(a)) * field.elementSize;
            for (std::size_t at = 0; at < bytes; at += sizeof(float)) {
                if (floatsDiffer(a, b, at)) mark(at, sizeof(float));
            }
            return;
        }
        case FieldKind::Int:
            if (!field.layerBits) break;
            for (std::size_t at = 0; at < field.size; ++at) {
                const std::byte differ =
                    static_cast<const std::byte*>(a)[at] ^ static_cast<const std::byte*>(b)[at];
                bytes_[at] |= differ;
                any_ |= differ != std::byte{};
            }
            return;
        case FieldKind::Color:
            for (std::size_t at = 0; at < field.size; ++at) {
                if (static_cast<const std::byte*>(a)[at] != static_cast<const std::byte*>(b)[at]) mark(at, 1);
            }
            return;
        case FieldKind::Bool:
        case FieldKind::Text:
        case FieldKind::Enum:
        case FieldKind::Entity:
        case FieldKind::Asset:
        case FieldKind::Tiles: break;
    }
    if (!valuesEqual(field, a, b)) mark(0, field.size);
}

bool MixedBytes::any(std::size_t at, std::size_t size) const {
    if (!any_) return false;
    return std::any_of(bytes_.begin() + static_cast<std::ptrdiff_t>(at),
                       bytes_.begin() + static_cast<std::ptrdiff_t>(at + size),
                       [](std::byte byte) { return byte != std::byte{}; });
}

bool MixedBytes::bit(unsigned bit) const {
    const std::byte byte = bytes_[bit / 8];
    return (byte >> (bit % 8) & std::byte{1}) != std::byte{};
}

SharedField sharedField(const Workspace& workspace, const FieldTarget& target, const ComponentState& fresh) {
    const FieldInfo& field = target.field;
    SharedField shared;
    shared.mixed = MixedBytes{field};
    const void* normal = field.in(static_cast<const void*>(fresh.bytes.data()));
    const void* last = nullptr;
    for (auto id = target.objects.rbegin(); id != target.objects.rend(); ++id) {
        const void* component = componentOf(workspace, target, *id);
        if (component == nullptr) continue;
        ++shared.holders;
        const void* value = field.in(component);
        if (shared.isDefault) shared.isDefault = valuesEqual(field, value, normal);
        if (last == nullptr) {
            last = value;
            shared.value = readField(workspace.shownNames(), field, component);
        } else {
            shared.mixed.compare(field, last, value);
        }
    }
    return shared;
}

}  // namespace plumb::editor
