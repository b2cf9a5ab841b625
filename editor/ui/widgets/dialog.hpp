#pragma once

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Begins a modal dialog in the center of the window, limited to the window's size; larger content scrolls.
/// If it returns true, the caller must call ImGui::EndPopup().
/// @param wanted  size, px at scale 1
/// @param stays   not null: adds a close button, which sets *stays to false
bool beginDialog(const Ui& ui, const char* title, ImVec2 wanted, bool* stays = nullptr);

/// Moves the cursor to the button row at the lower edge, or below the content if that is longer.
void dialogFoot(const Ui& ui);
/// Draws a button in the button row, or on a new line if it does not fit. @param width  px at scale 1
bool footButton(Ui& ui, const char* label, float width, const std::string& path, ImU32 color = 0);
/// Draws the highlighted default button, which Enter also
/// presses. Never use it for an action that discards data.
bool defaultButton(Ui& ui, const char* label, float width, const std::string& path);
/// True if Enter was pressed and means the default button of the dialog, not its focused widget.
bool entersDialog();

/// Draws the names of a table's columns as a row of plain text, at which Tab does not stop.
void tableTitles();

/// A dialog that opens as soon as no other dialog is open, and reopens after another dialog has displaced it.
class LastingQuestion {
public:
    explicit LastingQuestion(const char* title) : title_{title} {}

    /// Call it in every frame before drawing the dialog. @param wanted  the question still needs an answer
    /// @return true if the dialog was closed without an answer
    bool ask(bool wanted);

private:
    const char* title_;
    bool open_ = false;
};

}  // namespace plumb::editor::ui
