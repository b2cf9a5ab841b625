#pragma once

#include <string>

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Draws a script with line numbers. A click in the margin sets or removes a breakpoint, a right click edits
/// it; the line at which the game is stopped is highlighted.
class ScriptSource {
public:
    /// @param widget  start of the widget paths
    void draw(Ui& ui, const ScriptText& text, const std::string& widget);

private:
    void drawLine(Ui& ui, const ScriptText& text, int line, int& inLong, const std::string& widget);
    void drawMargin(Ui& ui, const ScriptText& text, int line, ImVec2 at, const std::string& widget);
    void drawMenu(Ui& ui, const std::string& widget);
    void scroll(Ui& ui, const ScriptText& text);

    Breakpoint edited_;  ///< of the menu
};

}  // namespace plumb::editor::ui
