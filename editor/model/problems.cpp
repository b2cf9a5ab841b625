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
    if (grid == nullptr) return "This scene has no tile layer; add one in the Tiles panel";
    if (document.view.locks(layer))
        return "This layer is locked; click the lock beside its name in the Tiles panel to unlock it";
    if (document.view.hides(layer))
        return "This layer is hidden; click the eye beside its name in the Tiles panel to show it";
    const CellPlace cell = cellAt(document, layer, at);
    if (grid->has(cell.x, cell.y)) return {};
    return "This point is outside the layer; increase \"cells\" of its TileLayer in the inspector";
}

Result<Path> newSceneFile(const Path& project, std::string_view name) {
    const std::string path = format("scenes/{}.scene.json", name);
    if (name.empty() || name.find('/') != std::string_view::npos)
        return Error{path, "the name of a scene must not be empty or contain a slash",
                     "use a name like \"level1\""};
    Result<Path> file = pathInside(project, path);
    if (file && std::filesystem::exists(*file))
        return Error{path, "a scene with this name exists", "choose another name"};
    return file;
}

}  // namespace plumb::editor
