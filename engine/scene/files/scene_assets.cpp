#include "scene/files/scene_assets.hpp"

#include <algorithm>
#include <iterator>
#include <string>

#include "assets/asset_store.hpp"
#include "ecs/world.hpp"
#include "reflect/type_registry.hpp"
#include "scene/files/prefab.hpp"
#include "scene/loaded_scene.hpp"

namespace plumb {
namespace {

void addName(std::vector<AssetName>& names, AssetKind kind, const void* path) {
    const auto id = *static_cast<const TextId*>(path);
    if (!id.empty()) names.push_back({kind, id});
}

void addNames(std::vector<AssetName>& names, const FieldInfo& field, const void* component) {
    const void* value = field.in(component);
    if (field.kind == FieldKind::Asset) return addName(names, field.asset, value);
    const std::uint32_t count = field.countOf(value);
    for (std::uint32_t i = 0; i < count && i < field.capacity; ++i) {
        addName(names, field.asset, static_cast<const std::byte*>(value) + i * field.elementSize);
    }
}

void sortOnce(std::vector<AssetName>& names) {
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
}

/// Loads and adds the assets of the prefabs among the names, and of the prefabs that these name in turn.
void addAssetsOfPrefabs(std::vector<AssetName>& names, const World& world, PrefabLibrary& prefabs,
                        AssetStore& assets) {
    std::vector<std::string> paths;
    for (const AssetName& name : names) {
        if (name.kind == AssetKind::Prefab) paths.emplace_back(world.texts().find(name.path));
    }
    for (const Prefab* prefab : prefabs.readAll(std::move(paths))) {
        for (const PrefabAsset& asset : prefab->assets) {
            assets.load(asset.kind, asset.path);
            names.push_back({asset.kind, textId(asset.path)});
        }
    }
}

}  // namespace

std::vector<AssetName> namedAssets(const World& world, const TypeRegistry& types, AssetKind kind) {
    std::vector<AssetName> names;
    for (const TypeInfo& type : types.all()) {
        for (const FieldInfo& field : type.fields) {
            const bool isList = field.kind == FieldKind::List && field.element == FieldKind::Asset;
            if ((field.kind != FieldKind::Asset && !isList) || field.transient) continue;
            if (kind != AssetKind::None && field.asset != kind) continue;
            world.eachOf(type, [&](EntityId, const void* component) { addNames(names, field, component); });
        }
    }
    sortOnce(names);
    return names;
}

SceneAssets::~SceneAssets() {
    for (const AssetName& name : held_) assets_.release(name.kind, name.path);
}

void SceneAssets::follow(const World& world, const TypeRegistry& types) {
    std::vector<AssetName> named = namedAssets(world, types);
    if (const LoadedScenes* scenes = world.findResource<LoadedScenes>()) {
        // Scene files are held too, so that they are watched: editing one restarts the scene.
        for (const LoadedScene& scene : scenes->scenes) named.push_back({AssetKind::Scene, scene.id.path});
    }
    if (auto* prefabs = world.service<PrefabLibrary>()) addAssetsOfPrefabs(named, world, *prefabs, assets_);
    sortOnce(named);
    std::vector<AssetName> changed;
    std::set_difference(named.begin(), named.end(), held_.begin(), held_.end(), std::back_inserter(changed));
    for (const AssetName& name : changed) {
        assets_.load(name.kind, world.texts().find(name.path));
        assets_.acquire(name.kind, name.path);
    }
    changed.clear();
    std::set_difference(held_.begin(), held_.end(), named.begin(), named.end(), std::back_inserter(changed));
    for (const AssetName& name : changed) assets_.release(name.kind, name.path);
    held_ = std::move(named);
}

}  // namespace plumb
