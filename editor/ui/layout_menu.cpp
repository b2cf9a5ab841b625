#include "editor/ui/layout_menu.hpp"

#include "core/text.hpp"
#include "editor/ui/widgets/dialog.hpp"

namespace plumb::editor::ui {
namespace {

void useLayout(Workspace& workspace, const NamedLayout& named) {
    workspace.settings.layout = named.layout;
    workspace.notice = format("Layout {}", named.name);
}

}  // namespace

void LayoutMenu::drawItems(Ui& ui) {
    ImGui::Separator();
    const bool panels = ImGui::BeginMenu("Panels");
    ui.widgets.mark("Menu/View/Panels");
    if (panels) {
        panelItems(ui);
        ImGui::EndMenu();
    }
    const bool layouts = ImGui::BeginMenu("Layout");
    ui.widgets.mark("Menu/View/Layout");
    if (layouts) {
        layoutItems(ui);
        ImGui::EndMenu();
    }
}

void LayoutMenu::panelItems(Ui& ui) {
    PaneLayout& layout = ui.workspace.settings.layout;
    for (const PanelRow& row : panelTable()) {
        if (row.dock == Dock::Center) continue;  // the scene view cannot be closed
        const bool open = layout.isOpen(row.title);
        if (ImGui::MenuItem(row.title, nullptr, open)) {
            layout.hidden = false;
            open ? layout.close(row.title) : layout.show(row.title);
        }
        ui.widgets.mark(format("Menu/View/Panels/{}", row.title), open ? "on" : "off");
    }
}

void LayoutMenu::layoutItems(Ui& ui) {
    for (const char* id : {"layout.paint", "layout.logic", "layout.play"}) {
        actionItem(ui, id, "Menu/View/Layout");
    }
    Settings& settings = ui.workspace.settings;
    if (!settings.layouts.empty()) ImGui::Separator();
    for (const NamedLayout& named : settings.layouts) {
        ImGui::PushID(&named);
        if (ImGui::MenuItem(named.name.c_str())) useLayout(ui.workspace, named);
        ui.widgets.mark("Menu/View/Layout/" + named.name);
        ImGui::PopID();
    }
    ImGui::Separator();
    actionItem(ui, "layout.save", "Menu/View/Layout");
    if (settings.layouts.empty()) return;
    const bool open = ImGui::BeginMenu("Delete layout");
    ui.widgets.mark("Menu/View/Layout/Delete layout");
    if (!open) return;
    std::string deleted;
    for (const NamedLayout& named : settings.layouts) {
        ImGui::PushID(&named);
        if (ImGui::MenuItem(named.name.c_str())) deleted = named.name;
        ui.widgets.mark("Menu/View/Layout/Delete layout/" + named.name);
        ImGui::PopID();
    }
    std::erase_if(settings.layouts, [&](const NamedLayout& named) { return named.name == deleted; });
    ImGui::EndMenu();
}

void LayoutMenu::askName() {
    ask_ = true;
    name_.fill('\0');
}

void LayoutMenu::drawQuestion(Ui& ui) {
    if (std::exchange(ask_, false)) ImGui::OpenPopup("Save layout as");
    if (!beginDialog(ui, "Save layout as", {360.0f, 140.0f})) return;
    ImGui::TextDisabled("An existing layout of this name is replaced.");
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0f);
    bool done = ImGui::InputTextWithHint("##name", "My layout", name_.data(), name_.size(),
                                         ImGuiInputTextFlags_EnterReturnsTrue);
    ui.widgets.mark("Layout/name", name_.data());
    dialogFoot(ui);
    done |= defaultButton(ui, "Save", 100.0f, "Layout/Save");
    ImGui::SameLine();
    if (footButton(ui, "Cancel", 100.0f, "Layout/Cancel")) ImGui::CloseCurrentPopup();
    const std::string name{trimmed(name_.data())};
    if (done && !name.empty()) {
        ui.workspace.settings.keepLayout(name);
        ui.workspace.notice = format("Saved the layout {}; select it in View > Layout", name);
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace plumb::editor::ui
