#pragma once

#include <array>
#include <string>

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The items of the menu View that open panels and select layouts, and the dialog that asks for a layout's
/// name.
class LayoutMenu {
public:
    void drawItems(Ui& ui);
    void askName();             ///< opens the dialog in the next drawQuestion()
    void drawQuestion(Ui& ui);  ///< draws the dialog, if it is open

private:
    static void panelItems(Ui& ui);
    static void layoutItems(Ui& ui);

    std::array<char, 48> name_{};
    bool ask_ = false;
};

}  // namespace plumb::editor::ui
