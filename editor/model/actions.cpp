#include "editor/model/actions.hpp"

#include <array>

#include "core/text.hpp"
#include "editor/model/bounds.hpp"
#include "editor/model/clipboard.hpp"
#include "editor/model/commands/delete_entities.hpp"
#include "editor/model/tools/transform_drag.hpp"
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
template <WindowRequest Request>
void ask(Workspace& w) {
    w.request = Request;
}
void step(Workspace& w) {
    w.play.setPaused(true);
    w.play.step(w.gameInput ? w.gameInput() : InputFrame{});
}

bool canUndo(const Workspace& w) { return w.canEdit() && w.undo.size() > 0; }
bool canRedo(const Workspace& w) { return w.canEdit() && w.undo.size() < w.undo.total(); }
bool canPlay(const Workspace& w) { return w.play.running() || !w.document.scenePath.empty(); }
bool onInstance(const Workspace& w) { return withSelection(w) && w.selectsInstance(); }
bool painting(const Workspace& w) { return editable(w) && w.paintsTiles(); }

constexpr Shortcut control(Key key, bool shift = false) { return {key, true, shift, false}; }
constexpr Shortcut shifted(Key key) { return {key, false, true, false}; }
constexpr Action line(std::string_view menu) { return {"", menu, "", {}}; }
/// Takes the tool of this id into the hand.
constexpr Action tool(std::string_view id, std::string_view label, Key key, During during = During::Always) {
    return {id, "Tool", label, {key}, editable, nullptr, nullptr, {}, during};
}

