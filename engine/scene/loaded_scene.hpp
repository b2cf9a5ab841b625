#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/state_archive.hpp"
#include "math/color.hpp"
#include "reflect/field_types.hpp"
#include "reflect/json.hpp"
#include "scene/scene_layer.hpp"

namespace plumb {

struct PhysicsState;

/// An invalid value of a field in a file. Saving writes it back
/// as long as the field still has the value that replaced it.
struct KeptField {
    std::string component;
    std::string key;
    Json raw;
    Json loaded;  ///< the value that replaced it; null if there is no such field
};

/// Data of one entity in a file that no component represents; kept for saving.
struct KeptEntity {
    std::vector<std::pair<std::string, Json>> keys;        ///< unknown or invalid keys of the entity
    std::vector<std::pair<std::string, Json>> components;  ///< unknown or invalid components
    std::vector<KeptField> fields;                         ///< invalid fields of known components
    Json parent;                                           ///< an invalid parent reference
};

/// An entity that could not be loaded, kept as its text in the file.
struct SkippedEntity {
    int place = 0;  ///< index in the file's list of entities
    std::string text;
};

/// Data of a scene file other than entities with known components; kept for saving. Constant once loaded.
struct SceneRest {
    std::vector<std::pair<std::string, Json>> keys;  ///< keys of the file that the engine does not read
    std::map<std::uint64_t, KeptEntity> entities;    ///< by stable id
    std::vector<KeptField> layers;       ///< invalid fields of layers; `component` is the layer's name
    std::vector<SkippedEntity> skipped;  ///< sorted by place
};

/// A scene in a world: the content of its file except the entities, which are in the world.
struct LoadedScene {
    SceneId id;
    std::string path;
    Json effects = Json::object();  ///< the "effects" of the file: which effects are pinned on or off
    std::vector<SceneLayer> layers;
    Color background{0, 0, 0, 0};  ///< background color; fully transparent: none is drawn
    bool pauses = false;           ///< as an overlay it pauses the scenes below
    bool takesInput = false;       ///< as an overlay it keeps input from the scenes below
    /// Other content of the file; shared, as it is constant and snapshots copy resources.
    std::shared_ptr<const SceneRest> rest;
    std::shared_ptr<const PhysicsState> below;  ///< physics state of the scenes it paused; else null
    /// Number of the loading that made it, from 1: another one when the same file is loaded again.
    std::uint32_t loading = 0;

    void archive(StateArchive& archive);
};

/// The scene stack of a world, from bottom to top: an
/// overlay is drawn over those before it. A world resource.
struct LoadedScenes {
    std::vector<LoadedScene> scenes;
    std::uint64_t resumedAt = 0;  ///< tick in which an overlay was closed; no interpolation is drawn then
    std::uint32_t loadings = 0;   ///< number of scenes that were ever loaded

    void archive(StateArchive& archive);

    /// Adds a scene on top of the others.
    LoadedScene& add(LoadedScene scene) {
        scene.loading = ++loadings;
        return scenes.emplace_back(std::move(scene));
    }

    [[nodiscard]] LoadedScene* find(SceneId id) {
        for (LoadedScene& scene : scenes) {
            if (scene.id == id) return &scene;
        }
        return nullptr;
    }
};

}  // namespace plumb
