#include <algorithm>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/input/key_words.hpp"
#include "editor/model/prefabs/prefab_group.hpp"
#include "editor/model/shared_components.hpp"
#include "editor/ui/fields/add_component.hpp"
#include "editor/ui/icons.hpp"
#include "editor/ui/panels/component_view.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/widgets/empty_state.hpp"
#include "editor/ui/widgets/text_field.hpp"
#include "scene/components/name.hpp"

namespace plumb::editor::ui {
namespace {

/// Edits the components of the selected entities; the widgets are generated from reflection data.
class InspectorPanel final : public Panel {
public:
    void draw(Ui& ui) override {
        drawSelected(ui);
        components_.endFrame(ui);
    }

private:
    void drawSelected(Ui& ui) {
        const std::vector<ObjectId>& selected = ui.workspace.document.selection.all();
        if (ui.workspace.document.scenePath.empty()) {
            return emptyState(ui, "Inspector", "No scene is open.",
                              "The components of the selected entities appear here.",
                              {"file.open", "file.new"});
        }
        if (selected.empty()) {
            return emptyState(
                ui, "Inspector", "Nothing is selected.",
                "Click an entity in the viewport or in the Scene panel to edit its components here.",
                {"entity.create", "edit.selectAll"});
        }
        const ObjectId shown = selected.back();
        if (!ui.workspace.shownWorld().alive(ui.workspace.shownEntity(shown))) {
            ImGui::TextWrapped("This entity does not exist in the running game.");
            return;
        }
        compareWithPrefabs(ui, selected);
        lookAtComponents(ui.workspace);
        selected.size() > 1 ? drawCount(ui, selected.size()) : drawName(ui, shown);
        const bool canEdit = ui.workspace.canEdit();
        if (group_.parts > 0 && canEdit) drawPrefab(ui, selected.size());
        ImGui::Spacing();
        const PrefabOverrides& overrides = group_.overrides;
        for (const ComponentHolders& held : held_) {
            if (held.count == selected.size())
                components_.draw(ui, *held.type, {selected, entities_, overrides});
        }
        drawPartlyHeld(ui, selected);
        for (const PrefabOverrides::Component& component : overrides.components) {
            if (component.removed && canEdit) drawRemoved(ui, selected, *component.type);
        }
        ImGui::Spacing();
        if (ui.workspace.canEdit()) add_.draw(ui, selected, held_);
    }

    /// Compares the selected entities with their prefabs after each change of scene or selection. During a
    /// drag of several entities the last result is kept. Uses the edited scene, never the running game.
    void compareWithPrefabs(Ui& ui, const std::vector<ObjectId>& ids) {
        Workspace& workspace = ui.workspace;
        const Compared now{workspace.document.sceneRevision, workspace.document.selection.revision(),
                           workspace.document.scenePath};
        const bool drags = ids.size() > 1 && workspace.undo.inGesture() && now.path == compared_.path &&
                           now.selection == compared_.selection;
        if (drags || std::exchange(compared_, now) == now) return;
        group_ = prefabGroup(workspace.prefabs(), ids);
    }

    /// Updates the list of components of the selected entities if scene, selection or tick changed.
    void lookAtComponents(const Workspace& workspace) {
        const SelectedState now = selectedState(workspace);
        if (std::exchange(looked_, now) == now) return;
        entities_.clear();
        for (const ObjectId id : workspace.document.selection.all())
            entities_.push_back(workspace.shownEntity(id));
        held_ = componentHolders(workspace.document.types(), workspace.shownWorld(), entities_);
    }

    static void drawTitleIcon(const Ui& ui, Icon icon) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float middle = at.y + ImGui::GetFrameHeight() * 0.5f;
        drawIcon(*ImGui::GetWindowDrawList(), icon, {at.x + ui.px(10.0f), middle}, ui.px(16.0f),
                 iconColor(icon));
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.px(26.0f));
        ImGui::AlignTextToFramePadding();
    }

