#include "editor/model/tools/move_tool.hpp"
#include "editor/model/tools/rotate_tool.hpp"
#include "editor/model/tools/scale_tool.hpp"
#include "editor/model/tools/select_tool.hpp"
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

const std::vector<ToolRow>& toolTable() {
    using Mode = TileTool::Mode;
    static const std::vector<ToolRow> rows{
        {"Select", "tool.select",
         "Click or drag a box to select; drag a thing to move it. Shift adds, Alt goes below.", false,
         &make<SelectTool>},
        {"Move", "tool.move",
         "Drag an arrow to move along it, the square to move freely. Ctrl inverts snapping.", false,
         &make<MoveTool>},
        {"Rotate", "tool.rotate",
         "Drag the ring to turn. Snapping goes in steps of 15 degrees; Ctrl inverts it.", false,
         &make<RotateTool>},
        {"Scale", "tool.scale",
         "Drag a box to scale along it, the square to scale both. Ctrl inverts snapping.", false,
         &make<ScaleTool>},
        {"Brush", "tool.brush",
         "Paints tiles. Shift draws a line from the last stroke, the right button picks.", true,
         &makeTileTool<Mode::Brush>},
        {"Eraser", "tool.erase", "Clears tiles. Shift draws a line from the last stroke.", true,
         &makeTileTool<Mode::Erase>},
        {"Rectangle", "tool.rectangle", "Drag a box to fill it with the tile or the pattern.", true,
         &makeTileTool<Mode::Rectangle>},
        {"Fill", "tool.fill", "Click to fill connected equal tiles.", true, &makeTileTool<Mode::Fill>},
        {"Pick", "tool.pick", "Click a tile, or drag a box of them, to paint with it.", true,
         &makeTileTool<Mode::Pick>},
    };
    return rows;
}

}  // namespace plumb::editor
