#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "editor/model/tiles/tile_palette.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The tiles of a set as they lie in its picture: zoomed with Ctrl and the wheel, panned with the middle
/// button, animated ones in motion.
class PaletteView {
public:
    /// Draws the tiles into the current child window.
    /// @param found  the tiles that stay bright, in rising order; null: all
    void draw(Ui& ui, const Tileset& tileset, const std::string& path, const std::vector<int>* found);

    // After draw.

    [[nodiscard]] const TilePalette& tiles() const { return tiles_; }
    [[nodiscard]] bool pressed() const { return pressed_; }
    [[nodiscard]] bool held() const { return held_; }
    [[nodiscard]] bool released() const { return released_; }
    [[nodiscard]] bool hovered() const { return hovered_; }
    /// The place nearest to the mouse.
    [[nodiscard]] CellPlace at() const { return at_; }
    [[nodiscard]] AABB boxOf(CellPlace place) const;  ///< px on screen
    void frame(CellPlace a, CellPlace b, ImU32 color, float thickness = 2.0f) const;
    /// A word on the tile under the mouse.
    void describe(const Tileset& tileset) const;

    /// "−  3x  +" beside other things.
    void zoomButtons(Ui& ui, const std::string& path);
    bool grid = true;

private:
    void drawTiles(Ui& ui, const Tileset& tileset, const std::vector<int>* found) const;
    void navigate(Ui& ui);

    float zoom_ = 0.0f;  ///< 0: as large as there is room
    Vec2 from_;          ///< px on screen
    Vec2 cell_;          ///< px on screen
    TilePalette tiles_;
    CellPlace at_;
    bool pressed_ = false;
    bool held_ = false;
    bool released_ = false;
    bool hovered_ = false;
};

}  // namespace plumb::editor::ui
