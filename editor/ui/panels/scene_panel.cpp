#include <algorithm>
#include <array>
#include <map>

#include "ecs/hierarchy.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/commands/reparent.hpp"
#include "editor/model/entity_state.hpp"
#include "editor/ui/icons.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/empty_state.hpp"
#include "editor/ui/widgets/pickers.hpp"
#include "scene/components/hidden.hpp"

namespace plumb::editor::ui {
namespace {

constexpr const char* kDragKind = "plumb.entity";

/// The entities of the scene as a tree.
class ScenePanel final : public Panel {
public:
    void draw(Ui& ui) override {
        const Document& document = ui.workspace.document;
        ImGui::SetNextItemWidth(-1.0f);
        ImGui::InputTextWithHint("##filter", "Filter by name or component", filter_.data(), filter_.size());
        ui.widgets.mark("Scene/filter", filter_.data());
        ImGui::Dummy({0.0f, ui.px(1.0f)});
        beginChild("tree", {0.0f, 0.0f}, false);
        if (document.scenePath.empty()) {
            emptyState(ui, "Scene", "No scene is open.", "", {"file.open", "file.new"});
        } else if (document.objectCount() == 0) {
            emptyState(ui, "Scene", "This scene is empty.",
                       "Files dragged from the assets into the scene become entities, too.",
                       {"entity.create", "entity.prefab"});
        } else {
            drawTree(ui);
        }
        ImGui::EndChild();
    }

private:
    void drawTree(Ui& ui) {
        const Selection& selection = ui.workspace.document.selection;
        const bool moved = std::exchange(shownSelection_, selection.revision()) != selection.revision();
        if (moved && !selection.empty()) openParents(ui.workspace.document, selection.all().back());
        collect(ui.workspace.document);
        if (moved && !selection.empty()) scrollTo(ui, selection.all().back());
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(rows_.size()), rowHeight(ui));
        while (clipper.Step()) {
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                drawRow(ui, rows_[static_cast<std::size_t>(i)]);
            }
        }
        const ImVec2 rest = ImGui::GetContentRegionAvail();
        if (rest.y > 4.0f && ImGui::InvisibleButton("below", {rest.x, rest.y}))
            ui.workspace.document.selection.clear();
        dropOn(ui, {});
    }

    void openParents(const Document& document, ObjectId id) {
        for (EntityId at = parentOf(document.world, document.find(id)); at;
             at = parentOf(document.world, at)) {
            closed_.erase(document.idOf(at));
        }
    }

    /// Brings a row into sight that was selected elsewhere.
    void scrollTo(const Ui& ui, ObjectId id) const {
        const auto row =
            std::find_if(rows_.begin(), rows_.end(), [&](const Row& item) { return item.id == id; });
        if (row == rows_.end()) return;
        const float top = rowHeight(ui) * static_cast<float>(row - rows_.begin());
        const float room = ImGui::GetWindowHeight();
        if (top < ImGui::GetScrollY() || top + rowHeight(ui) > ImGui::GetScrollY() + room)
            ImGui::SetScrollY(top - room * 0.5f);
    }

    struct Row {
        ObjectId id;
        int depth = 0;
        bool parent = false;
    };

    [[nodiscard]] static float rowHeight(const Ui& ui) { return ui.px(22.0f); }

    /// The rows of the tree in order, flat, so that only those in sight are drawn.
    void collect(const Document& document) {
        std::map<ObjectId, std::vector<ObjectId>> children;
        const bool filtering = filter_[0] != '\0';
        rows_.clear();
        for (const ObjectId id : document.objects()) {
            const ObjectId parent = document.idOf(parentOf(document.world, document.find(id)));
            if (!filtering) {
                children[parent].push_back(id);
            } else if (matches(document, id)) {
                rows_.push_back({id, 0, false});
            }
        }
        if (!filtering) addRows(children, {}, 0);
    }

    [[nodiscard]] bool matches(const Document& document, ObjectId id) const {
        if (containsWord(document.nameOf(id), filter_.data())) return true;
        for (const TypeInfo& type : document.types().all()) {
            if (document.world.has(type, document.find(id)) && containsWord(type.name, filter_.data()))
                return true;
        }
        return false;
    }

    void addRows(const std::map<ObjectId, std::vector<ObjectId>>& children, ObjectId parent, int depth) {
        const auto found = children.find(parent);
        if (found == children.end()) return;
        for (const ObjectId id : found->second) {
            const bool isParent = children.find(id) != children.end();
            rows_.push_back({id, depth, isParent});
            if (isParent && closed_.count(id) == 0) addRows(children, id, depth + 1);
        }
    }

