#include "editor/model/document/prefab_instance.hpp"

#include <algorithm>
#include <array>

#include "ecs/hierarchy.hpp"
#include "reflect/component_json.hpp"
#include "reflect/json.hpp"
#include "scene/components/name.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/transform.hpp"

namespace plumb::editor {
namespace {

/// A component with the prefab's values. Its destructor removes the tile grids it created, unless keepTiles()
/// was called.
class BaseValue {
public:
    BaseValue(World& world, const TypeInfo& type, const Json* fields, FieldContext& context)
        : world_{world}, type_{type}, value_{type, fields, context} {}
    ~BaseValue() {
        for (const FieldInfo& field : type_.fields) {
            if (keep_ || field.kind != FieldKind::Tiles) continue;
            world_.tiles().remove(*static_cast<const TilesId*>(field.in(value_.get())));
        }
    }
    BaseValue(const BaseValue&) = delete;
    BaseValue& operator=(const BaseValue&) = delete;

    [[nodiscard]] const void* get() const { return value_.get(); }
    void keepTiles() { keep_ = true; }

private:
    World& world_;
    const TypeInfo& type_;
    PrefabValue value_;
    bool keep_ = false;
};

}  // namespace

bool isInstancePose(const TypeInfo& type, std::string_view field) {
    return type.key == typeKey<Transform>() && (field == "position" || field == "rotation");
}

bool canOverride(const TypeInfo& type) {
    const std::array tied{typeKey<SceneEntity>(), typeKey<Name>(),   typeKey<PrefabInstance>(),
                          typeKey<PrefabPart>(),  typeKey<Parent>(), typeKey<Children>()};
    return std::find(tied.begin(), tied.end(), type.key) == tied.end();
}

InstancePart::InstancePart(Document& document, ObjectId id, ObjectId root, std::uint64_t part,
                           const Prefab& prefab)
    : document_{&document}, id_{id}, root_{root}, part_{part}, prefab_{&prefab}, base_{prefab.find(part)} {
    for (const PrefabEntity& entity : prefab.entities) {
        placed_.entities.push_back(document.find({combinedId(root.value, entity.part)}));
    }
}

std::optional<InstancePart> InstancePart::of(Document& document, PrefabLibrary* prefabs, ObjectId id) {
    const World& world = document.world;
    const PrefabPart* link = world.find<PrefabPart>(document.find(id));
    const ObjectId root = link == nullptr ? id : ObjectId{link->instance};
    const PrefabInstance* instance = world.find<PrefabInstance>(document.find(root));
    if (instance == nullptr || prefabs == nullptr) return std::nullopt;
    const Result<const Prefab*> prefab = prefabs->find(world.texts().find(instance->prefab.path));
    const std::uint64_t part = link == nullptr ? Prefab::kRootPart : link->part;
    if (!prefab || (*prefab)->find(part) == nullptr) return std::nullopt;
    return InstancePart{document, id, root, part, **prefab};
}

std::optional<InstancePart> InstancePart::besides(const Prefab& prefab) const {
    if (prefab.find(part_) == nullptr) return std::nullopt;
    return InstancePart{*document_, id_, root_, part_, prefab};
}

std::vector<ObjectId> InstancePart::all() const {
    std::vector<ObjectId> ids;
    for (const EntityId entity : placed_.entities) {
        if (document_->world.alive(entity)) ids.push_back(document_->idOf(entity));
    }
    return ids;
}

const Json* InstancePart::fieldsOf(const TypeInfo& type) const {
    const auto found = base_->components.find(std::string{type.name});
    return found == base_->components.end() ? nullptr : &*found;
}

bool InstancePart::prefabHas(const TypeInfo& type) const { return fieldsOf(type) != nullptr; }

ComponentState InstancePart::baseOf(const TypeInfo& type) const {
    PLUMB_ASSERT(prefabHas(type), "the prefab has no such component");
    PartContext context{document_->world, *prefab_, placed_};
    BaseValue value{document_->world, type, fieldsOf(type), context};
    value.keepTiles();
    return componentState(*document_, type, value.get());
}

Json InstancePart::differences(const TypeInfo& type) const {
    if (type.size == 0) return Json::object();
    PartContext context{document_->world, *prefab_, placed_};
    const BaseValue value{document_->world, type, fieldsOf(type), context};
    const WorldFieldContext scene{document_->world};
    const void* object = std::as_const(document_->world).find(type, document_->find(id_));
    Json fields = componentToJson(type, object, value.get(), scene);
    if (isRoot()) {
        for (const FieldInfo& field : type.fields) {
            if (isInstancePose(type, field.name)) fields.erase(std::string{field.name});
        }
    }
    return fields;
}

const PrefabOverrides::Component* PrefabOverrides::find(const TypeInfo& type) const {
    const auto found = std::find_if(components.begin(), components.end(),
                                    [&](const Component& component) { return component.type == &type; });
    return found == components.end() ? nullptr : &*found;
}

bool PrefabOverrides::has(const TypeInfo& type, std::string_view field) const {
    const Component* component = find(type);
    return component != nullptr &&
           std::find(component->fields.begin(), component->fields.end(), field) != component->fields.end();
}

std::size_t PrefabOverrides::count() const {
    std::size_t sum = 0;
    for (const Component& component : components) {
        sum += component.fields.size() + (component.added || component.removed ? 1 : 0);
    }
    return sum;
}

PrefabOverrides overridesOf(Document& document, PrefabLibrary* prefabs, ObjectId id) {
    PrefabOverrides overrides;
    const std::optional<InstancePart> part = InstancePart::of(document, prefabs, id);
    if (!part) return overrides;
    overrides.isPart = true;
    for (const TypeInfo& type : document.types().all()) {
        if (!canOverride(type)) continue;
        const bool here = document.world.has(type, document.find(id));
        const bool there = part->prefabHas(type);
        PrefabOverrides::Component component{&type, here && !there, there && !here, {}};
        if (here && there) {
            const Json fields = part->differences(type);
            for (const auto& [field, value] : fields.items()) {
                component.fields.push_back(field);
            }
        }
        if (component.added || component.removed || !component.fields.empty())
            overrides.components.push_back(std::move(component));
    }
    return overrides;
}

std::vector<EntityState> missingParts(Document& document, const Prefab& prefab, ObjectId root) {
    std::vector<EntityState> states;
    const TypeRegistry& types = document.types();
    const SceneEntity& source = document.world.get<SceneEntity>(document.find(root));
    for (const PrefabEntity& entity : prefab.entities) {
        const ObjectId id{combinedId(root.value, entity.part)};
        if (entity.part == Prefab::kRootPart || document.find(id)) continue;
        EntityState state{id, {combinedId(root.value, entity.parent)}, {}};
        const SceneEntity part{id.value, source.order, source.scene};
        const PrefabPart link{root.value, entity.part};
        state.components.push_back({&types.of<SceneEntity>(), FieldValue::of(part).bytes});
        state.components.push_back({&types.of<PrefabPart>(), FieldValue::of(link).bytes});
        if (!entity.name.empty()) {
            const Name name{document.world.texts().add(entity.name)};
            state.components.push_back({&types.of<Name>(), FieldValue::of(name).bytes});
        }
        states.push_back(std::move(state));
    }
    return states;
}

}  // namespace plumb::editor
