#pragma once

#include <optional>

#include "editor/model/tiles/tile_brush.hpp"
#include "editor/model/tools/tool.hpp"

namespace plumb::editor {

/// Paints the active tile layer with the current stamp or terrain, in the shape given by the mode. In every
/// mode, Alt or (by a setting) the right mouse button picks a new stamp from the layer: one tile, or those in
/// a dragged box.
class TileTool final : public Tool {
public:
    enum class Mode : unsigned char { Brush, Line, Rectangle, Ellipse, Fill, Erase, Pick, Same };
    explicit TileTool(Mode mode) : mode_{mode} {}

    void press(const ToolContext& context, const Pointer& pointer) override;
    void drag(const ToolContext& context, const Pointer& pointer) override;
    void release(const ToolContext& context, const Pointer& pointer) override;
    bool cancel(const ToolContext& context) override;
    void draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const override;
    [[nodiscard]] std::string_view next() const override;

private:
    enum class Doing : unsigned char { Nothing, Painting, Shaping, Picking };

    [[nodiscard]] TileBrush brush(const ToolContext& context) const;
    [[nodiscard]] CellPlace placeAt(const ToolContext& context, const Pointer& pointer) const;
    [[nodiscard]] bool picks(const ToolContext& context, const Pointer& pointer) const;
    [[nodiscard]] std::vector<CellPlace> shaped(const TileBrush& brush) const;
    void click(const ToolContext& context, const Pointer& pointer) const;
    void fill(const ToolContext& context, const Pointer& pointer) const;
    void selectSame(const ToolContext& context, const Pointer& pointer) const;
    void paintLine(const ToolContext& context, CellPlace from, CellPlace to) const;
    void paint(const ToolContext& context, const TileBrush& brush, std::vector<CellPlace> places) const;
    void pick(const ToolContext& context) const;
    void drawGhost(const ToolContext& context, const TileBrush& brush, const std::vector<CellPlace>& places,
                   CellPlace origin, Overlay& overlay) const;
    void drawFill(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const;
    void drawCursor(const ToolContext& context, const Pointer& pointer, CellPlace at, Overlay& overlay) const;

    Mode mode_;
    Mode shape_ = Mode::Rectangle;  // shape being dragged while `doing_` is Shaping
    TileInk ink_ = TileInk::Stamp;  // ink of the present stroke
    Doing doing_ = Doing::Nothing;
    std::uint32_t stroke_ = 1;  // number of the stroke: seed of random tiles
    CellPlace start_;           // cell of the press
    CellPlace last_;            // cell of the last drag
    mutable DerivedTerrain derived_;
    std::optional<CellPlace> strokeEnd_;  // end of the previous stroke, from which Shift draws a line
};

}  // namespace plumb::editor
