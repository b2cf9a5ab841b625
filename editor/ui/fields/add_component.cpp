#include "editor/ui/fields/add_component.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/document/name_filter.hpp"
#include "editor/model/workspace.hpp"
#include "editor/ui/fields/pickers.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/text_field.hpp"

namespace plumb::editor::ui {
namespace {

/// Cuts a text between two words to fit into a width, and appends "...".
std::string fittedWords(std::string_view text, float width) {
    const auto wide = [](const std::string& words) { return ImGui::CalcTextSize(words.c_str()).x; };
    std::string words{text};
    for (std::size_t end = text.size(); wide(words) > width; words = format("{} ...", text.substr(0, end))) {
        end = text.rfind(' ', end - 1);
        if (end == std::string_view::npos || end == 0) break;
    }
    return words;
}

/// Draws a component type with its name, and its description below as far as there is room.
/// @param have  number of selected entities that have the component
/// @param of    number of selected entities
/// @return true if the row was clicked
bool componentRow(const Ui& ui, const TypeInfo& type, std::size_t have, std::size_t of) {
    const float line = ImGui::GetTextLineHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::PushID(type.name.data());
    const bool chosen = ImGui::Selectable("##type", false, 0, {0.0f, line * 2.0f + ui.px(2.0f)});
    ImGui::PopID();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(at, {at.x + width, at.y + line * 3.0f}, true);
    const std::string name{type.name};
    list.AddText({at.x + ui.px(2.0f), at.y}, palette::kText, name.c_str());
    if (have > 0) {
        const std::string count = format("{} of {} have it", have, of);
        list.AddText({at.x + width - ImGui::CalcTextSize(count.c_str()).x, at.y}, palette::kTextDim,
                     count.c_str());
    }
    const std::string doc = fittedWords(type.doc, width - ui.px(4.0f));
    list.AddText({at.x + ui.px(2.0f), at.y + line + ui.px(1.0f)}, palette::kTextDim, doc.c_str());
    list.PopClipRect();
    return chosen;
}

}  // namespace

void AddComponent::draw(Ui& ui, const std::vector<ObjectId>& ids, std::span<const ComponentHolders> held) {
    if (ImGui::Button("Add component", {-1.0f, 0.0f})) {
        ImGui::OpenPopup("add");
        search_.clear();
    }
    ui.widgets.mark("Inspector/add");
    ImGui::SetNextWindowSize({ui.px(320.0f), ui.px(380.0f)});
    if (!ImGui::BeginPopup("add")) return;
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0f);
    const bool enter =
        textField("##search", search_, ImGuiInputTextFlags_EnterReturnsTrue, "Search; Enter adds the first");
    ui.widgets.mark("Inspector/add/search", search_);
    if (ImGui::IsItemDeactivated() && pressed(Key::Escape)) ImGui::CloseCurrentPopup();
    beginChild("types", {0.0f, 0.0f}, false);
    drawList(ui, ids, held, enter);
    ImGui::EndChild();
    ImGui::EndPopup();
}

/// @param first  true: adds the first component of the list, as Enter was pressed
void AddComponent::drawList(Ui& ui, const std::vector<ObjectId>& ids, std::span<const ComponentHolders> held,
                            bool first) {
    const TypeInfo* chosen = nullptr;
    bool any = false;
    // Matches of the name are listed before matches of the description.
    for (const bool byName : {true, false}) {
        for (const TypeInfo& type : ui.workspace.document.types().all()) {
            const bool named = containsWord(type.name, search_);
            if (isHiddenInComponentLists(type) || named != byName ||
                (!named && !containsWord(type.doc, search_)))
                continue;
            const auto known = std::find_if(held.begin(), held.end(),
                                            [&](const ComponentHolders& one) { return one.type == &type; });
            const std::size_t have = known == held.end() ? 0 : known->count;
            if (have == ids.size()) continue;
            const bool clicked = componentRow(ui, type, have, ids.size());
            ui.widgets.mark(format("Inspector/add/{}", type.name));
            tooltip(type.doc);
            if (clicked || (first && !any)) chosen = &type;
            any = true;
        }
    }
    if (!any) ImGui::TextDisabled("No component matches the search.");
    if (chosen == nullptr) return;
    ui.workspace.undo.endGesture();
    ui.workspace.undo.push(addComponent(ui.workspace.document, ids, *chosen));
    ui.workspace.undo.endGesture();
    ImGui::CloseCurrentPopup();
}

}  // namespace plumb::editor::ui
