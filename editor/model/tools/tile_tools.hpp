#pragma once

#include <optional>

#include "editor/model/commands/paint_tiles.hpp"
#include "editor/model/tools/tool.hpp"

namespace plumb::editor {

/// Paints the tiles of one layer. In every mode Alt, or the right mouse button, picks from the layer what is
/// then painted: one tile, or all in a dragged box.
class TileTool final : public Tool {
public:
    enum class Mode : unsigned char { Brush, Erase, Rectangle, Fill, Pick };
    explicit TileTool(Mode mode) : mode_{mode} {}

    void press(const ToolContext& context, const Pointer& pointer) override;
    void drag(const ToolContext& context, const Pointer& pointer) override;
    void release(const ToolContext& context, const Pointer& pointer) override;
    bool cancel(const ToolContext& context) override;
    void draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const override;
    [[nodiscard]] std::string_view next() const override;

private:
    enum class Doing : unsigned char { Nothing, Painting, Boxing, Picking };

    /// The stamp laid on the layer with its corner at `at`; empty cells of a pattern are left out.
    [[nodiscard]] std::vector<PaintTiles::Cell> stampAt(const ToolContext& context, CellPlace at) const;
    void paintLine(const ToolContext& context, CellPlace from, CellPlace to) const;
    void paint(const ToolContext& context, std::vector<PaintTiles::Cell> cells) const;
    void fillBox(const ToolContext& context) const;
    void fillConnected(const ToolContext& context, CellPlace at) const;
    void pick(const ToolContext& context) const;
    void drawGhost(const ToolContext& context, CellPlace at, Overlay& overlay) const;

    Mode mode_;
    Doing doing_ = Doing::Nothing;
    CellPlace start_;
    CellPlace last_;
    std::optional<CellPlace> strokeEnd_;  // of the stroke before: Shift draws a line from there
};

/// The tile layer that tile tools work on: the selected one, else the one they worked on last, else the
/// first that is solid, else the first.
ObjectId activeTileLayer(const Document& document, const TilePaint& paint);

/// The cell of a layer at a point of the world, and the box of a cell (px, world).
CellPlace cellAt(const Document& document, ObjectId layer, Vec2 point);
AABB boxOfCell(const Document& document, ObjectId layer, CellPlace place);

}  // namespace plumb::editor
