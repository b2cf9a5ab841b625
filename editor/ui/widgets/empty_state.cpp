#include "editor/ui/widgets/empty_state.hpp"

#include "core/text.hpp"
#include "editor/model/actions.hpp"

namespace plumb::editor::ui {

void emptyState(Ui& ui, const std::string& panel, const char* what, const char* how,
                std::initializer_list<std::string_view> actions) {
    ImGui::TextWrapped("%s", what);
    ui.widgets.mark(panel + "/empty", what);
    if (*how != '\0') {
        ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
        ImGui::TextWrapped("%s", how);
        ImGui::PopStyleColor();
    }
    ImGui::Dummy({0.0f, ui.px(2.0f)});
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    bool first = true;
    for (const std::string_view id : actions) {
        const Action& action = *findAction(id);
        const std::string label = ui.workspace.settings.keys.labelOf(action);
        const float width = ImGui::CalcTextSize(label.c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x;
        const float gap = ImGui::GetStyle().ItemSpacing.x;
        if (!first && ImGui::GetItemRectMax().x + gap + width <= right) ImGui::SameLine();
        first = false;
        ImGui::BeginDisabled(!action.enabled(ui.workspace));
        const bool pressed = ImGui::Button(label.c_str());
        ImGui::EndDisabled();
        ui.widgets.mark(format("{}/empty/{}", panel, action.label));
        if (pressed) runAction(ui.workspace, id);
    }
}

}  // namespace plumb::editor::ui
