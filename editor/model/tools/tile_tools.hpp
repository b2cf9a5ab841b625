#pragma once

#include "editor/model/tools/tool.hpp"
#include "math/tile_grid.hpp"

namespace plumb::editor {

/// What the tile tools share: the cell that is painted. One per editor; tools borrow it.
struct TileBrush {
    TileCell cell = 1;
};

/// Paints the tiles of the selected tile layer: brush, eraser or bucket. Alt picks the tile under the mouse.
class TileTool final : public Tool {
public:
    enum class Mode : unsigned char { Brush, Erase, Fill };
    explicit TileTool(Mode mode) : mode_{mode} {}

    void press(const ToolContext& context, const Pointer& pointer) override;
    void drag(const ToolContext& context, const Pointer& pointer) override;
    void release(const ToolContext& context, const Pointer& pointer) override;
    bool cancel(const ToolContext& context) override;
    void draw(const Document& document, const Pointer& pointer, Overlay& overlay) const override;

    TileBrush brush;

private:
    void paintLine(const ToolContext& context, Vec2 from, Vec2 to);

    Mode mode_;
    bool painting_ = false;
    Vec2 last_;  // px, world
};

/// The tile layer that tile tools work on: the selected one, or the only one. Nobody when there is a choice.
ObjectId activeTileLayer(const Document& document);

/// The cell of a layer at a point of the world.
struct CellPlace {
    int x = 0;
    int y = 0;
};
CellPlace cellAt(const Document& document, ObjectId layer, Vec2 point);
/// The box of a cell (px, world).
AABB boxOfCell(const Document& document, ObjectId layer, CellPlace place);

}  // namespace plumb::editor
