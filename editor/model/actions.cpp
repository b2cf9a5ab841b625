#include "editor/model/actions.hpp"

#include <array>

#include "core/text.hpp"
#include "editor/model/bounds.hpp"
#include "editor/model/clipboard.hpp"
#include "editor/model/commands/delete_entities.hpp"
#include "editor/model/tools/move_tool.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor {
namespace {

bool always(const Workspace&) { return true; }
bool editable(const Workspace& w) { return w.canEdit() && !w.document.scenePath.empty(); }
bool withSelection(const Workspace& w) { return editable(w) && !w.document.selection.empty(); }
bool anySelection(const Workspace& w) { return !w.document.selection.empty(); }
bool running(const Workspace& w) { return w.play.running(); }

void duplicate(Workspace& w) {
    w.undo.push(duplicateEntities(w.document, w.document.selection.all())), w.undo.endGesture();
}
void remove(Workspace& w) {
    w.undo.push(std::make_unique<DeleteEntities>(w.document.selection.all()));
    w.undo.endGesture();
}
void copy(Workspace& w) { w.clipboard = copyAsText(w.document, w.document.selection.all()); }
void cut(Workspace& w) { copy(w), remove(w); }
void paste(Workspace& w) {
    if (auto command = pasteFromText(w.document, w.clipboard)) {
        w.undo.push(std::move(command));
        w.undo.endGesture();
    } else {
        w.notice = "The clipboard holds no entities";
    }
}
void create(Workspace& w) {
    const Vec2 at = snapped(w.view.view().center, w.grid.size);
    w.undo.push(createEntity(w.document, "new entity", at));
    w.undo.endGesture();
}
void undoStep(Workspace& w) {
    const std::size_t step = w.undo.size();
    if (w.undo.undo()) w.notice = format("Undid: {}", w.undo.label(step - 1));
}
void redoStep(Workspace& w) {
    const std::size_t step = w.undo.size();
    if (w.undo.redo()) w.notice = format("Redid: {}", w.undo.label(step));
}
void frameSelection(Workspace& w) {
    if (const auto box = boundsOf(w.document, w.document.selection.all())) w.view.frame(*box);
}
void frameAll(Workspace& w) {
    if (const auto box = boundsOf(w.document, w.document.objects())) w.view.frame(*box);
}
void escape(Workspace& w) {
    if (!w.tool().cancel(w.tools())) w.document.selection.clear();
}
template <int X, int Y>
void nudgeBy(Workspace& w) {
    nudge(w.tools(), {static_cast<float>(X), static_cast<float>(Y)});
}
template <int X, int Y>
void nudgeGrid(Workspace& w) {
    nudge(w.tools(), scaled({static_cast<float>(X), static_cast<float>(Y)}, w.grid.size));
}

constexpr Shortcut control(Key key, bool shift = false) { return {key, true, shift, false}; }

const std::array kActions{
    Action{"file.open",
           "File",
           "Open scene...",
           control(Key::O),
           {},
           always,
           [](Workspace& w) { w.request = WindowRequest::ChooseScene; }},
    Action{"file.save",
           "File",
           "Save",
           control(Key::S),
           {},
           editable,
           [](Workspace& w) { static_cast<void>(w.save().ok()); }},
    Action{"file.quit",
           "File",
           "Quit",
           control(Key::Q),
           {},
           always,
           [](Workspace& w) { w.request = WindowRequest::Quit; }},

    Action{"edit.undo",
           "Edit",
           "Undo",
           control(Key::Z),
           {},
           [](const Workspace& w) { return w.canEdit() && w.undo.size() > 0; },
           undoStep},
    Action{"edit.redo", "Edit", "Redo", control(Key::Y), control(Key::Z, true),
           [](const Workspace& w) { return w.canEdit() && w.undo.size() < w.undo.total(); }, redoStep},
    Action{"edit.cut", "Edit", "Cut", control(Key::X), {}, withSelection, cut},
    Action{"edit.copy", "Edit", "Copy", control(Key::C), {}, anySelection, copy},
    Action{"edit.paste", "Edit", "Paste", control(Key::V), {}, editable, paste},
    Action{"edit.duplicate", "Edit", "Duplicate", control(Key::D), {}, withSelection, duplicate},
    Action{"edit.delete", "Edit", "Delete", {Key::Delete}, {}, withSelection, remove},
    Action{"edit.selectAll",
           "Edit",
           "Select all",
           control(Key::A),
           {},
           always,
           [](Workspace& w) { w.document.selection.set(w.document.objects()); }},
    Action{"edit.escape", "", "Cancel", {Key::Escape}, {}, always, escape},

    Action{"entity.create", "Entity", "Create entity", control(Key::N), {}, editable, create},
    Action{"entity.rename",
           "Entity",
           "Rename",
           {Key::F2},
           {},
           withSelection,
           [](Workspace& w) { w.request = WindowRequest::RenameSelected; }},
    Action{"entity.left", "", "Nudge left", {Key::Left}, {}, withSelection, nudgeBy<-1, 0>},
    Action{"entity.right", "", "Nudge right", {Key::Right}, {}, withSelection, nudgeBy<1, 0>},
    Action{"entity.up", "", "Nudge up", {Key::Up}, {}, withSelection, nudgeBy<0, -1>},
    Action{"entity.down", "", "Nudge down", {Key::Down}, {}, withSelection, nudgeBy<0, 1>},
    Action{"entity.gridLeft",
           "",
           "One step left",
           {Key::Left, false, true},
           {},
           withSelection,
           nudgeGrid<-1, 0>},
    Action{"entity.gridRight",
           "",
           "One step right",
           {Key::Right, false, true},
           {},
           withSelection,
           nudgeGrid<1, 0>},
    Action{"entity.gridUp", "", "One step up", {Key::Up, false, true}, {}, withSelection, nudgeGrid<0, -1>},
    Action{
        "entity.gridDown", "", "One step down", {Key::Down, false, true}, {}, withSelection, nudgeGrid<0, 1>},

    Action{"tool.select",
           "Tool",
           "Select",
           {Key::Q},
           {},
           editable,
           [](Workspace& w) { w.useTool("tool.select"); }},
    Action{"tool.move", "Tool", "Move", {Key::W}, {}, editable, [](Workspace& w) { w.useTool("tool.move"); }},
    Action{
        "tool.brush", "Tool", "Brush", {Key::B}, {}, editable, [](Workspace& w) { w.useTool("tool.brush"); }},
    Action{
        "tool.erase", "Tool", "Erase", {Key::E}, {}, editable, [](Workspace& w) { w.useTool("tool.erase"); }},
    Action{"tool.fill", "Tool", "Fill", {Key::G}, {}, editable, [](Workspace& w) { w.useTool("tool.fill"); }},

    Action{"view.frame", "View", "Frame selection", {Key::F}, {}, anySelection, frameSelection},
    Action{"view.all", "View", "Frame all", {Key::F, false, true}, {}, always, frameAll},
    Action{"view.actual",
           "View",
           "Actual size",
           control(Key::Digit0),
           {},
           always,
           [](Workspace& w) { w.view.setZoom(1.0f); }},
    Action{"view.snap",
           "View",
           "Snap to grid",
           {Key::S, false, true},
           {},
           always,
           [](Workspace& w) { w.grid.snap = !w.grid.snap; },
           [](const Workspace& w) { return w.grid.snap; }},
    Action{"view.larger",
           "View",
           "Larger interface",
           control(Key::Equals),
           {},
           always,
           [](Workspace& w) { w.request = WindowRequest::LargerText; }},
    Action{"view.smaller",
           "View",
           "Smaller interface",
           control(Key::Minus),
           {},
           always,
           [](Workspace& w) { w.request = WindowRequest::SmallerText; }},

    Action{"run.play",
           "Run",
           "Play",
           {Key::F5},
           {},
           [](const Workspace& w) { return w.play.running() || !w.document.scenePath.empty(); },
           [](Workspace& w) { w.togglePlay(); },
           running},
    Action{"run.pause",
           "Run",
           "Pause",
           {Key::F6},
           {},
           running,
           [](Workspace& w) { w.play.setPaused(!w.play.paused()); },
           [](const Workspace& w) { return w.play.paused(); }},
    Action{"run.step",
           "Run",
           "Step one tick",
           {Key::F10},
           {},
           running,
           [](Workspace& w) {
               w.play.setPaused(true), w.play.step(w.gameInput ? w.gameInput() : InputFrame{});
           }},
};

}  // namespace

std::span<const Action> actionTable() { return kActions; }

const Action* findAction(std::string_view id) {
    for (const Action& action : kActions) {
        if (action.id == id) return &action;
    }
    return nullptr;
}

bool runAction(Workspace& workspace, std::string_view id) {
    const Action* action = findAction(id);
    if (action == nullptr || !action->enabled(workspace)) return false;
    action->run(workspace);
    return true;
}

bool runShortcut(Workspace& workspace, const Event& event) {
    for (const Action& action : kActions) {
        if (action.shortcut.matches(event) || action.alternative.matches(event)) {
            return runAction(workspace, action.id);
        }
    }
    return false;
}

}  // namespace plumb::editor
