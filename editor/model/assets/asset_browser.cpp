#include "editor/model/assets/asset_browser.hpp"

#include "assets/asset_store.hpp"
#include "core/text.hpp"
#include "editor/model/assets/move_asset.hpp"
#include "editor/model/assets/place_asset.hpp"

namespace plumb::editor {

AssetBrowser::AssetBrowser(Workspace& workspace) : workspace_{workspace}, catalog_{workspace.project.root} {
    catalog_.refresh();
    if (!catalog_.in("assets").empty()) folder = "assets";
}

void AssetBrowser::enter(std::string_view wanted) {
    folder = wanted;
    search.clear();
    selected.clear();
}

std::vector<AssetItem> AssetBrowser::shown() const {
    return search.empty() ? catalog_.in(folder) : catalog_.search(search);
}

std::string AssetBrowser::describe(const AssetItem& item) {
    AssetStore& assets = workspace_.assets;
    std::string text{nameOfKind(item.kind)};
    if (item.kind == AssetKind::Texture) {
        const Texture* texture = assets.find(assets.loadTexture(item.path));
        if (texture != nullptr && texture->width > 0)
            text += format(", {} x {} px", texture->width, texture->height);
    } else if (item.kind == AssetKind::Tileset) {
        const Tileset& set = assets.tileset(assets.loadTileset(item.path));
        text += format(", {} tiles of {} x {} px", set.count, set.tileWidth, set.tileHeight);
    } else if (item.kind == AssetKind::Animation) {
        text += format(", {} clips", assets.animation(assets.loadAnimation(item.path)).clips.size());
    }
    return text;
}

std::vector<AssetUse> AssetBrowser::usesOf(std::string_view path) const {
    std::error_code ignored;
    const bool isFolder = std::filesystem::is_directory(catalog_.root() / path, ignored);
    return usesOfAsset(catalog_.root(), path, isFolder);
}

std::string AssetBrowser::rename(std::string_view from, std::string_view to) {
    const std::string wanted{to};
    if (!workspace_.canEdit()) return "Stop the game first.";
    const Result<Done> moved = moveAsset(workspace_.prefabs(), workspace_.assets, from, wanted,
                                         [&workspace = workspace_] { workspace.safety.opened(); });
    if (!moved) return moved.error().text();
    workspace_.notice = format("Renamed {} to {}", from, wanted);
    selected = wanted;
    refresh();
    return {};
}

std::string AssetBrowser::remove(std::string_view path) {
    const std::string name{path};
    if (!workspace_.canEdit()) return "Stop the game first.";
    if (path == workspace_.document.scenePath) return "This scene is open; open another one first.";
    const Result<Done> deleted = deleteAsset(workspace_.prefabs(), path);
    if (!deleted) return deleted.error().text();
    workspace_.notice = format("Deleted {}", name);
    selected.clear();
    refresh();
    return {};
}

void AssetBrowser::moveInto(std::string_view path, std::string_view into) {
    const std::string name{path.substr(path.rfind('/') + 1)};
    const std::string problem = rename(path, into.empty() ? name : format("{}/{}", into, name));
    if (!problem.empty()) workspace_.notice = problem;
}

void AssetBrowser::place(std::string_view path, Vec2 at) {
    const Result<Done> placed = placeAsset(workspace_, path, at);
    workspace_.notice = placed ? format("Added {}", path) : placed.error().text();
}

}  // namespace plumb::editor
