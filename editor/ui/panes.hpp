#pragma once

#include <memory>
#include <string>
#include <vector>

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Draws the panes of the window, their tabs and the splitters between them, as the settings' layout says.
class Panes {
public:
    Panes();

    void draw(Ui& ui, ImVec2 from, ImVec2 size);

private:
    struct Tab {
        std::size_t panel = 0;  ///< index in `panelTable`
        AABB box;               ///< px on screen
    };

    /// Shows the panel Tiles when a tile tool is selected, and the previous panel again when another tool is
    /// selected.
    void showTilesWhilePainting(Workspace& workspace);
    void drawPane(Ui& ui, Dock dock, const AABB& box);
    void drawTabs(Ui& ui, Dock dock, const AABB& box);
    void drawTab(Ui& ui, Dock dock, const Tab& tab, bool alone);
    /// Draws a button that opens a list of the tabs for which there is no room.
    void drawRest(Ui& ui, Dock dock, ImVec2 at, float side, const std::vector<std::size_t>& rest);
    void tabMenu(Ui& ui, const std::string& title, Dock dock) const;
    void dragTab(Ui& ui, const std::string& title);
    void drawSplitter(Ui& ui, const PaneBoxes::Bar& bar);
    void drawDrop(Ui& ui);  ///< shows where the dragged tab would be docked, and docks it on release

    std::vector<std::unique_ptr<Panel>> panels_;
    PaneBoxes boxes_;  ///< px on screen
    std::vector<Tab> tabs_;
    std::string dragged_;        ///< title of the panel whose tab is dragged; empty: none
    bool paintedTiles_ = false;  ///< a tile tool was selected in the last frame
    bool openedTiles_ = false;   ///< the panel Tiles was closed before the tile tool was selected
    std::string beforeTiles_;    ///< panel that was in front before Tiles was shown
};

}  // namespace plumb::editor::ui
