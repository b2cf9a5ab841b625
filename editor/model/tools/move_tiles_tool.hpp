#pragma once

#include "editor/model/document/tile_layers.hpp"
#include "editor/model/tools/tool.hpp"

namespace plumb::editor {

/// Selects cells by a box, and moves or copies what is selected by dragging it.
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

/// Moves the selected cells by so many columns and rows, over what is there; the selection goes with them.
/// @param copies  leaves what was there
/// @return whether anything changed
bool moveSelectedTiles(const ToolContext& context, int dx, int dy, bool copies);
/// Clears the selected cells.
void clearSelectedTiles(const ToolContext& context);
/// The selected cells in the box around them; all else in it is empty.
TileStamp selectedTiles(const ToolContext& context);

}  // namespace plumb::editor
