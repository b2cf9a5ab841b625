#pragma once

#include <string>

#include "editor/model/finder/finder.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// A field to type into, and what it finds: files and entities, commands, scenes to open, prefabs to add.
class FinderDialog {
public:
    /// Opens by itself when the workspace asks for it.
    /// @return path of a scene that was chosen, once; else empty
    std::string draw(Ui& ui);

private:
    void drawField(Ui& ui);
    void drawRows(Ui& ui);
    void drawRow(Ui& ui, std::size_t row, float width);
    /// The text with its found letters bright. @return where it ends
    static float drawLetters(const Ui& ui, const FinderRow& row, const FinderItem& item, std::size_t from,
                             std::size_t to, ImVec2 at, bool dim);

    Finder finder_;
    std::string typed_;
    bool scroll_ = false;  ///< the chosen row has to come into sight
    bool done_ = false;    ///< a row was clicked, or Enter was pressed
};

}  // namespace plumb::editor::ui
