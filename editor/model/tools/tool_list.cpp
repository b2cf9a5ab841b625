#include "editor/model/tools/move_tool.hpp"
#include "editor/model/tools/select_tool.hpp"
#include "editor/model/tools/tile_tools.hpp"

namespace plumb::editor {

const std::vector<ToolRow>& toolTable() {
    static const std::vector<ToolRow> rows{
        {"Select", "tool.select",
         "Click or drag a box to select; drag a thing to move it. Shift adds, Alt goes below.",
         [] { return std::unique_ptr<Tool>{std::make_unique<SelectTool>()}; }},
        {"Move", "tool.move",
         "Drag to move what is selected. Shift keeps to one axis, Ctrl inverts snapping.",
         [] { return std::unique_ptr<Tool>{std::make_unique<MoveTool>()}; }},
        {"Brush", "tool.brush", "Paints tiles of the selected layer. Alt picks the tile under the mouse.",
         [] { return std::unique_ptr<Tool>{std::make_unique<TileTool>(TileTool::Mode::Brush)}; }},
        {"Erase", "tool.erase", "Clears tiles of the selected layer.",
         [] { return std::unique_ptr<Tool>{std::make_unique<TileTool>(TileTool::Mode::Erase)}; }},
        {"Fill", "tool.fill", "Fills connected equal tiles. Alt picks the tile under the mouse.",
         [] { return std::unique_ptr<Tool>{std::make_unique<TileTool>(TileTool::Mode::Fill)}; }},
    };
    return rows;
}

}  // namespace plumb::editor
