#include "editor/ui/dialogs/scene_name_dialog.hpp"

#include <utility>

#include <imgui.h>

#include "core/text.hpp"
#include "editor/model/problems.hpp"
#include "editor/ui/widgets/dialog.hpp"
#include "editor/ui/widgets/text_field.hpp"

namespace plumb::editor::ui {
namespace {

constexpr const char* kNew = "New scene";
constexpr const char* kCopy = "Save scene as";

}  // namespace

std::optional<SceneNameDialog::Answer> SceneNameDialog::draw(Ui& ui) {
    WindowRequest& request = ui.workspace.request;
    if (request == WindowRequest::NameNewScene || request == WindowRequest::NameSceneCopy) {
        ImGui::OpenPopup(request == WindowRequest::NameNewScene ? kNew : kCopy);
        request = WindowRequest::None;
        name_.clear();
        problem_.clear();
    }
    std::optional<Answer> answer = drawQuestion(ui, false);
    return answer ? answer : drawQuestion(ui, true);
}

std::optional<SceneNameDialog::Answer> SceneNameDialog::drawQuestion(Ui& ui, bool copy) {
    const std::string path = copy ? "SaveAs" : "New";
    if (!beginDialog(ui, copy ? kCopy : kNew, {400.0f, 150.0f})) return {};
    ImGui::TextDisabled("Name of the new scene, in the folder scenes/");
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0f);
    bool done = textField("##name", name_, ImGuiInputTextFlags_EnterReturnsTrue, "for example cave");
    ui.widgets.mark(path + "/name", name_);
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
    ImGui::TextWrapped("%s", problem_.c_str());
    ImGui::PopStyleColor();
    ui.widgets.mark(path + "/problem", problem_);
    dialogFoot(ui);
    const char* label = copy ? "Save" : "Create";
    done |= defaultButton(ui, label, 110.0f, format("{}/{}", path, label));
    ImGui::SameLine();
    if (footButton(ui, "Cancel", 110.0f, path + "/Cancel")) ImGui::CloseCurrentPopup();
    std::optional<Answer> answer;
    if (done) {
        // The name is checked now, while the user can correct it, and before asking about unsaved changes.
        const Result<Path> free = newSceneFile(ui.workspace.project.root, name_);
        problem_ = free ? std::string{} : format("{}; {}", free.error().what, free.error().remedy);
        if (free) {
            ImGui::CloseCurrentPopup();
            answer = Answer{name_, copy};
        }
    }
    ImGui::EndPopup();
    return answer;
}

}  // namespace plumb::editor::ui
