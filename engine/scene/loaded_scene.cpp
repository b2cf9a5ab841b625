#include "scene/loaded_scene.hpp"

#include "reflect/json_text.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

void LoadedScene::archive(StateArchive& archive) {
    archive.text(path);
    archive.list(layers);
    archive.value(background);
    archive.value(pauses);
    archive.value(takesInput);
    archive.value(loading);
    std::string text = archive.reading() ? std::string{} : writeJson(effects);
    archive.text(text);
    std::uint32_t hasPhysics = below != nullptr ? 1 : 0;
    archive.number(hasPhysics);
    PhysicsState paused;
    if (hasPhysics != 0) {
        if (below != nullptr) paused = *below;
        paused.archive(archive);
    }
    if (!archive.reading()) return;
    id = {textId(path)};
    rest.reset();  // what editors keep of the file
    below = hasPhysics != 0 ? std::make_shared<const PhysicsState>(std::move(paused)) : nullptr;
    Result<Json> read = parseJson(text, path);
    if (!read) return archive.fail();
    effects = std::move(*read);
}

void LoadedScenes::archive(StateArchive& archive) {
    const std::size_t count = archive.count(scenes.size());
    if (archive.reading()) scenes.assign(count, {});
    for (LoadedScene& scene : scenes) scene.archive(archive);
    archive.value(resumedAt);
    archive.value(loadings);
}

}  // namespace plumb
