#include "editor/model/assets/make_tileset.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "assets/asset_store.hpp"
#include "core/text.hpp"
#include "editor/model/assets/asset_catalog.hpp"
#include "editor/model/commands/write_asset.hpp"

namespace plumb::editor {

TilesetSize roomFor(const Tileset& tileset, const Texture& picture) {
    const auto along = [&](int side, int tile) {
        return std::max((side - 2 * tileset.margin + tileset.spacing) / (tile + tileset.spacing), 0);
    };
    return {along(picture.width, tileset.tileWidth), along(picture.height, tileset.tileHeight)};
}

void setTileSize(Tileset& tileset, int width, int height, const Texture& picture) {
    tileset.tileWidth = std::max(width, 1), tileset.tileHeight = std::max(height, 1);
    const TilesetSize room = roomFor(tileset, picture);
    tileset.columns = std::max(room.columns, 1);
    tileset.count = room.columns * room.rows;
    tileset.sizes.clear(), tileset.tiles.clear(), tileset.terrains.clear();
}

Result<std::string> makeTileset(Workspace& workspace, std::string_view picture) {
    const std::string shown{picture};
    if (assetKindOf(picture) != AssetKind::Texture)
        return Error{shown, "a tileset needs an image, and this file is not one", "select an image file"};
    if (!workspace.canEdit()) return Error{shown, "the game is running", "stop it first"};
    const std::string path = shown.substr(0, shown.rfind('.')) + ".tileset.json";
    std::error_code ignored;
    if (std::filesystem::exists(workspace.project.root / path, ignored)) return path;
    const Texture* texture = workspace.assets.find(workspace.assets.loadTexture(picture));
    Tileset tileset;
    tileset.image = picture;
    const Vec2 cell = workspace.grid.size;
    if (texture != nullptr) {
        setTileSize(tileset, static_cast<int>(std::lround(cell.x)), static_cast<int>(std::lround(cell.y)),
                    *texture);
    }
    if (tileset.count == 0) {
        return Error{
            shown, format("no tile of {} x {} px fits into the image", tileset.tileWidth, tileset.tileHeight),
            "set the grid size to the size of the tiles"};
    }
    workspace.undo.endGesture();
    workspace.undo.push(std::make_unique<WriteAsset>(format("create {}", path), workspace.project.root,
                                                     workspace.assets, path, writeTileset(tileset)));
    workspace.undo.endGesture();
    return path;
}

}  // namespace plumb::editor
