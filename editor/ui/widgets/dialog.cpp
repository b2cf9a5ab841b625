#include "editor/ui/widgets/dialog.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/ui/ui_compat.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kMargin = 8.0f;  // px at scale 1, minimum distance between dialog and window edge
constexpr float kFoot = 12.0f;   // px at scale 1, distance below the buttons

}  // namespace

bool beginDialog(const Ui& ui, const char* title, ImVec2 wanted, bool* stays) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float edges = 2.0f * ui.px(kMargin);
    const ImVec2 size{std::min(ui.px(wanted.x), std::max(display.x - edges, 1.0f)),
                      std::min(ui.px(wanted.y), std::max(display.y - edges, 1.0f))};
    ImGui::SetNextWindowPos(
        {std::floor((display.x - size.x) * 0.5f), std::floor((display.y - size.y) * 0.4f)});
    ImGui::SetNextWindowSize(size);
    return ImGui::BeginPopupModal(title, stays, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
}

void dialogFoot(const Ui& ui) {
    const float foot = ImGui::GetWindowHeight() - ImGui::GetFrameHeight() - ui.px(kFoot);
    ImGui::SetCursorPosY(std::max(foot, ImGui::GetCursorPosY()));
}

bool footButton(Ui& ui, const char* label, float width, const std::string& path, ImU32 color) {
    const float least = ImGui::CalcTextSize(label, nullptr, true).x + 2.0f * ImGui::GetStyle().FramePadding.x;
    // The cursor is beside the previous button.
    if (ImGui::GetContentRegionAvail().x < least) ImGui::NewLine();
    const float wide = std::max(std::min(ui.px(width), ImGui::GetContentRegionAvail().x), least);
    if (color != 0) ImGui::PushStyleColor(ImGuiCol_Button, color);
    const bool pressed = ImGui::Button(label, {wide, 0.0f});
    if (color != 0) ImGui::PopStyleColor();
    ui.widgets.mark(path);
    return pressed;
}

bool defaultButton(Ui& ui, const char* label, float width, const std::string& path) {
    const bool clicked = footButton(ui, label, width, path, palette::kAccentSoft);
    return clicked || entersDialog();
}

bool entersDialog() {
    const bool entered = pressed(Key::Enter) || pressed(Key::PadEnter);
    if (!entered || ImGui::IsWindowAppearing()) return false;
    // Enter in a text field finishes that field only; a widget to which Tab has led takes Enter itself.
    const bool taken = itemWasActive() || ImGui::GetIO().NavVisible;
    constexpr ImGuiFocusedFlags kOwn = ImGuiFocusedFlags_ChildWindows | ImGuiFocusedFlags_NoPopupHierarchy;
    return !taken && ImGui::IsWindowFocused(kOwn);
}

void tableTitles() {
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (int i = 0; i < ImGui::TableGetColumnCount(); ++i) {
        ImGui::TableSetColumnIndex(i);
        ImGui::TextUnformatted(ImGui::TableGetColumnName(i));
    }
}

bool LastingQuestion::ask(bool wanted) {
    bool left = false;
    if (open_ && !ImGui::IsPopupOpen(title_)) {
        open_ = false;
        left = wanted && !anyPopupOpen();  // if another dialog displaced it, it reopens later
    }
    if (wanted && !left && !open_ && !anyPopupOpen()) {
        ImGui::OpenPopup(title_);
        open_ = true;
    }
    return left;
}

}  // namespace plumb::editor::ui
