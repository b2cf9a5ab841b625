#include <array>

#include "editor/model/actions/action_rows.hpp"
#include "editor/model/commands/insert_entities.hpp"
#include "editor/model/tools/transform_drag.hpp"

namespace plumb::editor {
namespace {

void create(Workspace& w) {
    const Vec2 at = snapped(w.view.view().center, w.grid.size);
    w.undo.push(createEntity(w.document, "new entity", at));
    w.undo.endGesture();
}
template <int X, int Y>
void nudgeBy(Workspace& w) {
    nudge(w.tools(), {static_cast<float>(X), static_cast<float>(Y)});
}
template <int X, int Y>
void nudgeGrid(Workspace& w) {
    nudge(w.tools(), scaled({static_cast<float>(X), static_cast<float>(Y)}, w.grid.size));
}
bool onInstance(const Workspace& w) { return withSelection(w) && w.selectsInstance(); }

const std::array kRows{
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
};

}  // namespace

std::span<const Action> entityActions() { return kRows; }

}  // namespace plumb::editor
