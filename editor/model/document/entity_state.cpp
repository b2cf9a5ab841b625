#include "editor/model/document/entity_state.hpp"

#include <algorithm>
#include <map>

#include "ecs/hierarchy.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/files/prefab.hpp"

namespace plumb::editor {
namespace {

bool isParentOrChildren(const TypeInfo& type) {
    return type.key == typeKey<Parent>() || type.key == typeKey<Children>();
}

void replaceReferences(const FieldInfo& field, std::byte* component,
                       const std::map<ObjectId, ObjectId>& renamed) {
    const bool list = field.kind == FieldKind::List && field.element == FieldKind::Entity;
    if (field.kind != FieldKind::Entity && !list) return;
    auto* at = static_cast<std::byte*>(field.in(static_cast<void*>(component)));
    const std::size_t count = list ? field.countOf(at) : 1;
    for (std::size_t i = 0; i < count; ++i, at += sizeof(ObjectId)) {
        ObjectId id;
        std::memcpy(&id, at, sizeof id);
        const auto found = renamed.find(id);
        if (found != renamed.end()) std::memcpy(at, &found->second, sizeof id);
    }
}

/// Links the copy of a part of a prefab instance to the copy of the instance, from which its id is computed.
/// A part that is copied without its instance becomes a plain entity.
void followInstance(EntityState& state, std::map<ObjectId, ObjectId>& renamed) {
    const auto link = std::find_if(
        state.components.begin(), state.components.end(),
        [](const ComponentState& component) { return component.type->key == typeKey<PrefabPart>(); });
    if (link == state.components.end()) return;
    PrefabPart part;
    std::memcpy(&part, link->bytes.data(), sizeof part);
    const auto instance = renamed.find({part.instance});
    if (instance == renamed.end()) {
        state.components.erase(link);
        return;
    }
    part.instance = instance->second.value;
    std::memcpy(link->bytes.data(), &part, sizeof part);
    renamed[state.id] = {combinedId(part.instance, part.part)};
}

void copyTiles(World& world, const FieldInfo& field, std::byte* component) {
    if (field.kind != FieldKind::Tiles) return;
    auto* tiles = static_cast<TilesId*>(field.in(static_cast<void*>(component)));
    if (const TileGrid* grid = world.tiles().find(*tiles)) *tiles = world.tiles().add(TileGrid{*grid});
}

}  // namespace

EntityState readEntity(const Document& document, ObjectId id) {
    const EntityId entity = document.find(id);
    EntityState state{id, document.idOf(parentOf(document.world, entity)), {}};
    for (const TypeInfo& type : document.types().all()) {
        if (!isParentOrChildren(type) && document.world.has(type, entity)) {
            state.components.push_back(readComponent(document, type, entity));
        }
    }
    return state;
}

void insertEntities(Document& document, const std::vector<EntityState>& states) {
    for (const EntityState& state : states) {
        document.remember(state.id, document.world.createEntity());
    }
    for (const EntityState& state : states) {
        const EntityId entity = document.find(state.id);
        for (const ComponentState& component : state.components) {
            writeComponent(document, entity, component);
        }
        if (state.parent) setParent(document.world, entity, document.find(state.parent));
    }
}

void eraseEntities(Document& document, const std::vector<ObjectId>& ids) {
    for (const ObjectId id : withDescendants(document, ids)) {
        document.world.destroy(document.find(id));
        document.forget(id);
    }
}

std::vector<ObjectId> withDescendants(const Document& document, const std::vector<ObjectId>& ids) {
    std::vector<EntityId> roots;
    for (const ObjectId id : ids) {
        if (const EntityId entity = document.find(id)) roots.push_back(entity);
    }
    std::sort(roots.begin(), roots.end());

    struct Found {
        int depth;
        std::size_t place;
        ObjectId id;
    };
    std::vector<Found> found;
    const std::vector<ObjectId>& all = document.objects();
    for (std::size_t i = 0; i < all.size() && !roots.empty(); ++i) {
        int depth = 0;
        bool inside = false;
        for (EntityId at = document.find(all[i]); at; at = parentOf(document.world, at), ++depth) {
            inside = inside || std::binary_search(roots.begin(), roots.end(), at);
        }
        if (inside) found.push_back({depth, i, all[i]});
    }
    std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
        return a.depth != b.depth ? a.depth < b.depth : a.place < b.place;
    });
    std::vector<ObjectId> result;
    for (const Found& item : found) {
        result.push_back(item.id);
    }
    return result;
}

std::vector<ObjectId> outermost(const Document& document, const std::vector<ObjectId>& ids) {
    std::vector<EntityId> listed;
    for (const ObjectId id : ids) {
        listed.push_back(document.find(id));
    }
    std::sort(listed.begin(), listed.end());
    std::vector<ObjectId> result;
    for (const ObjectId id : ids) {
        bool below = false;
        for (EntityId at = parentOf(document.world, document.find(id)); at && !below;
             at = parentOf(document.world, at)) {
            below = std::binary_search(listed.begin(), listed.end(), at);
        }
        if (!below) result.push_back(id);
    }
    return result;
}

std::vector<EntityState> copiesOf(Document& document, std::vector<EntityState> states) {
    std::map<ObjectId, ObjectId> renamed;
    for (const EntityState& state : states) {
        renamed[state.id] = document.newId();
    }
    for (EntityState& state : states) {
        followInstance(state, renamed);
    }
    for (EntityState& state : states) {
        state.id = renamed[state.id];
    }
    std::int32_t order = document.nextOrder();
    for (EntityState& state : states) {
        if (const auto parent = renamed.find(state.parent); parent != renamed.end()) {
            state.parent = parent->second;
        } else if (!document.find(state.parent)) {
            state.parent = {};
        }
        for (ComponentState& component : state.components) {
            for (const FieldInfo& field : component.type->fields) {
                replaceReferences(field, component.bytes.data(), renamed);
                copyTiles(document.world, field, component.bytes.data());
            }
            if (component.type->key != typeKey<SceneEntity>()) continue;
            SceneEntity part;
            std::memcpy(&part, component.bytes.data(), sizeof part);
            part.id = state.id.value;
            part.order = order++;
            part.scene = document.scene;
            std::memcpy(component.bytes.data(), &part, sizeof part);
        }
    }
    return states;
}

}  // namespace plumb::editor
