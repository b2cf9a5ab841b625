#pragma once

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// A question in the middle of the window, never larger than that: what has no room is scrolled to. Ends with
/// ImGui::EndPopup where it is open.
/// @param wanted  its size, px at scale 1
/// @param stays   with a cross in its corner: false once that was clicked
bool beginDialog(const Ui& ui, const char* title, ImVec2 wanted, bool* stays = nullptr);

/// Goes to the line of buttons at the lower edge, or below all there is where that needs the room.
void dialogFoot(const Ui& ui);
/// A button in that line, or in the next one where there is no room. @param width  px at scale 1
bool footButton(Ui& ui, const char* label, float width, const std::string& path, ImU32 color = 0);
/// The one that Enter means too, in a color of its own. Never one that throws something away.
bool defaultButton(Ui& ui, const char* label, float width, const std::string& path);

/// A question that comes as soon as no other dialog is open, and comes back when another one takes its place.
class LastingQuestion {
public:
    explicit LastingQuestion(const char* title) : title_{title} {}

    /// To be called in every frame, before the dialog is drawn. @return whether it was closed unanswered
    bool ask(bool wanted);

private:
    const char* title_;
    bool open_ = false;
};

}  // namespace plumb::editor::ui