    static void drawCount(Ui& ui, std::size_t count) {
        drawTitleIcon(ui, Icon::Layers);
        ImGui::Text("%d entities", static_cast<int>(count));
        ui.widgets.mark("Inspector/count", format("{}", count));
        tooltip(
            "A change applies to all of them, one number at a time. A dash marks differing values; "
            "type +=10 or *2, or drag, to change each relative to its own value.");
    }

    void drawName(Ui& ui, ObjectId id) {
        const Document& document = ui.workspace.document;
        drawTitleIcon(ui, iconOf(document.world, document.find(id)));
        const std::string name =
            document.world.has<Name>(document.find(id)) ? document.nameOf(id) : std::string{};
        std::string typed = name;
        ImGui::SetNextItemWidth(-1.0f);
        textField("##name", typed, ui.workspace.canEdit() ? 0 : ImGuiInputTextFlags_ReadOnly, "Name");
        ui.widgets.mark("Inspector/name", name);
        if (ImGui::IsItemDeactivatedAfterEdit() && name != typed) {
            ui.workspace.undo.push(renameEntity(ui.workspace.document, id, typed));
            ui.workspace.undo.endGesture();
        }
    }

    /// Returns the line that names the prefabs of the selected entities: "3 of 5 from owlet".
    [[nodiscard]] std::string origin(std::size_t selected) const {
        const std::string& first = group_.prefabs.front();
        const std::string name =
            group_.prefabs.size() == 1 ? shortPath(first) : format("{} prefabs", group_.prefabs.size());
        if (selected == 1) return format("from {}", name);
        if (group_.parts == selected) return format("all from {}", name);
        return format("{} of {} from {}", group_.parts, selected, name);
    }

    /// Returns "owlet" for "prefabs/owlet.prefab.json".
    static std::string shortPath(std::string_view path) {
        const std::string_view name = path.substr(path.rfind('/') + 1);
        return std::string{name.substr(0, name.find(".prefab."))};
    }

    /// Draws the names of the prefabs, the number of overridden
    /// values, and the buttons to revert or apply them.
    void drawPrefab(Ui& ui, std::size_t selected) {
        const std::size_t count = group_.changed;
        const std::string state = !group_.compared ? "too many to compare"
                                  : count == 0     ? "unchanged"
                                                   : format("{} changed", count);
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s", origin(selected).c_str());
        std::string paths;
        for (const std::string& path : group_.prefabs) paths += path + "\n";
        tooltip(paths + "Overridden values are bold, with a bar beside them.");
        ImGui::SameLine();
        ImGui::PushStyleColor(ImGuiCol_Text, count == 0 ? palette::kTextDim : palette::kAccent);
        ImGui::TextUnformatted(state.c_str());
        ImGui::PopStyleColor();
        ui.widgets.mark("Inspector/prefab", format("{}", count));
        drawEditPrefab(ui);
        if (count > 0) drawRevertAndApply(ui);
    }

    void drawEditPrefab(Ui& ui) {
        const char* label = "Edit prefab";
        const float width = ImGui::CalcTextSize(label).x + ImGui::GetStyle().FramePadding.x * 2.0f;
        const float right = ImGui::GetContentRegionMax().x - width;
        const float end = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + ui.px(8.0f);
        if (right > end) ImGui::SameLine(right);
        const Action& action = *findAction("entity.editPrefab");
        const bool several = group_.prefabs.size() > 1;
        ImGui::BeginDisabled(!action.enabled(ui.workspace));
        if (ImGui::Button(label)) runAction(ui.workspace, "entity.editPrefab");
        ImGui::EndDisabled();
        ui.widgets.mark("Inspector/prefab/edit", several ? "several" : group_.prefabs.front());
        tooltip(several
                    ? std::string{"The selected entities come from several prefabs: select instances of one."}
                    : format("Opens {}; a change there applies to all of its instances.  ({})",
                             group_.prefabs.front(), keysFor(ui.workspace, "entity.editPrefab")));
    }

