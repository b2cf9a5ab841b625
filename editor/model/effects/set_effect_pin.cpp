#include "editor/model/effects/set_effect_pin.hpp"

#include "core/text.hpp"
#include "editor/model/document/document.hpp"
#include "scene/effect_table.hpp"
#include "scene/loaded_scene.hpp"

namespace plumb::editor {
namespace {

LoadedScene* sceneOf(Document& document) {
    LoadedScenes* scenes = document.world.findResource<LoadedScenes>();
    return scenes == nullptr ? nullptr : scenes->find(document.scene);
}

}  // namespace

std::string SetEffectPin::label() const { return format("effect {}: {}", effect_, nameOf(pin_)); }

void SetEffectPin::apply(Document& document) {
    LoadedScene* scene = sceneOf(document);
    if (scene == nullptr) return;
    before_ = scene->effects;
    if (!scene->effects.is_object()) scene->effects = Json::object();  // an invalid value has no effect
    if (pin_ == Pin::Auto) {
        scene->effects.erase(effect_);
    } else {
        scene->effects[effect_] = std::string{nameOf(pin_)};
    }
    after_ = scene->effects;
}

void SetEffectPin::revert(Document& document) {
    if (LoadedScene* scene = sceneOf(document)) scene->effects = before_;
}

}  // namespace plumb::editor
