#include "editor/ui/dialogs/prefab_dialogs.hpp"

#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/input/key_words.hpp"
#include "editor/model/prefabs/make_prefab.hpp"
#include "editor/model/prefabs/prefab_names.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/dialog.hpp"

namespace plumb::editor::ui {
namespace {

constexpr const char* kName = "Make prefab";
constexpr const char* kOverrides = "Prefab overrides";

void cell(const std::string& text, ImU32 color) {
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
    tooltip(text);
}

}  // namespace

void PrefabDialogs::draw(Ui& ui) {
    open(ui);
    drawName(ui);
    drawOverrides(ui);
}

void PrefabDialogs::open(Ui& ui) {
    Workspace& workspace = ui.workspace;
    const Document& document = workspace.document;
    if (document.selection.empty()) return;
    if (workspace.request == WindowRequest::NamePrefab) {
        workspace.request = WindowRequest::None;
        const std::string name = freePrefabName(workspace, document.nameOf(document.selection.all().back()));
        name_.fill('\0');
        name.copy(name_.data(), name_.size() - 1);
        problem_.clear();
        ImGui::OpenPopup(kName);
    } else if (workspace.request == WindowRequest::ShowOverrides) {
        workspace.request = WindowRequest::None;
        instance_ = document.selection.all().back();
        rowsOf_ = ~0ull;
        ImGui::OpenPopup(kOverrides);
    }
}

void PrefabDialogs::drawName(Ui& ui) {
    if (!beginDialog(ui, kName, {420.0f, 190.0f})) return;
    ImGui::TextDisabled("Name of the new prefab, in the folder prefabs/");
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0f);
    bool done = ImGui::InputText("##name", name_.data(), name_.size(),
                                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    ui.widgets.mark("MakePrefab/name", name_.data());
    const Document& document = ui.workspace.document;
    const std::string kind = prefabNote(document, document.selection.all());
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
    if (problem_.empty()) ImGui::TextWrapped("%s", kind.c_str());
    ImGui::PopStyleColor();
    ui.widgets.mark("MakePrefab/kind", kind);
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
    ImGui::TextWrapped("%s", problem_.c_str());
    ImGui::PopStyleColor();
    dialogFoot(ui);
    done |= defaultButton(ui, "Make", 110.0f, "MakePrefab/Make");
    ImGui::SameLine();
    if (footButton(ui, "Cancel", 110.0f, "MakePrefab/Cancel")) ImGui::CloseCurrentPopup();
    if (done) {
        Workspace& workspace = ui.workspace;
        const Result<ObjectId> made =
            makePrefab(workspace, workspace.document.selection.all(), prefabPath(name_.data()));
        problem_ = made ? std::string{} : format("{}; {}", made.error().what, made.error().remedy);
        if (made) {
            workspace.notice = format("Created {}; press {} to undo", prefabPath(name_.data()),
                                      keysFor(workspace, "edit.undo"));
            ImGui::CloseCurrentPopup();
        }
    }
    ImGui::EndPopup();
}

void PrefabDialogs::drawOverrides(Ui& ui) {
    if (!beginDialog(ui, kOverrides, {760.0f, 420.0f})) return;
    Workspace& workspace = ui.workspace;
    if (std::exchange(rowsOf_, workspace.document.sceneRevision) != workspace.document.sceneRevision)
        rows_ = overrideList(workspace.prefabs(), instance_);
    const auto part = InstancePart::of(workspace.document, workspace.prefabs().prefabs, instance_);
    ImGui::TextDisabled(
        "%s", part ? part->prefab().path.c_str() : "This entity is no longer part of a prefab instance.");
    constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY |
                                       ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp;
    if (rows_.empty()) {
        ImGui::TextUnformatted("The instance does not differ from its prefab.");
    } else if (ImGui::BeginTable("rows", 5, kFlags, {0.0f, -ui.px(44.0f)})) {
        joinFocusOrder();
        ImGui::TableSetupScrollFreeze(0, 1);
        ImGui::TableSetupColumn("Entity", 0, 0.8f);
        ImGui::TableSetupColumn("Field", 0, 1.3f);
        ImGui::TableSetupColumn("In the prefab", 0, 1.0f);
        ImGui::TableSetupColumn("In the instance", 0, 1.0f);
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, ui.px(118.0f));
        tableTitles();
        for (std::size_t i = 0; i < rows_.size(); ++i) drawRow(ui, rows_[i], i);
        ImGui::EndTable();
    }
    dialogFoot(ui);
    ImGui::BeginDisabled(rows_.empty());
    if (footButton(ui, "Revert all", 110.0f, "Overrides/revert all")) runAction(workspace, "entity.revert");
    ImGui::SameLine();
    if (footButton(ui, "Apply all", 110.0f, "Overrides/apply all")) runAction(workspace, "entity.apply");
    ImGui::EndDisabled();
    ImGui::SameLine(ImGui::GetWindowWidth() - ui.px(118.0f));
    if (defaultButton(ui, "Close", 110.0f, "Overrides/Close")) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

void PrefabDialogs::drawRow(Ui& ui, const OverrideRow& row, std::size_t index) {
    Workspace& workspace = ui.workspace;
    ImGui::PushID(static_cast<int>(index));
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(row.entity.c_str());
    const std::string field = row.type == nullptr ? std::string{"whole entity"}
                              : row.field.empty() ? std::string{row.type->name}
                                                  : format("{}.{}", row.type->name, row.field);
    cell(field, palette::kText);
    ui.widgets.mark(format("Overrides/{}", index), format("{} {}", row.entity, field));
    cell(row.prefab, palette::kTextDim);
    cell(row.here, palette::kText);
    ImGui::TableNextColumn();
    const bool revert = ImGui::SmallButton("Revert");
    ui.widgets.mark(format("Overrides/{}/revert", index));
    tooltip("Resets this override to the prefab's value");
    ImGui::SameLine();
    const bool apply = row.type != nullptr && ImGui::SmallButton("Apply");
    if (row.type != nullptr) {
        ui.widgets.mark(format("Overrides/{}/apply", index));
        tooltip("Writes this override to the prefab's file, which changes all instances");
    }
    ImGui::PopID();
    if (revert) {
        static_cast<void>(revertOverride(workspace.prefabs(), row));
    } else if (apply) {
        const Result<Done> applied = applyToPrefab(workspace.prefabs(), row.object, row.scope());
        if (!applied) workspace.notice = applied.error().text();
    }
}

}  // namespace plumb::editor::ui
