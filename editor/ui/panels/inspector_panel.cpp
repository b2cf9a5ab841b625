#include <array>

#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/commands/set_field.hpp"
#include "editor/ui/icons.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/empty_state.hpp"
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
            return emptyState(ui, "Inspector", "Nothing is selected.",
                              "Click something in the scene or in its tree, and its components are here.",
                              {"entity.create", "edit.selectAll"});
        }
        const World& world = ui.workspace.shownWorld();
        const ObjectId shown = selected.back();
        if (!world.alive(ui.workspace.shownEntity(shown))) {
            ImGui::TextWrapped("This entity is gone in the running game.");
            return;
        }
        compareWithPrefab(ui, shown);
        drawName(ui, shown, selected.size());
        for (const TypeInfo& type : ui.workspace.document.types().all()) {
            if (!hasOwnPlace(type) && haveAll(ui, type, selected)) drawComponent(ui, type, selected);
        }
        for (const PrefabOverrides::Component& component : overrides_.components) {
            if (component.removed) drawRemoved(ui, *component.type);
        }
        ImGui::Spacing();
        if (ui.workspace.canEdit()) drawAdd(ui, selected);
        // Only now: components that are being drawn must not move in memory.
        if (const std::optional<Asked> asked = std::exchange(asked_, std::nullopt)) {
            asked->apply ? ui.workspace.applyToPrefab(asked->scope)
                         : ui.workspace.revertToPrefab(asked->scope);
        }
    }