    void drawRevertAndApply(Ui& ui) {
        const float width = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) * 0.5f;
        const KeyBindings& keys = ui.workspace.settings.keys;
        if (ImGui::Button("Revert all", {width, 0.0f}))
            components_.ask([](Workspace& workspace) { workspace.revertToPrefab(); });
        ui.widgets.mark("Inspector/prefab/revert");
        tooltip(keys.labelOf(*findAction("entity.revert"),
                             "Resets the overridden values to the prefab's, except for the position."));
        ImGui::SameLine();
        const bool can = group_.whyNotApply.empty();
        ImGui::BeginDisabled(!can);
        if (ImGui::Button("Apply all", {width, 0.0f}))
            components_.ask([](Workspace& workspace) { workspace.applyToPrefab(); });
        ImGui::EndDisabled();
        ui.widgets.mark("Inspector/prefab/apply", group_.whyNotApply);
        tooltip(
            can ? keys.labelOf(*findAction("entity.apply"),
                               "Writes the overridden values into the prefab file; other instances follow.")
                : group_.whyNotApply);
    }

    /// Lists the components that only some of the selected entities have; a click selects these entities.
    void drawPartlyHeld(Ui& ui, const std::vector<ObjectId>& ids) {
        const auto partly = [&](const ComponentHolders& held) { return held.count < ids.size(); };
        const auto more = std::count_if(held_.begin(), held_.end(), partly);
        if (more == 0) return;
        ImGui::Spacing();
        ImGui::TextDisabled("%d more, on some entities only:", static_cast<int>(more));
        ui.widgets.mark("Inspector/partly", format("{}", more));
        for (const ComponentHolders& held : held_) {
            if (!partly(held)) continue;
            ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
            const bool chosen = ImGui::Selectable(std::string{held.type->name}.c_str());
            ImGui::PopStyleColor();
            const std::string count = format("{} of {}", held.count, ids.size());
            const ImVec2 end = ImGui::GetItemRectMax();
            const ImVec2 size = ImGui::CalcTextSize(count.c_str());
            ImGui::GetWindowDrawList()->AddText(
                {end.x - size.x - ui.px(6.0f), ImGui::GetItemRectMin().y + ui.px(2.0f)}, palette::kTextDim,
                count.c_str());
            ui.widgets.mark(format("Inspector/partly/{}", held.type->name), format("{}", held.count));
            tooltip("Selects the entities with this component");
            if (!chosen) continue;
            components_.ask([type = held.type](Workspace& workspace) {
                Selection& selection = workspace.document.selection;
                selection.set(holdersOf(workspace, selection.all(), *type));
            });
        }
    }

    void drawRemoved(Ui& ui, const std::vector<ObjectId>& selected, const TypeInfo& type) {
        ImGui::PushID(type.name.data());
        drawPrefabBar(ui, ImGui::GetCursorScreenPos(), ImGui::GetFrameHeight());
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s removed", std::string{type.name}.c_str());
        ImGui::SameLine();
        if (ImGui::SmallButton("Restore")) {
            components_.ask([&type, selected](Workspace& workspace) {
                std::vector<ObjectId> without = selected;
                std::erase_if(without, [&](ObjectId id) {
                    return workspace.document.world.has(type, workspace.document.find(id));
                });
                static_cast<void>(revertToPrefab(workspace.prefabs(), without, {&type}));
            });
        }
        ui.widgets.mark(format("Inspector/{}/restore", type.name));
        tooltip("The prefab has this component; Restore adds it to the entity again.");
        ImGui::PopID();
    }

    struct Compared {
        std::uint64_t revision = 0;
        std::uint64_t selection = 0;
        std::string path;
        friend bool operator==(const Compared&, const Compared&) = default;
    };

    ComponentView components_;
    AddComponent add_;
    PrefabGroup group_;  // group of the selected entities, computed at `compared_`
    Compared compared_;
    std::vector<EntityId> entities_;      // the selected entities, read at `looked_`
    std::vector<ComponentHolders> held_;  // component types of the selected entities, with counts
    SelectedState looked_;
};

}  // namespace

std::unique_ptr<Panel> makeInspectorPanel() { return std::make_unique<InspectorPanel>(); }

}  // namespace plumb::editor::ui
