#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/document/scene_tree.hpp"
#include "editor/model/document/visibility.hpp"
#include "editor/model/play/scene_of_game.hpp"
#include "editor/model/tree_edit.hpp"
#include "editor/ui/fields/pickers.hpp"
#include "editor/ui/icons.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/empty_state.hpp"
#include "scene/components/drawing/hidden.hpp"
#include "scene/components/prefab_instance.hpp"

namespace plumb::editor::ui {
namespace {

/// Renames an entity. If it is selected, renames all selected entities, as one undo step.
void renameAll(Workspace& workspace, ObjectId named, const std::string& name) {
    Document& document = workspace.document;
    Transaction step{workspace.undo, "rename"};
    const bool withOthers = document.selection.has(named);
    const std::vector<ObjectId> all = withOthers ? document.selection.all() : std::vector{named};
    for (const ObjectId id : all) workspace.undo.push(renameEntity(document, id, name));
    step.commit();
    if (all.size() > 1) workspace.notice = format("{} entities renamed to {}", all.size(), name);
}

constexpr ThemeColor kOfPrefab = palette::kBlue;  // names of entities that come from a prefab
constexpr float kIconRoom = 18.0f;                // px at scale 1, width of the eye and lock icons
constexpr float kScrollEdge = 24.0f;              // px at scale 1, height of the edge in which a drag scrolls

/// Tree of the scene's entities: select, rename, reorder by drag and drop, hide and lock.
class ScenePanel final : public Panel {
public:
    void draw(Ui& ui) override {
        const Document& document = ui.workspace.document;
        drawFilter(ui);
        saySceneOfGame(ui);
        // The height is a whole number of rows.
        const float room = ImGui::GetContentRegionAvail().y;
        const float row = rowHeight(ui);
        beginChild("tree", {0.0f, std::max(std::floor(room / row), 1.0f) * row}, false);
        if (document.scenePath.empty()) {
            emptyState(ui, "Scene", "No scene is open.", "", {"file.open", "file.new"});
        } else if (document.objectCount() == 0) {
            emptyState(ui, "Scene", "This scene is empty.",
                       "You can also drag files from the Assets panel into the viewport.",
                       {"entity.create", "entity.prefab"});
        } else {
            drawTree(ui);
        }
        ImGui::EndChild();
    }

private:
    using Row = SceneTree::Row;

    void drawFilter(Ui& ui) {
        const bool any = filter_[0] != '\0';
        const float clear = any ? ImGui::GetFrameHeight() + ui.px(2.0f) : 0.0f;
        if (ui.workspace.panelToShow == "Scene/filter") {
            ui.workspace.panelToShow.clear();
            ImGui::SetKeyboardFocusHere();
        }
        ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - clear);
        ImGui::InputTextWithHint("##filter", "Filter", filter_.data(), filter_.size());
        ui.widgets.mark("Scene/filter", filter_.data());
        tooltip(
            ui.workspace.settings.keys.labelOf(*findAction("edit.filter"),
                                               "Shows entities whose name, or a component's name, contains "
                                               "each word; c:RigidBody searches components only"));
        if (any) {
            ImGui::SameLine(0.0f, ui.px(2.0f));
            if (ImGui::Button("x", {ImGui::GetFrameHeight(), 0.0f})) filter_.fill('\0');
            ui.widgets.mark("Scene/filter/clear");
        }
        ImGui::Dummy({0.0f, ui.px(1.0f)});
    }

    /// Shows a note if the running game has changed to another scene, as the tree shows the edited one.
    static void saySceneOfGame(Ui& ui) {
        const std::string scene = sceneOfGame(ui.workspace);
        if (scene.empty() || scene == ui.workspace.document.scenePath) return;
        ImGui::PushStyleColor(ImGuiCol_Text, palette::kPlay);
        ImGui::TextWrapped("The game is now in %s.", scene.c_str());
        ImGui::PopStyleColor();
        ui.widgets.mark("Scene/game", scene);
        ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
        ImGui::TextWrapped("The tree below shows the edited scene, %s.",
                           ui.workspace.document.scenePath.c_str());
        ImGui::PopStyleColor();
    }