private:
    [[nodiscard]] static bool haveAll(const Ui& ui, const TypeInfo& type, const std::vector<ObjectId>& ids) {
        const World& world = ui.workspace.shownWorld();
        for (const ObjectId id : ids) {
            if (!world.has(type, ui.workspace.shownEntity(id))) return false;
        }
        return true;
    }

    /// Once for each change of the scene or the selection. A running game is compared with nothing.
    void compareWithPrefab(Ui& ui, ObjectId id) {
        Workspace& workspace = ui.workspace;
        if (workspace.play.running()) {
            overrides_ = {};
            compared_ = {};
            return;
        }
        const Compared now{workspace.document.sceneRevision, id};
        if (std::exchange(compared_, now) == now) return;
        const PrefabEdit edit = workspace.prefabs();
        overrides_ = overridesOf(edit.document, edit.prefabs, id);
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
        if (overrides_.isPart) drawPrefab(ui, id);
        ImGui::Spacing();
    }

    /// Which prefab it comes from, how it differs, and both ways to make them agree.
    void drawPrefab(Ui& ui, ObjectId id) {
        const PrefabEdit edit = ui.workspace.prefabs();
        const auto part = InstancePart::of(edit.document, edit.prefabs, id);
        if (!part) return;
        const std::string& path = part->prefab().path;
        ImGui::TextDisabled("from %s", path.substr(path.rfind('/') + 1).c_str());
        tooltip(format("{}\nWhat this entity has for itself is bold, with a bar beside it.", path));
        const std::size_t count = overrides_.count();
        ImGui::SameLine();
        ImGui::PushStyleColor(ImGuiCol_Text, count == 0 ? palette::kTextDim : palette::kAccent);
        ImGui::TextUnformatted(count == 0 ? "unchanged" : format("{} changed", count).c_str());
        ImGui::PopStyleColor();
        ui.widgets.mark("Inspector/prefab", format("{}", count));
        if (count == 0) return;
        const float width = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) * 0.5f;
        if (ImGui::Button("Revert all", {width, 0.0f})) asked_ = Asked{false, {}};
        ui.widgets.mark("Inspector/prefab/revert");
        tooltip("Takes back what this instance has for itself, but not where it stands.  (Ctrl+R)");
        ImGui::SameLine();
        if (ImGui::Button("Apply all", {width, 0.0f})) asked_ = Asked{true, {}};
        ui.widgets.mark("Inspector/prefab/apply");
        tooltip("Writes it into the prefab's file; other instances follow.  (Ctrl+Shift+R)");
    }

    /// Both ways between an instance and its prefab, in a context menu.
    void prefabItems(Ui& ui, const std::string& path, const PrefabScope& scope, bool differs) {
        const bool revert = ImGui::MenuItem("Revert to prefab", nullptr, false, differs);
        ui.widgets.mark(path + "/revert");
        const bool apply = ImGui::MenuItem("Apply to prefab", nullptr, false, differs);
        ui.widgets.mark(path + "/apply");
        if (revert || apply) asked_ = Asked{apply, scope};
    }

    /// The bar beside what differs from the prefab.
    static void drawBar(const Ui& ui, ImVec2 from, float height) {
        ImGui::GetWindowDrawList()->AddRectFilled({from.x - ui.px(4.0f), from.y},
                                                  {from.x - ui.px(1.0f), from.y + height}, palette::kAccent);
    }

    void drawRemoved(Ui& ui, const TypeInfo& type) {
        ImGui::PushID(type.name.data());
        drawBar(ui, ImGui::GetCursorScreenPos(), ImGui::GetFrameHeight());
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s is taken out", std::string{type.name}.c_str());
        ImGui::SameLine();
        if (ImGui::SmallButton("Restore")) asked_ = Asked{false, {&type}};
        ui.widgets.mark(format("Inspector/{}/restore", type.name));
        tooltip("The prefab has this component.");
        ImGui::PopID();
    }

    void drawComponent(Ui& ui, const TypeInfo& type, const std::vector<ObjectId>& ids) {
        const std::string name{type.name};
        ImGui::PushID(name.c_str());
        ImGui::PushStyleColor(ImGuiCol_Header, palette::kHeader);
        ImGui::PushStyleColor(ImGuiCol_HeaderHovered, palette::kHeaderHovered);
        ImGui::PushStyleColor(ImGuiCol_HeaderActive, palette::kHeaderHovered);
        pushFont(ui.fonts.strong, ui.fonts.size);
        bool keep = true;
        const bool open = ImGui::CollapsingHeader(name.c_str(), ui.workspace.canEdit() ? &keep : nullptr,
                                                  ImGuiTreeNodeFlags_DefaultOpen);
        ImGui::PopFont();
        ImGui::PopStyleColor(3);
        ui.widgets.mark("Inspector/" + name);
        tooltip(type.doc);
        const PrefabOverrides::Component* changed = overrides_.find(type);
        if (changed != nullptr) {
            const ImVec2 at = ImGui::GetItemRectMin();
            drawBar(ui, {at.x + ui.px(4.0f), at.y}, ImGui::GetItemRectMax().y - at.y);
        }
        if (ui.workspace.canEdit() && ImGui::BeginPopupContextItem("component")) {
            if (overrides_.isPart) prefabItems(ui, "Inspector/" + name, {&type}, changed != nullptr);
            if (ImGui::MenuItem("Remove component")) keep = false;
            ImGui::EndPopup();
        }
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
        const bool differs = overrides_.has(type, field.name);
        if (differs) drawBar(ui, ImGui::GetCursorScreenPos(), ImGui::GetFrameHeight());
        drawLabel(ui, field, overrides_.isPart ? !differs : now == normal, start + labelWidth);
        ui.widgets.mark(path + "/label", differs ? "overridden" : "");
        if (ImGui::BeginPopupContextItem("reset")) {
            if (overrides_.isPart) prefabItems(ui, path, {&type, field.name}, differs);
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
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const ImVec2 size{end - ImGui::GetCursorPosX() - ui.px(4.0f), ImGui::GetFrameHeight()};
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.PushClipRect(at, {at.x + size.x, at.y + size.y}, true);
        list.AddText({at.x, at.y + ImGui::GetStyle().FramePadding.y},
                     isDefault ? palette::kTextSoft : palette::kText, field.name.data(),
                     field.name.data() + field.name.size());
        list.PopClipRect();
        ImGui::Dummy(size);  // all of it takes the mouse, not only the letters
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
                workspace.play.edit(id, type, field, next);
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

    struct Compared {
        std::uint64_t revision = 0;
        ObjectId id;
        friend bool operator==(const Compared&, const Compared&) = default;
    };

    struct Asked {
        bool apply = false;  ///< else revert
        PrefabScope scope;
    };

    std::array<char, 64> filter_{};
    std::optional<Asked> asked_;
    PrefabOverrides overrides_;  // of the entity selected last, as it was at `compared_`
    Compared compared_;
};

}  // namespace

std::unique_ptr<Panel> makeInspectorPanel() { return std::make_unique<InspectorPanel>(); }

}  // namespace plumb::editor::ui
