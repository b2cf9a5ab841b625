#include "editor/model/problems.hpp"

#include "core/text.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "editor/model/tiles/tile_brush.hpp"

namespace plumb::editor {

Problems& problemsOf(Workspace& workspace) { return workspace.document.world.resource<Problems>(); }

std::string_view whyNotPainted(const Workspace& workspace, Vec2 at) {
    const Document& document = workspace.document;
    if (!workspace.paintsTiles()) return {};
    const ObjectId layer = activeTileLayer(document, workspace.tiles);
    const TileGrid* grid = gridOf(document, layer);
    if (grid == nullptr) return "This scene has no tile layer; add one in the panel Tiles";
    if (document.view.locks(layer))
        return "This layer is locked; the lock beside its name in the panel Tiles opens it";
    if (document.view.hides(layer))
        return "This layer is hidden; the eye beside its name in the panel Tiles shows it";
    const CellPlace cell = cellAt(document, layer, at);
    if (grid->has(cell.x, cell.y)) return {};
    return "The layer ends before that; cells of its TileLayer, in the inspector, make it larger";
}

Result<Path> newSceneFile(const Path& project, std::string_view name) {
    const std::string path = format("scenes/{}.scene.json", name);
    if (name.empty() || name.find('/') != std::string_view::npos)
        return Error{path, "this is no name for a scene", "write a word, e.g. \"level1\""};
    Result<Path> file = pathInside(project, path);
    if (file && std::filesystem::exists(*file))
        return Error{path, "there is such a scene", "choose another name"};
    return file;
}

}  // namespace plumb::editor
