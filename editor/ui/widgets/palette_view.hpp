#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "editor/model/tiles/tile_palette.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The tiles of a tileset in the layout of its image. Ctrl+wheel
/// zooms, the middle button pans; animated tiles play.
class PaletteView {
public:
    /// Draws the tiles into the current child window.
    /// @param found  sorted numbers of the tiles to draw undimmed; null: no tile is dimmed
    void draw(Ui& ui, const Tileset& tileset, const std::string& path, const std::vector<int>* found);

    // Valid after draw().

    [[nodiscard]] const TilePalette& tiles() const { return tiles_; }
    [[nodiscard]] bool pressed() const { return pressed_; }
    [[nodiscard]] bool held() const { return held_; }
    [[nodiscard]] bool released() const { return released_; }
    [[nodiscard]] bool hovered() const { return hovered_; }
    /// The cell nearest to the mouse.
    [[nodiscard]] CellPlace at() const { return at_; }
    [[nodiscard]] AABB boxOf(CellPlace place) const;  ///< rectangle of a cell, px on screen
    void frame(CellPlace a, CellPlace b, ImU32 color, float thickness = 2.0f) const;  ///< around cells a to b
    /// Draws a frame around the tile under the mouse, and its description as a tooltip.
    void describe(const Tileset& tileset) const;

    /// Draws the zoom buttons "−  3x  +" and the grid checkbox on the current line.
    void zoomButtons(Ui& ui, const std::string& path);
    bool grid = true;

private:
    void drawTiles(Ui& ui, const Tileset& tileset, const std::vector<int>* found) const;
    void navigate(Ui& ui);

    float zoom_ = 0.0f;  ///< zoom factor; 0: computed from the available width
    Vec2 from_;          ///< upper left corner, px on screen
    Vec2 cell_;          ///< size of a cell, px on screen
    TilePalette tiles_;
    CellPlace at_;
    bool pressed_ = false;
    bool held_ = false;
    bool released_ = false;
    bool hovered_ = false;
};

}  // namespace plumb::editor::ui
