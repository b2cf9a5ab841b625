#include "editor/ui/panels/component_view.hpp"

#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/document/field_number.hpp"
#include "editor/model/document/root_place.hpp"
#include "editor/model/field_text.hpp"
#include "editor/model/workspace.hpp"
#include "editor/ui/icons.hpp"
#include "editor/ui/ui_compat.hpp"

namespace plumb::editor::ui {
namespace {

/// Splits an identifier into words: "surfaceSpeed" becomes
/// "surface speed", "MovingPlatform" "Moving platform".
std::string wordsOf(std::string_view name) {
    const auto isCapital = [](char letter) { return letter >= 'A' && letter <= 'Z'; };
    std::string words;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const bool begins = i > 0 && isCapital(name[i]) && !isCapital(name[i - 1]);
        if (!begins) {
            words += name[i];
            continue;
        }
        // A single capital, such as the name of an axis, keeps its case.
        const bool word = i + 1 < name.size() && !isCapital(name[i + 1]);
        words += ' ';
        words += word ? static_cast<char>(name[i] - 'A' + 'a') : name[i];
    }
    return words;
}

/// Returns the tooltip of a field: description, unit and range.
std::string helpFor(const FieldInfo& field) {
    // The name in files and code is added where the label shows it split into words.
    std::string help{field.doc.empty() ? field.name : field.doc};
    if (!field.doc.empty() && wordsOf(field.name) != field.name) help = format("{}: {}", field.name, help);
    const char* unit = shownUnit(field.unit);
    if (*unit != '\0') help += format(" ({})", unit);
    const NumberRange range = numberRange(field);
    if (hasNumbers(field) && range.limited)
        help += format("\n{} to {}", numberText(range.min), numberText(range.max));
    if (hasNumbers(field))
        help += "\nDrag, or double-click to type: 16*3, +=10, *2. Shift drags fast, Alt drags slowly.";
    return help;
}

void drawLabel(Ui& ui, const FieldInfo& field, bool isDefault, float width) {
    pushFont(isDefault ? ui.fonts.text : ui.fonts.strong, ui.fonts.size);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size{std::max(width, 1.0f), ImGui::GetFrameHeight()};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(at, {at.x + size.x, at.y + size.y}, true);
    const std::string words = wordsOf(field.name);
    list.AddText({at.x, at.y + ImGui::GetStyle().FramePadding.y},
                 isDefault ? palette::kTextSoft : palette::kText, words.c_str());
    list.PopClipRect();
    ImGui::Dummy(size);  // the whole rectangle reacts to the mouse, not only the letters
    ImGui::PopFont();
    tooltip(helpFor(field));
}

FieldValue defaultOf(const FieldInfo& field, const ComponentState& fresh) {
    FieldValue value;
    const auto* from = static_cast<const std::byte*>(field.in(static_cast<const void*>(fresh.bytes.data())));
    value.bytes.assign(from, from + field.size);
    return value;
}

/// Draws a note instead of the position fields, for the root of a prefab.
void drawPlaceOfRoot(Ui& ui, const std::string& path) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("each instance has its own value");
    ui.widgets.mark(path, "stays");
    tooltip(kRootCannotMove);
}

bool item(Ui& ui, const std::string& path, const char* label, bool possible = true) {
    const bool chosen = ImGui::MenuItem(label, nullptr, false, possible);
    ui.widgets.mark(path);
    return chosen;
}

}  // namespace

void drawPrefabBar(const Ui& ui, ImVec2 from, float height) {
    ImGui::GetWindowDrawList()->AddRectFilled({from.x - ui.px(4.0f), from.y},
                                              {from.x - ui.px(1.0f), from.y + height}, palette::kAccent);
}

void ComponentView::draw(Ui& ui, const TypeInfo& type, const Selected& selected) {
    const auto& [ids, entities, overrides] = selected;
    const Shown shown{ui, type, ids, overrides, entities, defaultComponent(type)};
    held_ = {};
    if (ui.workspace.play.running()) found_.clear();  // a paused game can be edited without a new tick
    const std::string name{type.name};
    ImGui::PushID(name.c_str());
    ImGui::PushStyleColor(ImGuiCol_Header, palette::kHeader);
    ImGui::PushStyleColor(ImGuiCol_HeaderHovered, palette::kHeaderHovered);
    ImGui::PushStyleColor(ImGuiCol_HeaderActive, palette::kHeaderHovered);
    pushFont(ui.fonts.strong, ui.fonts.size);
    bool keep = true;
    const bool open =
        ImGui::CollapsingHeader(format("{}###{}", wordsOf(name), name).c_str(),
                                ui.workspace.canEdit() ? &keep : nullptr, ImGuiTreeNodeFlags_DefaultOpen);
    ImGui::PopFont();
    ImGui::PopStyleColor(3);
    ui.widgets.mark("Inspector/" + name);
    tooltip(type.doc);
    const bool differs = overrides.find(type) != nullptr;
    if (differs) {
        const ImVec2 at = ImGui::GetItemRectMin();
        drawPrefabBar(ui, {at.x + ui.px(4.0f), at.y}, ImGui::GetItemRectMax().y - at.y);
    }
    drawMenu(shown, differs);
    if (!keep) {
        ask([ids, &type](Workspace& workspace) {
            workspace.undo.push(removeComponent(workspace.document, ids, type));
        });
    }
    if (open && type.size > 0) {
        // The id of the selection is part of the widget ids:
        // an active drag must not continue on another entity.
        ImGui::PushID(static_cast<int>(ids.back().value));
        drawFields(shown);
        ImGui::PopID();
        ImGui::Dummy({0.0f, ui.px(2.0f)});
    }
    ImGui::PopID();
}

