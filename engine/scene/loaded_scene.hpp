#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "math/color.hpp"
#include "reflect/field_types.hpp"
#include "reflect/json.hpp"
#include "scene/scene_layer.hpp"

namespace plumb {

struct PhysicsState;

/// A value in a file that could not be used as it stands. Saving writes it back while the field still holds
/// what it got instead.
struct KeptField {
    std::string component;
    std::string key;
    Json raw;
    Json loaded;  ///< what the field got instead; null when there is no such field
};

/// What a file says about one entity that no component holds.
struct KeptEntity {
    std::vector<std::pair<std::string, Json>> keys;        ///< of the entity
    std::vector<std::pair<std::string, Json>> components;  ///< unknown or broken ones, whole
    std::vector<KeptField> fields;
    Json parent;  ///< one that could not be used
};

/// An entity that could not be loaded, as its text stands in the file.
struct SkippedEntity {
    int place = 0;  ///< index in the file's list
    std::string text;
};

/// What a scene file holds beside entities with known components. Never changed once loaded.
struct SceneRest {
    std::vector<std::pair<std::string, Json>> keys;  ///< unknown ones of the file
    std::map<std::uint64_t, KeptEntity> entities;    ///< by lasting id
    std::vector<KeptField> layers;                   ///< component: the layer's name
    std::vector<SkippedEntity> skipped;              ///< by place
};

/// A scene in a world: all of its file but the entities, which are in the world.
struct LoadedScene {
    SceneId id;
    std::string path;
    Json effects = Json::object();
    std::vector<SceneLayer> layers;
    Color background{0, 0, 0, 0};  ///< behind everything; nothing is drawn when it is clear
    bool pauses = false;           ///< an overlay: those below stand still
    bool takesInput = false;       ///< an overlay: those below hear nothing of the player
    /// Shared, because snapshots copy resources and these never change.
    std::shared_ptr<const SceneRest> rest;
    std::shared_ptr<const PhysicsState> below;  ///< the bodies of what it paused, as they were; else null
};

/// The scenes of a world, from the bottom to the top: an overlay is drawn over those before it. A resource.
struct LoadedScenes {
    std::vector<LoadedScene> scenes;
    std::uint64_t resumedAt = 0;  ///< the tick in which an overlay was closed: things are where they stood

    [[nodiscard]] LoadedScene* find(SceneId id) {
        for (LoadedScene& scene : scenes) {
            if (scene.id == id) return &scene;
        }
        return nullptr;
    }
};

}  // namespace plumb
