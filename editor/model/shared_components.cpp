#include "editor/model/shared_components.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>

#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "editor/model/workspace.hpp"
#include "scene/components/name.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/scene_entity.hpp"

namespace plumb::editor {

namespace {

/// Of the types that there are, few are in a scene: the others need not be looked for in thousands of
/// entities.
bool anyHas(const World& world, const TypeInfo& type) {
    bool found = false;
    world.eachOf(type, [&found](EntityId, const void*) { found = true; });
    return found;
}

/// "previousPosition" beside "position": what the field was one tick ago. The engine keeps it, to draw what
/// is between two ticks; nobody sets it.
bool isOfLastTick(const TypeInfo& type, const FieldInfo& field) {
    constexpr std::string_view kBefore = "previous";
    if (!field.transient || !startsWith(field.name, kBefore) || field.name.size() == kBefore.size())
        return false;
    std::string name{field.name.substr(kBefore.size())};
    name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
    return type.find(name) != nullptr;
}

}  // namespace

bool hasOwnPlace(const TypeInfo& type) {
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

std::vector<ComponentHolders> componentHolders(const Workspace& workspace, std::span<const ObjectId> ids) {
    std::vector<EntityId> entities;
    entities.reserve(ids.size());
    for (const ObjectId id : ids) entities.push_back(workspace.shownEntity(id));
    std::vector<ComponentHolders> held;
    const World& world = workspace.shownWorld();
    for (const TypeInfo& type : workspace.document.types().all()) {
        if (hasOwnPlace(type) || !anyHas(world, type)) continue;
        const auto count = static_cast<std::size_t>(std::count_if(
            entities.begin(), entities.end(), [&](EntityId entity) { return world.has(type, entity); }));
        if (count > 0) held.push_back({&type, count});
    }
    return held;
}

bool isShown(const Workspace& workspace, const FieldTarget& target) {
    if (isOfLastTick(target.type, target.field)) return false;
    const FieldInfo* other = target.field.shownIf.empty() ? nullptr : target.type.find(target.field.shownIf);
    if (other == nullptr) return true;
    for (const ObjectId id : target.objects) {
        const void* component = workspace.shownWorld().find(target.type, workspace.shownEntity(id));
        if (component == nullptr) continue;
        int value = 0;  // a bool, or an enum of 1 or 4 bytes; the low byte comes first
        std::memcpy(&value, other->in(component), std::min(other->size, sizeof value));
        if (value == target.field.shownIfValue) return true;
    }
    return false;
}

}  // namespace plumb::editor
