#include "editor/model/tools/move_tiles_tool.hpp"
#include "editor/model/tools/move_tool.hpp"
#include "editor/model/tools/rotate_tool.hpp"
#include "editor/model/tools/scale_tool.hpp"
#include "editor/model/tools/select_tool.hpp"
#include "editor/model/tools/shape_tool.hpp"
#include "editor/model/tools/tile_tools.hpp"

namespace plumb::editor {
namespace {

template <class T>
std::unique_ptr<Tool> make() {
    return std::make_unique<T>();
}
template <TileTool::Mode Mode>
std::unique_ptr<Tool> makeTileTool() {
    return std::make_unique<TileTool>(Mode);
}

}  // namespace

// Configurable keys are written as action ids in braces, {edit.delete}, which withKeys replaces.
const std::vector<ToolRow>& toolTable() {
    using Mode = TileTool::Mode;
    static const std::vector<ToolRow> rows{
        {"Select", "tool.select",
         "Click or drag a box to select; drag an entity to move it. Shift adds, Alt selects the one below.",
         false, PaintChoice::Unchanged, &make<SelectTool>},
        {"Move", "tool.move",
         "Drag an arrow to move along it, the square to move freely. Ctrl inverts snapping.", false,
         PaintChoice::Unchanged, &make<MoveTool>},
        {"Rotate", "tool.rotate",
         "Drag the ring to rotate. Snapping uses the grid's angle steps; Ctrl inverts it.", false,
         PaintChoice::Unchanged, &make<RotateTool>},
        {"Scale", "tool.scale",
         "Drag an arm's box to scale one axis, the square for both. Ctrl inverts snapping.", false,
         PaintChoice::Unchanged, &make<ScaleTool>},
        {"Shape", "tool.shape",
         "Drag corners, sides, anchors or the pivot. Click an outline to add a corner; {edit.delete} removes "
         "it.",
         false, PaintChoice::Unchanged, &make<ShapeTool>},
        {"Brush", "tool.brush",
         "Paints tiles. Shift draws a line from the last stroke, Ctrl+Shift a box, the right button picks.",
         true, PaintChoice::Stamp, &makeTileTool<Mode::Brush>},
        {"Terrain", "tool.terrain",
         "Paints terrain with automatic borders and corners. Shift draws a line, Ctrl+Shift a box.", true,
         PaintChoice::Terrain, &makeTileTool<Mode::Brush>},
        {"Line", "tool.line", "Drag to draw a line with the tile, the pattern or the terrain.", true,
         PaintChoice::Unchanged, &makeTileTool<Mode::Line>},
        {"Rectangle", "tool.rectangle",
         "Drag a box to fill it with the tile, the pattern or the terrain. Shift makes it a square.", true,
         PaintChoice::Unchanged, &makeTileTool<Mode::Rectangle>},
        {"Ellipse", "tool.ellipse", "Drag a box to fill its ellipse. Shift makes it a circle.", true,
         PaintChoice::Unchanged, &makeTileTool<Mode::Ellipse>},
        {"Fill", "tool.fill",
         "Click to fill connected equal tiles, with Shift all equal ones, inside the selection all of it.",
         true, PaintChoice::Unchanged, &makeTileTool<Mode::Fill>},
        {"Eraser", "tool.erase", "Clears tiles. Shift draws a line from the last stroke, Ctrl+Shift a box.",
         true, PaintChoice::Unchanged, &makeTileTool<Mode::Erase>},
        {"Pick", "tool.pick", "Click a tile, or drag a box of them, to paint with it.", true,
         PaintChoice::Unchanged, &makeTileTool<Mode::Pick>},
        {"Move tiles", "tool.moveTiles",
         "Drag a box to select cells, drag these to move them, with Alt to copy. Shift adds, Ctrl removes.",
         true, PaintChoice::Unchanged, &make<MoveTilesTool>},
        {"Same tile", "tool.same", "Click a tile to select all equal ones. Shift adds, Ctrl removes.", true,
         PaintChoice::Unchanged, &makeTileTool<Mode::Same>},
    };
    return rows;
}

}  // namespace plumb::editor
