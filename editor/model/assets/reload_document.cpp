#include "editor/model/assets/reload_document.hpp"

#include "core/log.hpp"

namespace plumb::editor {

Result<LoadReport> reloadDocument(Document& document, const SceneContext& context, std::string_view text) {
    const std::string before = sceneToJson(document.world, context, document.scene);
    const std::vector<ObjectId> selected = document.selection.all();
    const auto load = [&](std::string_view content) {
        unloadScene(document.world, document.scene);
        document.world.clear();
        return loadScene(document.world, context, document.scenePath, content);
    };
    Result<LoadReport> report = load(text);
    const Result<LoadReport> kept = report ? report : load(before);
    if (kept) document.scene = kept->scene;
    document.reindex();
    for (const ObjectId id : selected) {
        if (document.find(id)) document.selection.add(id);
    }
    if (AssetStore* assets = document.world.service<AssetStore>())
        loadAssets(document.world, context.types, *assets);
    return report;
}

}  // namespace plumb::editor
