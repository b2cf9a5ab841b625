#pragma once

#include <string>

#include "editor/model/finder/finder.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The search dialog: finds files and entities, commands, scenes to open, or prefabs to add.
class FinderDialog {
public:
    /// Draws the dialog, if it is open. Opens it on Workspace::request (e.g. WindowRequest::FindCommand).
    /// @return path of the scene that the user has just selected to open; otherwise empty
    std::string draw(Ui& ui);

private:
    void drawField(Ui& ui);
    void drawRows(Ui& ui);
    void drawRow(Ui& ui, std::size_t row, float width);
    /// Draws the bytes [from, to) of an item's text, matched letters highlighted. @return x of its end, px
    static float drawLetters(const Ui& ui, const FinderRow& row, const FinderItem& item, std::size_t from,
                             std::size_t to, ImVec2 at, bool dim);

    Finder finder_;
    std::string typed_;    ///< text of the search field
    bool scroll_ = false;  ///< true: the list scrolls to the selected row in the next frame
    bool done_ = false;    ///< true: a row was clicked or Enter was pressed in this frame
};

}  // namespace plumb::editor::ui
