#pragma once

#include <memory>
#include <string>
#include <vector>

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The panes of the window with their tabs and the bars between them, as the layout of the person says.
class Panes {
public:
    Panes();

    void draw(Ui& ui, ImVec2 from, ImVec2 size);

private:
    struct Tab {
        std::size_t panel = 0;  ///< of the table
        AABB box;
    };

    /// The palette comes with the first tile tool, and goes with the last.
    void showTilesWhilePainting(Workspace& workspace);
    void drawPane(Ui& ui, Dock dock, const AABB& box);
    void drawTabs(Ui& ui, Dock dock, const AABB& box);
    void drawTab(Ui& ui, Dock dock, const Tab& tab, bool alone);
    /// Those that have no room, in a list.
    void drawRest(Ui& ui, Dock dock, ImVec2 at, float side, const std::vector<std::size_t>& rest);
    void tabMenu(Ui& ui, const std::string& title, Dock dock) const;
    void dragTab(Ui& ui, const std::string& title);
    void drawSplitter(Ui& ui, const PaneBoxes::Bar& bar);
    void drawDrop(Ui& ui);

    std::vector<std::unique_ptr<Panel>> panels_;
    PaneBoxes boxes_;  ///< px on the screen
    std::vector<Tab> tabs_;
    std::string dragged_;  ///< the panel whose tab is in the hand
    bool paintedTiles_ = false;
    bool openedTiles_ = false;  ///< they were closed before the first tile tool
    std::string beforeTiles_;   ///< what they took the place of
};

}  // namespace plumb::editor::ui