/// Draws the editable fields and, while a game runs, the transient state below them.
void ComponentView::drawFields(const Shown& shown) {
    for (const FieldInfo& field : shown.type.fields) {
        if (!field.transient) drawField(shown, field);
    }
    if (!shown.ui.workspace.play.running()) return;
    bool first = true;
    for (const FieldInfo& field : shown.type.fields) {
        if (!field.transient) continue;
        if (std::exchange(first, false)) ImGui::TextDisabled("State at this tick");
        drawField(shown, field);
    }
}

void ComponentView::drawMenu(const Shown& shown, bool differs) {
    auto& [ui, type, ids, overrides, entities, fresh] = shown;
    if (!ImGui::BeginPopupContextItem("component")) return;
    const std::string path = format("Inspector/{}", type.name);
    Workspace& workspace = ui.workspace;
    if (item(ui, path + "/copy", "Copy component"))
        workspace.clipboard = componentText(workspace, type, ids.back());
    const TypeInfo* copied = componentInText(workspace.document.types(), workspace.clipboard);
    const bool fits = copied != nullptr && (workspace.canEdit() || copied == &type);
    const std::string paste =
        copied == nullptr ? std::string{"Paste component"} : format("Paste {}", copied->name);
    if (item(ui, path + "/paste", paste.c_str(), fits)) {
        ask([ids](Workspace& w) {
            const Result<Done> done = pasteComponent(w, ids, w.clipboard);
            if (!done) w.notice = done.error().text();
        });
    }
    if (item(ui, path + "/reset", "Reset to defaults", type.size > 0)) {
        ask([ids, &type](Workspace& w) { resetComponent(w, ids, type); });
    }
    if (overrides.isPart && workspace.canEdit()) {
        ImGui::Separator();
        prefabItems(ui, path, {&type}, differs);
    }
    ImGui::Separator();
    if (item(ui, path + "/remove", "Remove component", workspace.canEdit())) {
        ask([ids, &type](Workspace& w) { w.undo.push(removeComponent(w.document, ids, type)); });
    }
    ImGui::EndPopup();
}

/// Adds the menu items "Revert to prefab" and "Apply to prefab".
void ComponentView::prefabItems(Ui& ui, const std::string& path, const PrefabScope& scope, bool differs) {
    if (item(ui, path + "/revert", "Revert to prefab", differs))
        ask([scope](Workspace& workspace) { workspace.revertToPrefab(scope); });
    if (item(ui, path + "/apply", "Apply to prefab", differs))
        ask([scope](Workspace& workspace) { workspace.applyToPrefab(scope); });
}

const ComponentView::Found& ComponentView::find(const Shown& shown, const FieldInfo& field) {
    const Workspace& workspace = shown.ui.workspace;
    const SelectedState now = selectedState(workspace);
    if (std::exchange(looked_, now) != now) {
        found_.clear();
        held_ = {};
    }
    if (const auto known = found_.find(&field); known != found_.end()) return known->second;
    if (held_.inHand == nullptr) held_ = heldComponents(workspace.shownWorld(), shown.type, shown.entities);
    Found found;
    if (held_.inHand != nullptr && isShown(field, held_))
        found = {sharedField(workspace.shownNames(), field, held_, shown.fresh), true};
    return found_.emplace(&field, std::move(found)).first->second;
}