    void drawRow(Ui& ui, const Row& row) {
        Workspace& workspace = ui.workspace;
        Document& document = workspace.document;
        const EntityId entity = document.find(row.id);
        const std::string name = document.nameOf(row.id);
        ImGui::PushID(static_cast<int>(row.id.value));
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float height = rowHeight(ui);
        const float indent = ui.px(16.0f) * static_cast<float>(row.depth);
        if (row.id == renaming_) {
            drawRename(ui, indent + ui.px(38.0f));
            ImGui::PopID();
            return;
        }
        const ImVec2 spacing = ImGui::GetStyle().ItemSpacing;
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {spacing.x, 0.0f});
        const bool clicked = ImGui::Selectable("##row", document.selection.has(row.id),
                                               ImGuiSelectableFlags_AllowDoubleClick, {0.0f, height});
        ImGui::PopStyleVar();
        ui.widgets.mark("Scene/" + name, name);
        if (clicked) choose(ui, row, at.x + indent + ui.px(16.0f));
        if (ImGui::IsItemClicked(ImGuiMouseButton_Right) && !document.selection.has(row.id))
            document.selection.set({row.id});
        if (ImGui::BeginPopupContextItem("menu")) {
            selectionMenu(ui, "Scene/menu");
            ImGui::EndPopup();
        }
        dragFrom(row.id, name);
        dropOn(ui, row.id);
        drawContent(ui, row, entity, name, {at.x + indent, at.y}, height);
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

    void drawContent(Ui& ui, const Row& row, EntityId entity, const std::string& name, ImVec2 at,
                     float height) {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const float middle = at.y + height * 0.5f;
        if (row.parent) {
            const bool closed = closed_.count(row.id) > 0;
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
        const Icon icon = iconOf(document.world, entity);
        drawIcon(list, icon, {at.x + ui.px(24.0f), middle}, ui.px(13.0f), iconColor(icon));
        const bool hidden = document.world.has<Hidden>(entity);
        const float top = at.y + (height - ImGui::GetTextLineHeight()) * 0.5f;
        list.AddText({at.x + ui.px(38.0f), top}, hidden ? palette::kTextDim : palette::kText, name.c_str());
    }

    void choose(Ui& ui, const Row& row, float arrowEnd) {
        Workspace& workspace = ui.workspace;
        Selection& selection = workspace.document.selection;
        if (row.parent && ImGui::GetMousePos().x < arrowEnd) {
            if (closed_.erase(row.id) == 0) closed_[row.id] = true;
            return;
        }
        const ImGuiIO& io = ImGui::GetIO();
        if (io.KeyCtrl) {
            selection.toggle(row.id);
        } else if (io.KeyShift) {
            addRange(selection, row.id);
        } else {
            selection.set({row.id});
        }
        if (ImGui::IsMouseDoubleClicked(0)) runAction(workspace, "view.frame");
    }

    void addRange(Selection& selection, ObjectId to) const {
        if (selection.empty()) return selection.add(to);
        bool inside = false;
        const ObjectId from = selection.all().back();
        for (const Row& row : rows_) {
            const bool edge = row.id == from || row.id == to;
            if (inside || edge) selection.add(row.id);
            if (edge && from != to) inside = !inside;
        }
    }

    static void dragFrom(ObjectId id, const std::string& name) {
        if (!ImGui::BeginDragDropSource()) return;
        ImGui::SetDragDropPayload(kDragKind, &id, sizeof id);
        ImGui::TextUnformatted(name.c_str());
        ImGui::EndDragDropSource();
    }

    static void dropOn(Ui& ui, ObjectId parent) {
        if (!ui.workspace.canEdit() || !ImGui::BeginDragDropTarget()) return;
        if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(kDragKind)) {
            ObjectId id;
            std::memcpy(&id, payload->Data, sizeof id);
            std::vector<ObjectId> moved{id};
            if (ui.workspace.document.selection.has(id)) moved = ui.workspace.document.selection.all();
            const KeepPlace keep = ImGui::GetIO().KeyAlt ? KeepPlace::InParent : KeepPlace::InWorld;
            ui.workspace.undo.push(
                std::make_unique<Reparent>(outermost(ui.workspace.document, moved), parent, keep));
            ui.workspace.undo.endGesture();
        }
        ImGui::EndDragDropTarget();
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
        if (done || ImGui::IsItemDeactivatedAfterEdit()) {
            ui.workspace.undo.push(renameEntity(ui.workspace.document, renaming_, rename_.data()));
            ui.workspace.undo.endGesture();
        }
        if (done || ImGui::IsItemDeactivated()) renaming_ = {};
    }

    std::array<char, 128> filter_{};
    std::array<char, 256> rename_{};
    ObjectId renaming_;
    bool focusRename_ = false;
    std::map<ObjectId, bool> closed_;
    std::uint64_t shownSelection_ = 0;  ///< revision
    std::vector<Row> rows_;
};

}  // namespace

std::unique_ptr<Panel> makeScenePanel() { return std::make_unique<ScenePanel>(); }

}  // namespace plumb::editor::ui
