#include <array>

#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/commands/set_field.hpp"
#include "editor/ui/icons.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/field_edit.hpp"
#include "editor/ui/widgets/pickers.hpp"
#include "scene/components/name.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/scene_entity.hpp"

namespace plumb::editor::ui {
namespace {

/// Components that the tree or the scene file shows in another way.
bool hasOwnPlace(const TypeInfo& type) {
    return type.key == typeKey<SceneEntity>() || type.key == typeKey<PrefabInstance>() ||
           type.key == typeKey<PrefabPart>() || type.key == typeKey<Name>() ||
           type.key == typeKey<Parent>() || type.key == typeKey<Children>();
}

/// The components of what is selected, made from their descriptions.
class InspectorPanel final : public Panel {
public:
    void draw(Ui& ui) override {
        const std::vector<ObjectId>& selected = ui.workspace.document.selection.all();
        if (selected.empty()) {
            ImGui::TextWrapped("Select an entity to see its components.");
            ImGui::Spacing();
            ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
            ImGui::TextWrapped("Click it in the scene or in the tree on the left. Ctrl+N creates a new one.");
            ImGui::PopStyleColor();
            return;
        }
        const World& world = ui.workspace.shownWorld();
        const ObjectId shown = selected.back();
        if (!world.alive(ui.workspace.shownEntity(shown))) {
            ImGui::TextWrapped("This entity is gone in the running game.");
            return;
        }
        drawName(ui, shown, selected.size());
        for (const TypeInfo& type : ui.workspace.document.types().all()) {
            if (!hasOwnPlace(type) && haveAll(ui, type, selected)) drawComponent(ui, type, selected);
        }
        ImGui::Spacing();
        if (ui.workspace.canEdit()) drawAdd(ui, selected);
    }

private:
    [[nodiscard]] static bool haveAll(const Ui& ui, const TypeInfo& type, const std::vector<ObjectId>& ids) {
        const World& world = ui.workspace.shownWorld();
        for (const ObjectId id : ids) {
            if (!world.has(type, ui.workspace.shownEntity(id))) return false;
        }
        return true;
    }

    void drawName(Ui& ui, ObjectId id, std::size_t count) {
        const Document& document = ui.workspace.document;
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const Icon icon = iconOf(document.world, document.find(id));
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float middle = at.y + ImGui::GetFrameHeight() * 0.5f;
        drawIcon(list, icon, {at.x + ui.px(10.0f), middle}, ui.px(16.0f), iconColor(icon));
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.px(26.0f));
        if (count > 1) {
            ImGui::AlignTextToFramePadding();
            ImGui::Text("%d entities", static_cast<int>(count));
            tooltip("Changes go to all of them; the last one selected is shown.");
            return;
        }
        const std::string name =
            document.world.has<Name>(document.find(id)) ? document.nameOf(id) : std::string{};
        std::array<char, 256> buffer{};
        name.copy(buffer.data(), buffer.size() - 1);
        ImGui::SetNextItemWidth(-1.0f);
        ImGui::InputTextWithHint("##name", "Name", buffer.data(), buffer.size(),
                                 ui.workspace.canEdit() ? 0 : ImGuiInputTextFlags_ReadOnly);
        ui.widgets.mark("Inspector/name", name);
        if (ImGui::IsItemDeactivatedAfterEdit() && name != buffer.data()) {
            ui.workspace.undo.push(renameEntity(ui.workspace.document, id, buffer.data()));
            ui.workspace.undo.endGesture();
        }
        const PrefabInstance* prefab = document.world.find<PrefabInstance>(document.find(id));
        if (prefab != nullptr) {
            ImGui::TextDisabled("from %s",
                                std::string{document.world.texts().find(prefab->prefab.path)}.c_str());
        }
        ImGui::Spacing();
    }

    void drawComponent(Ui& ui, const TypeInfo& type, const std::vector<ObjectId>& ids) {
        const std::string name{type.name};
        ImGui::PushID(name.c_str());
        ImGui::PushStyleColor(ImGuiCol_Header, palette::kHeader);
        ImGui::PushStyleColor(ImGuiCol_HeaderHovered, IM_COL32(54, 58, 67, 255));
        ImGui::PushStyleColor(ImGuiCol_HeaderActive, IM_COL32(54, 58, 67, 255));
        pushFont(ui.fonts.strong, ui.fonts.size);
        bool keep = true;
        const bool open = ImGui::CollapsingHeader(name.c_str(), ui.workspace.canEdit() ? &keep : nullptr,
                                                  ImGuiTreeNodeFlags_DefaultOpen);
        ImGui::PopFont();
        ImGui::PopStyleColor(3);
        ui.widgets.mark("Inspector/" + name);
        tooltip(type.doc);
        if (open && type.size > 0) {
            const ComponentState fresh = defaultComponent(type);
            for (const FieldInfo& field : type.fields) {
                if (!field.transient || ui.workspace.play.running()) drawField(ui, type, field, fresh, ids);
            }
            ImGui::Dummy({0.0f, ui.px(2.0f)});
        }
        if (!keep) {
            ui.workspace.undo.push(removeComponent(ui.workspace.document, ids, type));
            ui.workspace.undo.endGesture();
        }
        ImGui::PopID();
    }

