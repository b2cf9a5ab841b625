#pragma once

#include "editor/model/document/tile_layers.hpp"
#include "editor/model/tools/tool.hpp"

namespace plumb::editor {

/// Selects cells by dragging a box, and moves or copies the selected cells by dragging them.
class MoveTilesTool final : public Tool {
public:
    void press(const ToolContext& context, const Pointer& pointer) override;
    void drag(const ToolContext& context, const Pointer& pointer) override;
    void release(const ToolContext& context, const Pointer& pointer) override;
    bool cancel(const ToolContext& context) override;
    void draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const override;

private:
    enum class Doing : unsigned char { Nothing, Boxing, Moving };

    void selectBox(const ToolContext& context, const Pointer& pointer) const;

    Doing doing_ = Doing::Nothing;
    CellPlace start_;
    CellPlace last_;
};

/// Moves the selected cells and the selection by `dx` columns and `dy` rows; overwrites the target cells.
/// @param copies  true: copies the cells instead of moving them
/// @return true if any cell changed
bool moveSelectedTiles(const ToolContext& context, int dx, int dy, bool copies);
/// Clears the selected cells.
void clearSelectedTiles(const ToolContext& context);
/// Returns the bounding box of the selected cells as a stamp, in which the cells that are not selected are
/// empty.
TileStamp selectedTiles(const ToolContext& context);

}  // namespace plumb::editor
