#include "editor/model/document/document.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "editor/model/document/scene_boxes.hpp"
#include "scene/components/name.hpp"
#include "scene/components/scene_entity.hpp"

namespace plumb::editor {
namespace {

// An entity without a name is displayed under the first of these components that it has.
constexpr std::array<std::string_view, 9> kMainComponents{
    "PlayerController", "Camera",    "TileLayer",   "Label",         "Sprite",
    "ParallaxLayer",    "RigidBody", "BoxCollider", "CircleCollider"};

}  // namespace

Document::Document(const TypeRegistry& types) : world{types}, boxes_{std::make_unique<SceneBoxes>()} {}
Document::~Document() = default;

const SceneBoxes& Document::boxes() const {
    boxes_->follow(*this);
    return *boxes_;
}

EntityId Document::find(ObjectId id) const {
    const EntityId* found = entities_.find(id.value);
    return found == nullptr ? EntityId{} : *found;
}

ObjectId Document::idOf(EntityId entity) const {
    const SceneEntity* part = world.find<SceneEntity>(entity);
    return part == nullptr ? ObjectId{} : ObjectId{part->id};
}

const std::vector<ObjectId>& Document::objects() const {
    if (std::exchange(sorted_, true)) return objects_;
    std::vector<std::tuple<std::int32_t, std::uint64_t>> found;
    world.each<const SceneEntity>([&](const SceneEntity& part) { found.emplace_back(part.order, part.id); });
    std::sort(found.begin(), found.end());
    objects_.clear();
    objects_.reserve(found.size());
    for (const auto& [order, id] : found) {
        objects_.push_back({id});
    }
    return objects_;
}

std::string Document::nameOf(ObjectId id) const {
    const EntityId entity = find(id);
    if (const Name* name = world.find<Name>(entity)) {
        if (!name->text.empty()) return std::string{world.texts().find(name->text)};
    }
    for (const std::string_view main : kMainComponents) {
        const TypeInfo* type = types().find(main);
        if (type != nullptr && world.has(*type, entity)) return std::string{main};
    }
    return "Entity";
}

ObjectId Document::newId() {
    ObjectId id;
    do {
        id.value = random_.next64();
    } while (!id || find(id));
    return id;
}

std::int32_t Document::nextOrder() const {
    std::int32_t next = 0;
    world.each<const SceneEntity>([&](const SceneEntity& part) { next = std::max(next, part.order + 1); });
    return next;
}

void Document::forget(ObjectId id) {
    entities_.erase(id.value);
    reordered();
    selection.remove(id);
}

void Document::reindex() {
    entities_.clear();
    reordered();
    std::vector<EntityId> needNewId;
    world.each<SceneEntity>([&](EntityId entity, SceneEntity& part) {
        if (part.id == 0 || entities_.find(part.id) != nullptr) {
            needNewId.push_back(entity);
        } else {
            entities_.set(part.id, entity);
        }
    });
    for (const EntityId entity : needNewId) {
        const ObjectId id = newId();
        world.get<SceneEntity>(entity).id = id.value;
        remember(id, entity);
    }
    selection.clear();
    ++sceneRevision;
}

}  // namespace plumb::editor