    void drawField(Ui& ui, const TypeInfo& type, const FieldInfo& field, const ComponentState& fresh,
                   const std::vector<ObjectId>& ids) {
        const ObjectNames& names = ui.workspace.shownNames();
        const void* component = std::as_const(ui.workspace.shownWorld()).find(type, names.find(ids.back()));
        if (component == nullptr) return;
        const FieldValue now = readField(names, field, component);
        const FieldValue normal = readField(names, field, fresh.bytes.data());
        const std::string path = format("Inspector/{}/{}", type.name, field.name);

        ImGui::PushID(field.name.data());
        const float start = ImGui::GetCursorPosX();
        const float width = ImGui::GetContentRegionAvail().x;
        const float labelWidth = std::min(width * 0.38f, ui.px(140.0f));
        drawLabel(ui, field, now == normal, start + labelWidth);
        if (ImGui::BeginPopupContextItem("reset")) {
            const bool reset = ImGui::MenuItem("Reset to default", nullptr, false, now != normal);
            ui.widgets.mark(path + "/reset");
            if (reset) apply(ui, type, field, ids, normal, now), ui.workspace.undo.endGesture();
            ImGui::EndPopup();
        }
        ImGui::SameLine();
        ImGui::SetCursorPosX(start + labelWidth);
        ImGui::BeginGroup();
        if (const auto value = editField(ui, path, field, component)) {
            apply(ui, type, field, ids, *value, now);
            if (!ImGui::IsAnyItemActive()) ui.workspace.undo.endGesture();
        }
        ImGui::EndGroup();
        ImGui::PopID();
    }

    static void drawLabel(Ui& ui, const FieldInfo& field, bool isDefault, float end) {
        pushFont(isDefault ? ui.fonts.text : ui.fonts.strong, ui.fonts.size);
        ImGui::AlignTextToFramePadding();
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::PushClipRect(at, {at.x + end - ImGui::GetCursorPosX() - ui.px(4.0f), at.y + ui.px(40.0f)},
                            true);
        ImGui::PushStyleColor(ImGuiCol_Text, isDefault ? IM_COL32(172, 178, 188, 255) : palette::kText);
        ImGui::TextUnformatted(field.name.data(), field.name.data() + field.name.size());
        ImGui::PopStyleColor();
        ImGui::PopClipRect();
        ImGui::PopFont();
        const char* unit = shownUnit(field.unit);
        const std::string help = *unit == '\0'       ? std::string{field.doc}
                                 : field.doc.empty() ? std::string{unit}
                                                     : format("{} ({})", field.doc, unit);
        tooltip(help.empty() ? field.name : std::string_view{help});
    }

    /// Through a command; in the running game at once, to be thrown away with it.
    static void apply(Ui& ui, const TypeInfo& type, const FieldInfo& field, const std::vector<ObjectId>& ids,
                      const FieldValue& value, const FieldValue& before) {
        Workspace& workspace = ui.workspace;
        World& world = workspace.shownWorld();
        std::vector<SetField::Change> changes;
        for (const ObjectId id : ids) {
            void* component = world.find(type, workspace.shownEntity(id));
            if (component == nullptr) continue;
            FieldValue next =
                withChangedParts(field, readField(workspace.shownNames(), field, component), before, value);
            if (workspace.play.running()) {
                writeField(workspace.shownNames(), field, component, next);
            } else {
                changes.push_back({id, std::move(next)});
            }
        }
        if (changes.empty()) return;
        workspace.undo.push(std::make_unique<SetField>(type, field, std::move(changes)));
    }

    void drawAdd(Ui& ui, const std::vector<ObjectId>& ids) {
        if (ImGui::Button("Add component", {-1.0f, 0.0f})) {
            ImGui::OpenPopup("add");
            filter_.fill('\0');
        }
        ui.widgets.mark("Inspector/add");
        ImGui::SetNextWindowSize({ui.px(240.0f), ui.px(320.0f)});
        if (!ImGui::BeginPopup("add")) return;
        if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
        ImGui::SetNextItemWidth(-1.0f);
        ImGui::InputTextWithHint("##filter", "Filter", filter_.data(), filter_.size());
        beginChild("types", {0.0f, 0.0f}, false);
        for (const TypeInfo& type : ui.workspace.document.types().all()) {
            if (hasOwnPlace(type) || haveAll(ui, type, ids)) continue;
            if (!containsWord(type.name, filter_.data())) continue;
            const bool chosen = ImGui::Selectable(std::string{type.name}.c_str());
            ui.widgets.mark(format("Inspector/add/{}", type.name));
            tooltip(type.doc);
            if (!chosen) continue;
            ui.workspace.undo.push(addComponent(ui.workspace.document, ids, type));
            ui.workspace.undo.endGesture();
            ImGui::CloseCurrentPopup();
        }
        ImGui::EndChild();
        ImGui::EndPopup();
    }

    std::array<char, 64> filter_{};
};

}  // namespace

std::unique_ptr<Panel> makeInspectorPanel() { return std::make_unique<InspectorPanel>(); }

}  // namespace plumb::editor::ui
