#include "editor/ui/dialogs/preferences_dialog.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "core/text.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/dialog.hpp"
#include "editor/ui/widgets/text_field.hpp"

namespace plumb::editor::ui {
namespace {

// Sizes in px at scale 1.
constexpr float kWidth = 700.0f;
constexpr float kHeight = 500.0f;
constexpr float kSide = 130.0f;     // width of the list of pages
constexpr float kLabels = 150.0f;   // width of the labels
constexpr float kSliders = 220.0f;  // width of the sliders

/// Draws the label of the next widget in a separate column.
void label(const Ui& ui, const char* text) {
    const float start = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text);
    ImGui::SameLine(start + ui.px(kLabels));
}

void choice(Ui& ui, const char* label, const std::string& path, bool chosen,
            const std::function<void()>& choose) {
    if (ImGui::RadioButton(label, chosen)) choose();
    ui.widgets.mark(path, chosen ? "on" : "off");
}

/// A slider whose value is applied only on release, because applying it resizes the slider under the mouse.
bool slider(Ui& ui, const char* id, const std::string& path, float& held, float now, float from, float to,
            const char* shown) {
    if (held == 0.0f) held = now;
    ImGui::SetNextItemWidth(ui.px(kSliders));
    ImGui::SliderFloat(id, &held, from, to, shown, ImGuiSliderFlags_AlwaysClamp);
    const bool done = ImGui::IsItemDeactivated() && held != now;
    ui.widgets.mark(path, fixedText(static_cast<double>(held), 0));
    if (!ImGui::IsItemActive() && !done) held = 0.0f;
    return done;
}

}  // namespace

void PreferencesDialog::draw(Ui& ui) {
    if (std::exchange(open_, false)) {
        ImGui::OpenPopup("Preferences");
        if (ui.workspace.panelToShow == "/Preferences/Keys")
            page_ = Page::Keys, ui.workspace.panelToShow.clear();
    }
    bool stays = true;
    if (!beginDialog(ui, "Preferences", {kWidth, kHeight}, &stays)) {
        keysPage_.stop();
        return;
    }
    drawPages(ui);
    ImGui::SameLine();
    beginChild("page", {0.0f, -ui.px(36.0f)}, false);
    switch (page_) {
        case Page::Look: drawLook(ui); break;
        case Page::Keys: keysPage_.draw(ui); break;
        case Page::Editing: drawEditing(ui); break;
    }
    ImGui::EndChild();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", (configFolder() / "settings.json").string().c_str());
    tooltip("The file that stores the preferences");
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ui.px(100.0f));
    // A key that the page "Keys" has just taken, perhaps Enter, is a new shortcut and nothing else.
    const bool closes = std::exchange(tookKey_, false)
                            ? footButton(ui, "Close", 100.0f, "Preferences/Close", palette::kAccentSoft)
                            : defaultButton(ui, "Close", 100.0f, "Preferences/Close");
    if (closes) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

void PreferencesDialog::drawPages(Ui& ui) {
    struct Row {
        Page page;
        const char* name;
    };
    constexpr std::array kPages{Row{Page::Look, "Look"}, Row{Page::Keys, "Keys"},
                                Row{Page::Editing, "Editing"}};
    beginChild("pages", {ui.px(kSide), -ui.px(36.0f)}, false);
    for (const Row& row : kPages) {
        ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, {0.0f, 0.5f});
        const bool chosen =
            ImGui::Selectable(row.name, page_ == row.page, 0, {0.0f, ImGui::GetFrameHeight()});
        ImGui::PopStyleVar();
        if (chosen) {
            page_ = row.page;
            keysPage_.stop();
        }
        ui.widgets.mark(format("Preferences/{}", row.name), page_ == row.page ? "on" : "");
    }
    ImGui::EndChild();
}

void PreferencesDialog::drawLook(Ui& ui) {
    Settings& settings = ui.workspace.settings;
    label(ui, "Theme");
    choice(ui, "Dark", "Preferences/theme/dark", settings.theme == Theme::Dark,
           [&] { settings.theme = Theme::Dark; });
    ImGui::SameLine(0.0f, ui.px(20.0f));
    choice(ui, "Light", "Preferences/theme/light", settings.theme == Theme::Light,
           [&] { settings.theme = Theme::Light; });
    ImGui::Spacing();
    label(ui, "Interface");
    if (slider(ui, "##scale", "Preferences/scale", scale_, settings.scale * 100.0f,
               Settings::kLeastScale * 100.0f, Settings::kMostScale * 100.0f, "%.0f %%")) {
        settings.scale = std::round(scale_ / 5.0f) * 0.05f;
        scale_ = 0.0f;
    }
    tooltip("Scale of the user interface. Applied when you release the slider.");
    for (const int percent : {100, 150, 200}) {
        ImGui::SameLine();
        const std::string name = format("{} %", percent);
        if (ImGui::Button(name.c_str())) settings.scale = static_cast<float>(percent) / 100.0f;
        ui.widgets.mark(format("Preferences/scale/{}", percent));
    }
    ImGui::Spacing();
    label(ui, "Text");
    if (slider(ui, "##text", "Preferences/text", textSize_, settings.textSize, 11.0f, 20.0f, "%.0f px")) {
        settings.textSize = std::round(textSize_);
        textSize_ = 0.0f;
    }
    tooltip("Text size at 100 %. Applied when you release the slider.");
}

void PreferencesDialog::drawEditing(Ui& ui) {
    Workspace& workspace = ui.workspace;
    bool& erases = workspace.tiles.rightErases;
    label(ui, "Right button");
    choice(ui, "picks tiles from the layer", "Preferences/right/takes", !erases, [&] { erases = false; });
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.px(kLabels));
    choice(ui, "erases tiles", "Preferences/right/erases", erases, [&] { erases = true; });
    ImGui::Spacing();
    label(ui, "At the start");
    ImGui::Checkbox("show the welcome screen", &workspace.settings.welcome);
    ui.widgets.mark("Preferences/welcome", workspace.settings.welcome ? "on" : "off");
    tooltip(
        "If off, the editor opens the last project. A project given on the command line is always opened.");
    ImGui::Spacing();
    label(ui, "Text editor");
    ImGui::SetNextItemWidth(-1.0f);
    textField("##text editor", workspace.settings.textEditor, 0, "code -g {file}:{line}");
    ui.widgets.mark("Preferences/textEditor", workspace.settings.textEditor);
    tooltip(
        "Command that opens an error of the Console: {file} and {line} are replaced. If empty, the system "
        "opens the file.");
    ImGui::Spacing();
    label(ui, "Recent projects");
    ImGui::BeginDisabled(workspace.settings.recent.empty());
    if (ImGui::Button("Clear list")) workspace.settings.recent.clear();
    ImGui::EndDisabled();
    ui.widgets.mark("Preferences/forget", format("{}", workspace.settings.recent.size()));
}

}  // namespace plumb::editor::ui
