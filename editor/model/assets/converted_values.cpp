#include "editor/model/assets/converted_values.hpp"

#include <algorithm>
#include <memory>

#include "reflect/compare.hpp"
#include "reflect/convert_component.hpp"
#include "reflect/json.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/loaded_scene.hpp"

namespace plumb::editor {
namespace {

bool isPrefabs(const World& world, EntityId entity) {
    return world.has<PrefabInstance>(entity) || world.has<PrefabPart>(entity);
}

/// True if a field could have written this value into a file.
bool mayHaveWritten(const FieldInfo& field, const Json& value) {
    if (field.kind == FieldKind::Bool) return value.is_boolean();
    return field.kind == FieldKind::Enum ? value.is_string() || value.is_number() : value.is_number();
}

/// Removes the value that the former field has written from what is kept of the scene's text, where it counts
/// as invalid. @return false if there is none
bool forgetText(SceneRest& rest, ObjectId object, const TypeInfo& type, const FieldInfo& former) {
    const auto entity = rest.entities.find(object.value);
    if (entity == rest.entities.end()) return false;
    return std::erase_if(entity->second.fields, [&](const KeptField& kept) {
               return kept.component == type.name && kept.key == former.name &&
                      mayHaveWritten(former, kept.raw);
           }) != 0;
}

LoadedScene* sceneOf(Document& document) {
    LoadedScenes* scenes = document.world.findResource<LoadedScenes>();
    LoadedScene* scene = scenes == nullptr ? nullptr : scenes->find(document.scene);
    return scene == nullptr || scene->rest == nullptr ? nullptr : scene;
}

}  // namespace

ConvertedValues::ConvertedValues(const Document& document, const ContentChange& change) {
    for (const ContentChange::Type& changed : change.types) {
        std::vector<Field>& fields = fields_.emplace_back();
        if (changed.now == nullptr) continue;
        for (const FieldInfo& field : changed.now->fields) {
            const FieldInfo* former = formerField(changed.before, field);
            if (former == nullptr || former->kind == field.kind || former->transient || field.transient)
                continue;
            if (isNumber(former->kind) && isNumber(field.kind)) fields.push_back({*former, field});
        }
        if (fields.empty()) continue;
        document.world.eachOf(*changed.now, [&](EntityId entity, const void* component) {
            const auto* source = document.world.find<SceneEntity>(entity);
            if (source == nullptr || isPrefabs(document.world, entity)) return;
            const auto* bytes = static_cast<const std::byte*>(component);
            components_.push_back(
                {ObjectId{source->id}, changed.now, fields_.size() - 1, {bytes, bytes + changed.now->size}});
        });
    }
}

bool ConvertedValues::restore(Document& document) const {
    LoadedScene* scene = sceneOf(document);
    if (components_.empty() || scene == nullptr) return false;
    const auto rest = std::make_shared<SceneRest>(*scene->rest);
    bool differs = false;
    for (const Component& component : components_) {
        void* read = document.world.find(*component.type, document.find(component.object));
        if (read == nullptr) continue;
        for (const auto& [before, now] : fields_[component.fields]) {
            const bool equal = fieldsEqual(now, read, component.bytes.data());
            copyField(now, read, component.bytes.data());
            differs = forgetText(*rest, component.object, *component.type, before) || !equal || differs;
        }
    }
    scene->rest = rest;
    return differs;
}

}  // namespace plumb::editor
