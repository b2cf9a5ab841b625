#include "editor/model/shared_components.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>

#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "editor/model/document/field_number.hpp"
#include "editor/model/workspace.hpp"
#include "reflect/compare.hpp"
#include "scene/components/name.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/scene_entity.hpp"

namespace plumb::editor {

namespace {

/// True for a field like "previousPosition" beside "position": the value one tick ago, which the engine
/// stores to interpolate between two ticks. Users never set it.
bool isOfLastTick(const TypeInfo& type, const FieldInfo& field) {
    constexpr std::string_view kBefore = "previous";
    if (!field.transient || !startsWith(field.name, kBefore) || field.name.size() == kBefore.size())
        return false;
    std::string name{field.name.substr(kBefore.size())};
    name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
    return type.find(name) != nullptr;
}

bool floatsDiffer(const void* a, const void* b, std::size_t at) {
    float left = 0.0f;
    float right = 0.0f;
    std::memcpy(&left, static_cast<const std::byte*>(a) + at, sizeof left);
    std::memcpy(&right, static_cast<const std::byte*>(b) + at, sizeof right);
    return left != right && (left == left || right == right);
}

}  // namespace

bool isHiddenInComponentLists(const TypeInfo& type) {
    return type.key == typeKey<SceneEntity>() || type.key == typeKey<PrefabInstance>() ||
           type.key == typeKey<PrefabPart>() || type.key == typeKey<Name>() ||
           type.key == typeKey<Parent>() || type.key == typeKey<Children>();
}

SelectedState selectedState(const Workspace& workspace) {
    return {workspace.document.sceneRevision, workspace.document.selection.revision(),
            workspace.play.running() ? workspace.play.ticks() : -1};
}

std::vector<ObjectId> holdersOf(const Workspace& workspace, std::span<const ObjectId> ids,
                                const TypeInfo& type) {
    std::vector<ObjectId> holders;
    for (const ObjectId id : ids) {
        if (workspace.shownWorld().has(type, workspace.shownEntity(id))) holders.push_back(id);
    }
    return holders;
}

std::vector<ComponentHolders> componentHolders(const TypeRegistry& types, const World& world,
                                               std::span<const EntityId> entities) {
    std::vector<ComponentHolders> held;
    for (const TypeInfo& type : types.all()) {
        // A scene uses few of the types; the others need no search through thousands of entities.
        if (isHiddenInComponentLists(type) || world.count(type) == 0) continue;
        const auto count = static_cast<std::size_t>(std::count_if(
            entities.begin(), entities.end(), [&](EntityId entity) { return world.has(type, entity); }));
        if (count > 0) held.push_back({&type, count});
    }
    return held;
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
            // Elements of lists of different lengths are not compared.
            if (field.countOf(a) != field.countOf(b)) {
                lengths_ = true;
                return mark(0, field.size);
            }
            if (!hasNumbers(field)) break;
            const std::size_t bytes = field.countOf(a) * field.elementSize;
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

bool MixedBytes::all() const {
    const auto isMarked = [](std::byte byte) { return byte == std::byte{0xff}; };
    return any_ && std::all_of(bytes_.begin(), bytes_.end(), isMarked);
}

bool MixedBytes::bit(unsigned bit) const {
    const std::byte byte = bytes_[bit / 8];
    return (byte >> (bit % 8) & std::byte{1}) != std::byte{};
}

HeldComponents heldComponents(const World& world, const TypeInfo& type, std::span<const EntityId> entities) {
    HeldComponents held;
    held.type = &type;
    for (auto entity = entities.rbegin(); entity != entities.rend(); ++entity) {
        const void* component = world.find(type, *entity);
        if (component == nullptr) continue;
        if (held.inHand == nullptr) {
            held.inHand = component;
        } else if (std::memcmp(held.inHand, component, type.size) != 0) {
            held.different.push_back(component);
        }
    }
    return held;
}

SharedField sharedField(const ObjectNames& names, const FieldInfo& field, const HeldComponents& held,
                        const ComponentState& fresh) {
    const void* last = field.in(held.inHand);
    const void* normal = field.in(static_cast<const void*>(fresh.bytes.data()));
    SharedField shared;
    shared.value = readField(names, field, held.inHand);
    shared.mixed = MixedBytes{field};
    shared.isDefault = valuesEqual(field, last, normal);
    for (const void* component : held.different) {
        const void* value = field.in(component);
        shared.mixed.compare(field, last, value);
        if (shared.isDefault) shared.isDefault = valuesEqual(field, value, normal);
        if (!shared.isDefault && shared.mixed.all()) break;
    }
    return shared;
}

bool isShown(const FieldInfo& field, const HeldComponents& held) {
    if (isOfLastTick(*held.type, field)) return false;
    const FieldInfo* other = field.shownIf.empty() ? nullptr : held.type->find(field.shownIf);
    if (other == nullptr) return true;
    const auto isOn = [&](const void* component) {
        int value = 0;  // a bool, or an enum of 1 or 4 bytes; the low byte comes first
        std::memcpy(&value, other->in(component), std::min(other->size, sizeof value));
        return value == field.shownIfValue;
    };
    return isOn(held.inHand) || std::any_of(held.different.begin(), held.different.end(), isOn);
}

}  // namespace plumb::editor
