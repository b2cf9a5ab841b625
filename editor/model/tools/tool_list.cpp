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

// Keys that may be others stand in hints as their action, for withKeys: {edit.delete}.
const std::vector<ToolRow>& toolTable() {
    using Mode = TileTool::Mode;
    static const std::vector<ToolRow> rows{
        {"Select", "tool.select",
         "Click or drag a box to select; drag a thing to move it. Shift adds, Alt goes below.", false,
         Hand::Keeps, &make<SelectTool>},
        {"Move", "tool.move",
         "Drag an arrow to move along it, the square to move freely. Ctrl inverts snapping.", false,
         Hand::Keeps, &make<MoveTool>},
        {"Rotate", "tool.rotate",
         "Drag the ring to turn. Snapping goes in steps of 15 degrees; Ctrl inverts it.", false, Hand::Keeps,
         &make<RotateTool>},
        {"Scale", "tool.scale",
         "Drag a box to scale along it, the square to scale both. Ctrl inverts snapping.", false, Hand::Keeps,
         &make<ScaleTool>},
        {"Shape", "tool.shape",
         "Drag sides and corners of colliders, anchors, the pivot. An outline takes new corners; "
         "{edit.delete} "
         "removes.",
         false, Hand::Keeps, &make<ShapeTool>},
        {"Brush", "tool.brush",
         "Paints tiles. Shift draws a line from the last stroke, Ctrl+Shift a box, the right button picks.",
         true, Hand::Stamp, &makeTileTool<Mode::Brush>},
        {"Terrain", "tool.terrain",
         "Paints terrain; borders and corners come by themselves. Shift draws a line, Ctrl+Shift a box.",
         true, Hand::Terrain, &makeTileTool<Mode::Brush>},
        {"Line", "tool.line", "Drag a line of the tile, the pattern or the terrain.", true, Hand::Keeps,
         &makeTileTool<Mode::Line>},
        {"Rectangle", "tool.rectangle",
         "Drag a box to fill it with the tile, the pattern or the terrain. Shift makes it a square.", true,
         Hand::Keeps, &makeTileTool<Mode::Rectangle>},
        {"Ellipse", "tool.ellipse", "Drag a box to fill its ellipse. Shift makes it a circle.", true,
         Hand::Keeps, &makeTileTool<Mode::Ellipse>},
        {"Fill", "tool.fill",
         "Click to fill connected equal tiles, with Shift all equal ones, in the selection the selection.",
         true, Hand::Keeps, &makeTileTool<Mode::Fill>},
        {"Eraser", "tool.erase", "Clears tiles. Shift draws a line from the last stroke, Ctrl+Shift a box.",
         true, Hand::Keeps, &makeTileTool<Mode::Erase>},
        {"Pick", "tool.pick", "Click a tile, or drag a box of them, to paint with it.", true, Hand::Keeps,
         &makeTileTool<Mode::Pick>},
        {"Move tiles", "tool.moveTiles",
         "Drag a box to select cells, drag them to move them, with Alt to copy. Shift adds, Ctrl takes away.",
         true, Hand::Keeps, &make<MoveTilesTool>},
        {"Same tile", "tool.same", "Click a tile to select all that are equal. Shift adds, Ctrl takes away.",
         true, Hand::Keeps, &makeTileTool<Mode::Same>},
    };
    return rows;
}

}  // namespace plumb::editor