void ComponentView::drawField(const Shown& shown, const FieldInfo& field) {
    auto& [ui, type, ids, overrides, entities, fresh] = shown;
    const FieldTarget target{type, field, ids};
    // A copy, because a change made in this row may clear the cache.
    const auto [shared, visible] = find(shown, field);
    if (!visible) return;
    const std::string path = format("Inspector/{}/{}", type.name, field.name);
    const FieldRow row{ui, path, target, shared};

    ImGui::PushID(field.name.data());
    const float start = ImGui::GetCursorPosX();
    const float labelWidth = std::min(ImGui::GetContentRegionAvail().x * 0.38f, ui.px(140.0f));
    const bool differs = overrides.has(type, field.name);
    const bool stays = ids.size() == 1 && !ui.workspace.play.running() &&
                       isPlaceOfRoot(ui.workspace.document, ids.front(), type, field.name);
    const bool asItShould = stays || (overrides.isPart ? !differs : shared.isDefault);
    if (differs) drawPrefabBar(ui, ImGui::GetCursorScreenPos(), ImGui::GetFrameHeight());
    ImGui::BeginGroup();
    const float arrow = asItShould ? ui.px(4.0f) : ui.px(20.0f);
    drawLabel(ui, field, asItShould, labelWidth - arrow);
    ui.widgets.mark(path + "/label", differs ? "overridden" : asItShould ? "" : "changed");
    ImGui::SameLine(0.0f, 0.0f);
    // No reset arrow on prefab instances while a game runs: reverting changes the scene, not the game.
    if (!asItShould && (!overrides.isPart || ui.workspace.canEdit()))
        drawReset(row, shown, start + labelWidth);
    ImGui::SetCursorPosX(start + labelWidth);
    if (stays) {
        drawPlaceOfRoot(ui, path);
        ImGui::EndGroup();
        ImGui::PopID();
        return;
    }
    ImGui::BeginGroup();
    fields_.draw(row);
    ImGui::EndGroup();
    ImGui::EndGroup();
    drawFieldMenu(row, shown);
    ImGui::PopID();
}

void ComponentView::drawReset(const FieldRow& row, const Shown& shown, float end) {
    Ui& ui = row.ui;
    const float side = ui.px(16.0f);
    ImGui::SetCursorPosX(end - side - ui.px(3.0f));
    const bool clicked = ImGui::InvisibleButton("##reset", {side, ImGui::GetFrameHeight()});
    ui.widgets.mark(row.path + "/arrow");
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    drawIcon(*ImGui::GetWindowDrawList(), Icon::Undo, {(from.x + to.x) * 0.5f, (from.y + to.y) * 0.5f},
             ui.px(11.0f), ImGui::IsItemHovered() ? palette::kText : palette::kTextDim);
    tooltip(shown.overrides.isPart ? "Reset to the prefab's value" : "Reset to the default");
    ImGui::SameLine(0.0f, 0.0f);
    if (clicked) reset(row, shown);
}

void ComponentView::reset(const FieldRow& row, const Shown& shown) {
    const auto& [type, field, objects] = row.target;
    if (shown.overrides.isPart)
        return ask([scope = PrefabScope{&type, field.name}](Workspace& w) { w.revertToPrefab(scope); });
    row.set(defaultOf(field, shown.fresh));
}

void ComponentView::drawFieldMenu(const FieldRow& row, const Shown& shown) {
    if (!ImGui::BeginPopupContextItem("field")) return;
    const auto& [type, field, objects] = row.target;
    Workspace& workspace = row.ui.workspace;
    const bool differs = shown.overrides.has(type, field.name);
    if (shown.overrides.isPart && workspace.canEdit())
        prefabItems(row.ui, row.path, {&type, field.name}, differs);
    if (item(row.ui, row.path + "/reset", "Reset to default", !row.shared.isDefault))
        row.set(defaultOf(field, shown.fresh));
    ImGui::Separator();
    if (item(row.ui, row.path + "/copy", "Copy value", !row.mixed()))
        workspace.clipboard = valueText(workspace, type, field, row.shared.value);
    if (item(row.ui, row.path + "/paste", "Paste value", !workspace.clipboard.empty())) {
        const Result<FieldValue> value = valueFromText(workspace, type, field, workspace.clipboard);
        if (value) {
            row.set(*value);
        } else {
            workspace.notice = value.error().text();
        }
    }
    if (workspace.play.running()) {
        ImGui::Separator();
        const WatchedField watched{workspace.play.find(objects.back()), &type, &field};
        if (item(row.ui, row.path + "/lastChange", "Run back to its last change", objects.size() == 1))
            ask([watched](Workspace& w) {
                w.debugger.runBackToChange(watched), w.notice = w.debugger.notice();
            });
    }
    ImGui::EndPopup();
}

void ComponentView::endFrame(Ui& ui) {
    fields_.endFrame(ui);
    if (const auto asked = std::exchange(asked_, nullptr)) {
        ui.workspace.undo.endGesture();
        asked(ui.workspace);
        ui.workspace.undo.endGesture();
    }
}

}  // namespace plumb::editor::ui
