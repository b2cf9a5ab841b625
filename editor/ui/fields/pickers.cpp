#include "editor/ui/fields/pickers.hpp"

#include <algorithm>
#include <utility>

#include "assets/asset_store.hpp"
#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/document/bounds.hpp"
#include "editor/model/document/name_filter.hpp"
#include "editor/ui/icons.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/asset_picture.hpp"
#include "editor/ui/widgets/text_field.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kListWidth = 260.0f;  // px at scale 1
constexpr float kListHeight = 300.0f;
constexpr float kReach = 5.0f;  // px on screen: hit distance of entities for the dragged target icon

bool choice(const Ui& ui, const std::string& path, const std::string& label, bool now) {
    const bool chosen = ImGui::Selectable((label + "##" + path).c_str(), now);
    ui.widgets.mark(path);
    return chosen;
}

/// Begins a popup list with a search field below the last item.
/// @param takesFirst  set to true if Enter selects the first match
/// @return true if the popup is open; it must be ended with EndPopup
bool beginList(const FieldRow& row, std::string& search, bool opens, bool& takesFirst) {
    const ImVec2 below{ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y};
    if (opens) {
        ImGui::OpenPopup("list");
        search.clear();
    }
    ImGui::SetNextWindowPos(below, ImGuiCond_Appearing);
    ImGui::SetNextWindowSize({row.ui.px(kListWidth), row.ui.px(kListHeight)});
    if (!ImGui::BeginPopup("list")) return false;
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0f);
    const bool enter = textField("##search", search, ImGuiInputTextFlags_EnterReturnsTrue, "Search");
    row.ui.widgets.mark(row.path + "/search", search);
    if (ImGui::IsItemDeactivated() && pressed(Key::Escape)) ImGui::CloseCurrentPopup();
    takesFirst = enter && !search.empty();
    return true;
}

/// Draws a button that shows the selected value and opens the list. @return true if it was clicked
bool chosenButton(const FieldRow& row, const std::string& shown, float width, bool dim) {
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
    ImGui::PushStyleColor(ImGuiCol_Text, dim ? palette::kTextDim : palette::kText);
    ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {0.0f, 0.5f});
    const bool clicked = ImGui::Button((shown + "##chosen").c_str(), {std::max(width, 1.0f), 0.0f});
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    row.ui.widgets.mark(row.path, shown);
    return clicked;
}

/// Draws a square button with an icon after the last item.
bool signButton(const FieldRow& row, const char* name, Icon icon) {
    const float side = ImGui::GetFrameHeight();
    ImGui::SameLine(0.0f, row.ui.px(3.0f));
    const bool clicked = ImGui::Button(format("##{}", name).c_str(), {side, side});
    row.ui.widgets.mark(format("{}/{}", row.path, name));
    const ImVec2 from = ImGui::GetItemRectMin();
    drawIcon(*ImGui::GetWindowDrawList(), icon, {from.x + side * 0.5f, from.y + side * 0.5f},
             row.ui.px(13.0f), palette::kText);
    return clicked;
}

bool mouseIsOver(const Ui& ui, std::string_view widget) {
    const WidgetMap::Widget* found = ui.widgets.find(widget);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return found != nullptr && contains(found->box, Vec2{mouse.x, mouse.y});
}

}  // namespace

// ---- entities

void EntityPicker::draw(const FieldRow& row) {
    const Document& document = row.ui.workspace.document;
    const auto id = row.value<ObjectId>();
    const std::string shown = row.mixed()         ? kMixed
                              : !id               ? "none"
                              : document.find(id) ? document.nameOf(id)
                                                  : "missing";
    const float buttons = (ImGui::GetFrameHeight() + row.ui.px(3.0f)) * 2.0f;
    const bool opens =
        chosenButton(row, shown, ImGui::GetContentRegionAvail().x - buttons, row.mixed() || !id);
    if (ImGui::BeginDragDropTarget()) {
        if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(kEntityPayload)) {
            ObjectId dropped;
            std::memcpy(&dropped, payload->Data, sizeof dropped);
            row.set(FieldValue::of(dropped));
        }
        ImGui::EndDragDropTarget();
    }
    bool first = false;
    if (beginList(row, search_, opens, first)) {
        drawList(row, first);
        ImGui::EndPopup();
    }
    drawAim(row);
    drawGoTo(row, row.mixed() ? ObjectId{} : id);
}

void EntityPicker::drawList(const FieldRow& row, bool first) {
    const Document& document = row.ui.workspace.document;
    const auto now = row.value<ObjectId>();
    found_.clear();
    for (const ObjectId id : document.objects()) {
        if (search_.empty() || containsWord(document.nameOf(id), search_)) found_.push_back(id);
    }
    if (first && !found_.empty()) {
        row.set(FieldValue::of(found_.front()));
        ImGui::CloseCurrentPopup();
    }
    beginChild("entities", {0.0f, 0.0f}, false);
    if (search_.empty() && choice(row.ui, row.path + "/none", "none", !now && !row.mixed())) {
        row.set(FieldValue::of(ObjectId{}));
        ImGui::CloseCurrentPopup();
    }
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(found_.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const ObjectId id = found_[static_cast<std::size_t>(i)];
            const std::string name = document.nameOf(id);
            ImGui::PushID(i);
            if (choice(row.ui, row.path + "/" + name, name, id == now && !row.mixed())) {
                row.set(FieldValue::of(id));
                ImGui::CloseCurrentPopup();
            }
            ImGui::PopID();
        }
    }
    if (found_.empty()) ImGui::TextDisabled("No entity has this name.");
    ImGui::EndChild();
}