    void drawTree(Ui& ui) {
        const Document& document = ui.workspace.document;
        const Selection& selection = document.selection;
        const bool moved = std::exchange(shownSelection_, selection.revision()) != selection.revision();
        if (moved && !selection.empty()) tree_.openTo(document, selection.all().back());
        tree_.follow(document, filter_.data());
        if (moved && !selection.empty()) scrollTo(ui, selection.all().back());
        if (ui.workspace.request == WindowRequest::RenameSelected && !selection.empty())
            bringToSight(ui, selection.all().back());
        scrollWhileDragging(ui);
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(tree_.rows().size()), rowHeight(ui));
        while (clipper.Step()) {
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                drawRow(ui, tree_.rows()[static_cast<std::size_t>(i)]);
            }
        }
        // A right click focuses the tree, so that keys act on it.
        if (ImGui::IsMouseClicked(1) && ImGui::IsWindowHovered()) ImGui::SetWindowFocus();
        const ImVec2 rest = ImGui::GetContentRegionAvail();
        if (rest.y > 4.0f && ImGui::InvisibleButton("below", {rest.x, rest.y}))
            ui.workspace.document.selection.clear();
        if (rest.y > 4.0f) dropOn(ui, nullptr);
        if (const std::optional<Dropped> dropped = std::exchange(dropped_, std::nullopt)) {
            static_cast<void>(moveInTree(ui.workspace.document, ui.workspace.undo, dropped->moved,
                                         dropped->place,
                                         ImGui::GetIO().KeyAlt ? KeepPlace::InParent : KeepPlace::InWorld));
        }
    }

    /// Makes a row visible for renaming: expands its parents,
    /// clears the filter if it hides the row, and scrolls.
    void bringToSight(Ui& ui, ObjectId id) {
        const Document& document = ui.workspace.document;
        tree_.openTo(document, id);
        tree_.follow(document, filter_.data());
        if (tree_.rowOf(id) == tree_.rows().size()) {
            filter_.fill('\0');
            tree_.follow(document, "");
        }
        scrollTo(ui, id);
    }

    /// Scrolls to a row that was selected outside the panel.
    void scrollTo(const Ui& ui, ObjectId id) const {
        const std::size_t row = tree_.rowOf(id);
        if (row == tree_.rows().size()) return;
        const float top = rowHeight(ui) * static_cast<float>(row);
        const float room = ImGui::GetWindowHeight();
        if (top < ImGui::GetScrollY() || top + rowHeight(ui) > ImGui::GetScrollY() + room)
            ImGui::SetScrollY(top - std::floor(room * 0.5f / rowHeight(ui)) * rowHeight(ui));
    }

    static void scrollWhileDragging(const Ui& ui) {
        const ImGuiPayload* payload = ImGui::GetDragDropPayload();
        if (payload == nullptr || !payload->IsDataType(kEntityPayload)) return;
        const float top = ImGui::GetWindowPos().y;
        const float mouse = ImGui::GetMousePos().y;
        const float edge = ui.px(kScrollEdge);
        const float above = top + edge - mouse;
        const float below = mouse - (top + ImGui::GetWindowHeight() - edge);
        const float by = above > 0.0f ? -std::min(above, edge) : std::clamp(below, 0.0f, edge);
        if (by != 0.0f) ImGui::SetScrollY(ImGui::GetScrollY() + by * 0.5f);
    }

    [[nodiscard]] static float rowHeight(const Ui& ui) { return ui.px(22.0f); }

    void drawRow(Ui& ui, const Row& row) {
        Workspace& workspace = ui.workspace;
        Document& document = workspace.document;
        const std::string name = document.nameOf(row.id);
        ImGui::PushID(static_cast<int>(row.id.value ^ (row.id.value >> 32)));
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float height = rowHeight(ui);
        const float indent = ui.px(16.0f) * static_cast<float>(row.depth);
        if (row.id == renaming_) {
            drawRename(ui, indent + ui.px(38.0f));
            ImGui::PopID();
            return;
        }
        const float icons = at.x + ImGui::GetContentRegionAvail().x - ui.px(2.0f * kIconRoom);
        const ImVec2 spacing = ImGui::GetStyle().ItemSpacing;
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {spacing.x, 0.0f});
        const bool clicked = ImGui::Selectable("##row", document.selection.has(row.id),
                                               ImGuiSelectableFlags_AllowDoubleClick, {0.0f, height});
        ImGui::PopStyleVar();
        const bool hovered = ImGui::IsItemHovered();
        // The marked area excludes the icons, so that a click in its center selects.
        ui.widgets.mark("Scene/" + name, {{at.x, at.y}, {icons, at.y + height}}, name);
        if (clicked && ImGui::GetMousePos().x >= icons) {
            toggleView(document, row.id, ImGui::GetMousePos().x >= icons + ui.px(kIconRoom));
        } else if (clicked) {
            choose(ui, row, at.x + indent + ui.px(16.0f));
        }
        if (ImGui::IsItemClicked(ImGuiMouseButton_Right) && !document.selection.has(row.id))
            document.selection.set({row.id});
        if (ImGui::BeginPopupContextItem("menu")) {
            selectionMenu(ui, "Scene/menu");
            ImGui::EndPopup();
        }
        dragFrom(document, row.id, name);
        dropOn(ui, &row);
        drawContent(ui, row, name, {at.x + indent, at.y}, {icons, at.y + height});
        drawIcons(ui, row, name, {icons, at.y}, hovered);
        if (workspace.request == WindowRequest::RenameSelected && document.selection.has(row.id) &&
            document.selection.all().back() == row.id) {
            workspace.request = WindowRequest::None;
            renaming_ = row.id;
            focusRename_ = true;
            rename_.fill('\0');
            name.copy(rename_.data(), rename_.size() - 1);
        }
        ImGui::PopID();
    }

    /// Toggles visibility or lock of an entity; if it is selected, of all selected entities.
    static void toggleView(Document& document, ObjectId id, bool lock) {
        EntityView& view = document.view;
        const bool now = lock ? view.locks(id) : view.isHidden(id);
        const bool all = document.selection.has(id);
        for (const ObjectId each : all ? document.selection.all() : std::vector{id}) {
            lock ? view.setLocked(each, !now) : view.setHidden(each, !now);
        }
    }

    void drawContent(Ui& ui, const Row& row, const std::string& name, ImVec2 at, ImVec2 end) {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const float middle = (at.y + end.y) * 0.5f;
        if (row.parent) {
            const bool closed = tree_.isClosed(row.id);
            const ImVec2 c{at.x + ui.px(8.0f), middle};
            const float r = ui.px(3.5f);
            if (closed) {
                list.AddTriangleFilled({c.x - r * 0.6f, c.y - r}, {c.x + r, c.y}, {c.x - r * 0.6f, c.y + r},
                                       palette::kTextDim);
            } else {
                list.AddTriangleFilled({c.x - r, c.y - r * 0.6f}, {c.x + r, c.y - r * 0.6f}, {c.x, c.y + r},
                                       palette::kTextDim);
            }
        }
        const Document& document = ui.workspace.document;
        const World& world = document.world;
        const EntityId entity = document.find(row.id);
        const Icon icon = iconOf(world, entity);
        const bool faint = world.has<Hidden>(entity) || isHiddenInTree(document, row.id);
        const bool ofPrefab = world.has<PrefabInstance>(entity) || world.has<PrefabPart>(entity);
        const float top = at.y + (end.y - at.y - ImGui::GetTextLineHeight()) * 0.5f;
        list.PushClipRect(at, end, true);
        drawIcon(list, icon, {at.x + ui.px(24.0f), middle}, ui.px(13.0f),
                 faint ? palette::kTextDim : iconColor(icon));
        list.AddText({at.x + ui.px(38.0f), top},
                     faint      ? palette::kTextDim
                     : ofPrefab ? kOfPrefab
                                : palette::kText,
                     name.c_str());
        list.PopClipRect();
    }

    /// Draws the eye and the lock icon if the entity is hidden or locked, or if the row is hovered.
    static void drawIcons(Ui& ui, const Row& row, const std::string& name, ImVec2 at, bool hovered) {
        const Document& document = ui.workspace.document;
        const bool hidden = document.view.isHidden(row.id);
        const bool locked = document.view.locks(row.id);
        const float room = ui.px(kIconRoom);
        const float height = rowHeight(ui);
        const auto keyed = [&](std::string_view words, std::string_view action) {
            return hovered ? ui.workspace.settings.keys.labelOf(*findAction(action), words) : std::string{};
        };
        const auto icon = [&](Icon which, float x, bool on, const char* part, const std::string& words) {
            const AABB box{{at.x + x, at.y}, {at.x + x + room, at.y + height}};
            ui.widgets.mark(format("Scene/{}/{}", name, part), box, on ? "on" : "off");
            const Vec2 mouse{ImGui::GetMousePos().x, ImGui::GetMousePos().y};
            const bool under = hovered && contains(box, mouse);
            if (!on && !hovered) return;
            drawIcon(*ImGui::GetWindowDrawList(), which, {at.x + x + room * 0.5f, at.y + height * 0.5f},
                     ui.px(12.0f), on || under ? palette::kText : palette::kIconOff);
            if (under) tooltip(words);
        };
        icon(hidden ? Icon::EyeClosed : Icon::Eye, 0.0f, hidden, "eye",
             keyed("Hides or shows the entity in the editor only; the game still shows it", "entity.hide"));
        icon(locked ? Icon::Lock : Icon::Unlocked, room, locked, "lock",
             keyed("Locked entities ignore clicks in the viewport", "entity.lock"));
    }

    void choose(Ui& ui, const Row& row, float arrowEnd) {
        Workspace& workspace = ui.workspace;
        Selection& selection = workspace.document.selection;
        if (row.parent && ImGui::GetMousePos().x < arrowEnd) {
            tree_.setClosed(row.id, !tree_.isClosed(row.id));
            return;
        }
        const ImGuiIO& io = ImGui::GetIO();
        if (io.KeyShift) {
            chooseRange(selection, row.id, io.KeyCtrl);
        } else {
            io.KeyCtrl ? selection.toggle(row.id) : selection.set({row.id});
            rangeFrom_ = row.id;
        }
        // The clicked row is visible, so no scrolling is needed.
        shownSelection_ = selection.revision();
        if (ImGui::IsMouseDoubleClicked(0)) runAction(workspace, "view.frame");
    }

    /// Selects the rows from the row clicked last without Shift to the given one.
    void chooseRange(Selection& selection, ObjectId to, bool keepOthers) {
        if (!selection.has(rangeFrom_)) rangeFrom_ = selection.empty() ? to : selection.all().back();
        const std::vector<ObjectId> range = tree_.range(rangeFrom_, to);
        keepOthers ? selection.add(range) : selection.set(range);
    }

    static void dragFrom(const Document& document, ObjectId id, const std::string& name) {
        if (!ImGui::BeginDragDropSource()) return;
        ImGui::SetDragDropPayload(kEntityPayload, &id, sizeof id);
        const std::size_t count = document.selection.has(id) ? document.selection.size() : 1;
        ImGui::TextUnformatted(count == 1 ? name.c_str() : format("{} entities", count).c_str());
        ImGui::EndDragDropSource();
    }

    /// Accepts dragged entities.
    /// @param row  the row under the mouse; null: the space below all rows, which removes the parent
    void dropOn(Ui& ui, const Row* row) {
        if (!ui.workspace.canEdit() || !ImGui::BeginDragDropTarget()) return;
        const ImVec2 from = ImGui::GetItemRectMin();
        const ImVec2 to = ImGui::GetItemRectMax();
        const float part = (ImGui::GetMousePos().y - from.y) / std::max(to.y - from.y, 1.0f);
        const bool into = row == nullptr || tree_.filters() || (part > 0.28f && part < 0.72f);
        constexpr ImGuiDragDropFlags kOwnLook =
            ImGuiDragDropFlags_AcceptBeforeDelivery | ImGuiDragDropFlags_AcceptNoDrawDefaultRect;
        if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(kEntityPayload, kOwnLook)) {
            const Document& document = ui.workspace.document;
            ImDrawList& list = *ImGui::GetWindowDrawList();
            const float thick = ui.px(2.0f);
            const float y = part < 0.5f ? from.y : to.y;
            if (into) {
                outline(list, from, to, palette::kAccent, ui.px(3.0f), thick);
            } else {
                const float left = from.x + ui.px(16.0f) * static_cast<float>(row->depth) + ui.px(16.0f);
                list.AddCircle({left, y}, ui.px(3.0f), palette::kAccent, 0, thick);
                list.AddLine({left + ui.px(3.0f), y}, {to.x, y}, palette::kAccent, thick);
            }
            ObjectId id;
            std::memcpy(&id, payload->Data, sizeof id);
            const TreePlace place = into ? TreePlace{row == nullptr ? ObjectId{} : row->id}
                                         : placeBeside(document, *row, part > 0.5f);
            if (payload->IsDelivery())
                dropped_ =
                    Dropped{document.selection.has(id) ? document.selection.all() : std::vector{id}, place};
        }
        ImGui::EndDragDropTarget();
    }

    /// Returns the tree position above or below a row. Below an expanded parent it is before the first child.
    [[nodiscard]] TreePlace placeBeside(const Document& document, const Row& row, bool below) const {
        const std::vector<Row>& rows = tree_.rows();
        const std::size_t next = tree_.rowOf(row.id) + 1;
        if (below && next < rows.size() && rows[next].depth > row.depth)
            return {row.id, rows[next].id, false};
        return {document.idOf(parentOf(document.world, document.find(row.id))), row.id, below};
    }

    void drawRename(Ui& ui, float indent) {
        ImGui::SetCursorPosX(indent);
        ImGui::SetNextItemWidth(-1.0f);
        if (focusRename_) ImGui::SetKeyboardFocusHere();
        focusRename_ = false;
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(4.0f), ui.px(2.0f)});
        const bool done =
            ImGui::InputText("##rename", rename_.data(), rename_.size(),
                             ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
        ImGui::PopStyleVar();
        ui.widgets.mark("Scene/rename", rename_.data());
        // Esc restores the old name, but ImGui reports an edit; so the names are compared.
        const bool edited = done || ImGui::IsItemDeactivatedAfterEdit();
        if (edited && ui.workspace.document.nameOf(renaming_) != rename_.data()) {
            renameAll(ui.workspace, renaming_, rename_.data());
            ui.workspace.undo.endGesture();
        }
        if (done || ImGui::IsItemDeactivated()) renaming_ = {};
    }

    std::array<char, 128> filter_{};
    std::array<char, 256> rename_{};
    ObjectId renaming_;
    bool focusRename_ = false;
    SceneTree tree_;
    ObjectId rangeFrom_;                ///< row clicked last without Shift
    std::uint64_t shownSelection_ = 0;  ///< revision of the selection that was scrolled to

    /// Entities dropped in this frame, and their new position in the tree.
    struct Dropped {
        std::vector<ObjectId> moved;
        TreePlace place;
    };
    std::optional<Dropped> dropped_;
};

}  // namespace

std::unique_ptr<Panel> makeScenePanel() { return std::make_unique<ScenePanel>(); }

}  // namespace plumb::editor::ui