const std::array kActions{
    Action{"file.new",
           "File",
           "New scene...",
           {Key::N, true, false, true},
           always,
           ask<WindowRequest::NameNewScene>},
    Action{"file.open", "File", "Open scene...", control(Key::O), always, ask<WindowRequest::ChooseScene>},
    Action{"file.save", "File", "Save", control(Key::S), editable,
           [](Workspace& w) { static_cast<void>(w.save().ok()); }},
    line("File"),
    Action{"file.quit", "File", "Quit", control(Key::Q), always, ask<WindowRequest::Quit>},

    Action{"edit.undo", "Edit", "Undo", control(Key::Z), canUndo, undoStep},
    Action{"edit.redo", "Edit", "Redo", control(Key::Y), canRedo, redoStep, nullptr, control(Key::Z, true)},
    line("Edit"),
    Action{"edit.cut", "Edit", "Cut", control(Key::X), withSelection, cut},
    Action{"edit.copy", "Edit", "Copy", control(Key::C), anySelection, copy},
    Action{"edit.paste", "Edit", "Paste", control(Key::V), editable, paste},
    Action{"edit.duplicate", "Edit", "Duplicate", control(Key::D), withSelection, duplicate},
    Action{"edit.delete", "Edit", "Delete", {Key::Delete}, withSelection, remove},
    line("Edit"),
    Action{"edit.selectAll", "Edit", "Select all", control(Key::A), editable,
           [](Workspace& w) { w.document.selection.set(w.document.objects()); }},
    Action{"edit.escape", "Edit", "Cancel or select nothing", {Key::Escape}, always, escape},

    Action{"entity.create", "Entity", "Create entity", control(Key::N), editable, create},
    Action{"entity.prefab", "Entity", "Add prefab...", control(Key::N, true), editable,
           ask<WindowRequest::ChoosePrefab>},
    Action{"entity.rename", "Entity", "Rename", {Key::F2}, withSelection, ask<WindowRequest::RenameSelected>},
    line("Entity"),
    Action{"entity.revert", "Entity", "Revert to prefab", control(Key::R), onInstance,
           [](Workspace& w) { w.revertToPrefab(); }},
    Action{"entity.apply", "Entity", "Apply to prefab", control(Key::R, true), onInstance,
           [](Workspace& w) { w.applyToPrefab(); }},
    line("Entity"),
    Action{"entity.left", "Entity", "Nudge left", {Key::Left}, withSelection, nudgeBy<-1, 0>},
    Action{"entity.right", "Entity", "Nudge right", {Key::Right}, withSelection, nudgeBy<1, 0>},
    Action{"entity.up", "Entity", "Nudge up", {Key::Up}, withSelection, nudgeBy<0, -1>},
    Action{"entity.down", "Entity", "Nudge down", {Key::Down}, withSelection, nudgeBy<0, 1>},
    Action{"entity.gridLeft", "Entity", "One cell left", shifted(Key::Left), withSelection, nudgeGrid<-1, 0>},
    Action{"entity.gridRight", "Entity", "One cell right", shifted(Key::Right), withSelection,
           nudgeGrid<1, 0>},
    Action{"entity.gridUp", "Entity", "One cell up", shifted(Key::Up), withSelection, nudgeGrid<0, -1>},
    Action{"entity.gridDown", "Entity", "One cell down", shifted(Key::Down), withSelection, nudgeGrid<0, 1>},

    tool("tool.select", "Select", Key::Q),
    tool("tool.move", "Move", Key::W),
    tool("tool.rotate", "Rotate", Key::E, During::Entities),
    tool("tool.scale", "Scale", Key::R),
    line("Tool"),
    tool("tool.brush", "Brush", Key::B),
    tool("tool.erase", "Eraser", Key::E, During::Tiles),
    tool("tool.rectangle", "Rectangle", Key::U),
    tool("tool.fill", "Fill", Key::G),
    tool("tool.pick", "Pick tiles", Key::I),
    line("Tool"),
    Action{"tiles.flipX",
           "Tool",
           "Flip tiles left to right",
           {Key::X},
           painting,
           [](Workspace& w) { w.tiles.stamp = flippedX(w.tiles.stamp); }},
    Action{"tiles.flipY",
           "Tool",
           "Flip tiles upside down",
           {Key::Y},
           painting,
           [](Workspace& w) { w.tiles.stamp = flippedY(w.tiles.stamp); }},
    Action{"tiles.turn",
           "Tool",
           "Turn tiles",
           {Key::Z},
           painting,
           [](Workspace& w) { w.tiles.stamp = turned(w.tiles.stamp); }},

    Action{"view.frame", "View", "Frame selection", {Key::F}, anySelection, frameSelection},
    Action{"view.all", "View", "Frame all", {Key::Home}, always, frameAll, nullptr, shifted(Key::F)},
    Action{"view.camera", "View", "Frame what the camera sees", control(Key::Home), always,
           [](Workspace& w) { w.showStart(); }},
    Action{"view.actual", "View", "Actual size", control(Key::Digit0), always,
           [](Workspace& w) { w.view.setZoom(1.0f); }},
    line("View"),
    Action{"view.snap", "View", "Snap to grid", shifted(Key::S), always,
           [](Workspace& w) { w.grid.snap = !w.grid.snap; }, [](const Workspace& w) { return w.grid.snap; }},
    line("View"),
    Action{"view.physics",
           "View",
           "Physics",
           {Key::F3},
           always,
           [](Workspace& w) { w.physics.on = !w.physics.on; },
           [](const Workspace& w) { return w.physics.on; }},
    Action{"view.larger", "View", "Larger interface", control(Key::Equals), always,
           ask<WindowRequest::LargerText>},
    Action{"view.smaller", "View", "Smaller interface", control(Key::Minus), always,
           ask<WindowRequest::SmallerText>},

    Action{"run.play", "Run", "Play", {Key::F5}, canPlay, [](Workspace& w) { w.togglePlay(); }, running},
    Action{"run.pause",
           "Run",
           "Pause",
           {Key::F6},
           running,
           [](Workspace& w) { w.play.setPaused(!w.play.paused()); },
           [](const Workspace& w) { return w.play.paused(); }},
    Action{"run.step", "Run", "Step one tick", {Key::F10}, running, step},
};

bool counts(During during, const Workspace& w) {
    return during == During::Always || (during == During::Tiles) == w.paintsTiles();
}

}  // namespace

std::span<const Action> actionTable() { return kActions; }

const Action* findAction(std::string_view id) {
    for (const Action& action : kActions) {
        if (action.id == id) return &action;
    }
    return nullptr;
}

bool runAction(Workspace& workspace, std::string_view id) {
    const Action* action = id.empty() ? nullptr : findAction(id);
    if (action == nullptr || !action->enabled(workspace)) return false;
    if (action->run == nullptr) {
        workspace.useTool(action->id);
    } else {
        action->run(workspace);
    }
    return true;
}

bool isOn(const Action& action, const Workspace& workspace) {
    if (action.on != nullptr) return action.on(workspace);
    return action.run == nullptr && toolTable()[workspace.toolIndex()].action == action.id;
}

bool runShortcut(Workspace& workspace, const Event& event) {
    for (const Action& action : kActions) {
        if (!counts(action.during, workspace)) continue;
        if (action.shortcut.matches(event) || action.alternative.matches(event)) {
            return runAction(workspace, action.id);
        }
    }
    return false;
}

}  // namespace plumb::editor