/// Draws a target icon; dragging it onto an entity in the scene view selects that entity as the value.
void EntityPicker::drawAim(const FieldRow& row) {
    Ui& ui = row.ui;
    signButton(row, "aim", Icon::Pick);
    if (!ImGui::IsItemActive() && !ImGui::IsItemDeactivated()) {
        tooltip("Drag this onto an entity in the scene");
        return;
    }
    if (!mouseIsOver(ui, "Viewport")) return;
    const Document& document = ui.workspace.document;
    const ObjectId under = pickFirst(document, ui.mouseInScene, kReach / ui.workspace.view.zoom());
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (ImGui::IsItemActive()) {
        ImGui::BeginTooltip();
        ImGui::TextUnformatted(under ? document.nameOf(under).c_str() : "none");
        ImGui::EndTooltip();
    } else if (under) {
        row.set(FieldValue::of(under));
    }
}

void EntityPicker::drawGoTo(const FieldRow& row, ObjectId id) {
    Workspace& workspace = row.ui.workspace;
    const bool there = static_cast<bool>(workspace.document.find(id));
    ImGui::BeginDisabled(!there);
    const bool goes = signButton(row, "go", Icon::Watch);
    ImGui::EndDisabled();
    if (!there) return;
    tooltip("Selects this entity and shows it in the scene view");
    if (!goes) return;
    workspace.document.selection.set({id});
    runAction(workspace, "view.frame");
}

// ---- files

void AssetPicker::draw(const FieldRow& row) {
    Workspace& workspace = row.ui.workspace;
    const AssetKind kind = row.target.field.asset;
    const auto id = row.value<TextId>();
    std::string path{workspace.shownWorld().texts().find(id)};
    if (path.empty()) path = workspace.assets.pathOf(kind, id);
    const std::string name = path.substr(path.rfind('/') + 1);
    const std::string shown = row.mixed() ? kMixed : id.empty() ? "none" : name.empty() ? "missing" : name;

    const float side = ImGui::GetFrameHeight();
    const bool picture = !row.mixed() && !path.empty();
    if (picture) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilled(at, {at.x + side, at.y + side}, palette::kField, row.ui.px(3.0f));
        drawAsset(row.ui, list, kind, path, {{at.x, at.y}, {at.x + side, at.y + side}}, 0.0);
        ImGui::Dummy({side, side});
        ImGui::SameLine(0.0f, row.ui.px(3.0f));
    }
    const bool opens = chosenButton(row, shown, ImGui::GetContentRegionAvail().x, row.mixed() || id.empty());
    row.ui.widgets.mark(row.path, row.mixed() ? kMixed : path);
    if (picture) tooltip(path);
    std::string hovering;
    const std::string dropped = acceptAsset(hovering);
    if (!hovering.empty()) {
        const ImU32 color = assetKindOf(hovering) == kind ? palette::kAccent : palette::kError;
        outline(*ImGui::GetWindowDrawList(), ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), color);
    }
    if (!dropped.empty() && assetKindOf(dropped) == kind) set(row, dropped);
    if (!dropped.empty() && assetKindOf(dropped) != kind)
        workspace.notice = format("{} is not a file of the kind \"{}\"", dropped, nameOfKind(kind));
    if (opens) {
        AssetCatalog catalog{workspace.project.root};
        catalog.refresh();
        files_ = catalog.all();
        std::erase_if(files_, [kind](const AssetItem& item) { return item.folder || item.kind != kind; });
    }
    bool first = false;
    if (!beginList(row, search_, opens, first)) return;
    drawList(row, path, first);
    ImGui::EndPopup();
}

void AssetPicker::drawList(const FieldRow& row, std::string_view now, bool first) {
    const Ui& ui = row.ui;
    beginChild("files", {0.0f, 0.0f}, false);
    if (search_.empty() && choice(ui, row.path + "/none", "none", now.empty() && !row.mixed())) {
        set(row, {});
        ImGui::CloseCurrentPopup();
    }
    const float side = ui.px(34.0f);
    const float line = ImGui::GetTextLineHeight();
    bool any = false;
    for (const AssetItem& item : files_) {
        if (!containsWord(item.path, search_)) continue;
        const bool taken = first && !std::exchange(any, true);
        any = true;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const bool clicked = ImGui::Selectable(("##" + item.path).c_str(), item.path == now, 0, {0.0f, side});
        const bool chosen = clicked || taken;
        row.ui.widgets.mark(row.path + "/" + item.path);
        if (chosen) {
            set(row, item.path);
            ImGui::CloseCurrentPopup();
        }
        if (!ImGui::IsItemVisible()) continue;
        ImDrawList& list = *ImGui::GetWindowDrawList();
        drawAsset(row.ui, list, item.kind, item.path, {{at.x, at.y}, {at.x + side, at.y + side}}, 0.0);
        const float left = at.x + side + ui.px(7.0f);
        const float top = at.y + (side - line * 2.0f) * 0.5f;
        const std::string name{item.name()};
        const std::string folder = item.path.substr(0, item.path.size() - name.size());
        list.AddText({left, top}, palette::kText, name.c_str());
        list.AddText({left, top + line}, palette::kTextDim, folder.c_str());
    }
    if (!any)
        ImGui::TextDisabled("No file of the kind \"%s\" matches.",
                            std::string{nameOfKind(row.target.field.asset)}.c_str());
    ImGui::EndChild();
}

void AssetPicker::set(const FieldRow& row, std::string_view path) {
    Workspace& workspace = row.ui.workspace;
    const AssetKind kind = row.target.field.asset;
    if (!path.empty()) {
        workspace.assets.load(kind, path);
        if (AssetStore* played = workspace.play.assets()) played->load(kind, path);
    }
    row.set(FieldValue::of(workspace.shownWorld().texts().add(path)));
}

}  // namespace plumb::editor::ui
