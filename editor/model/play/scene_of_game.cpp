#include "editor/model/play/scene_of_game.hpp"

#include "scene/loaded_scene.hpp"

namespace plumb::editor {

std::string sceneOfGame(const Workspace& workspace) {
    if (!workspace.play.running()) return {};
    const auto* loaded = std::as_const(workspace.play.world()).findResource<LoadedScenes>();
    return loaded == nullptr || loaded->scenes.empty() ? std::string{} : loaded->scenes.front().path;
}

}  // namespace plumb::editor
