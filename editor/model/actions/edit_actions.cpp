#include <array>

#include "core/text.hpp"
#include "editor/model/actions/action_rows.hpp"
#include "editor/model/clipboard.hpp"
#include "editor/model/commands/delete_entities.hpp"
#include "editor/model/commands/place_copies.hpp"
#include "editor/model/document/prefab_root.hpp"
#include "editor/model/document/visibility.hpp"

namespace plumb::editor {
namespace {

// The label is read after undo(), which drops an open gesture that changed nothing: the step that was on top
// before is then not the one undone.
void undoStep(Workspace& w) {
    if (w.undo.undo()) w.notice = format("Undid: {}", w.undo.label(w.undo.size()));
}
void redoStep(Workspace& w) {
    if (w.undo.redo()) w.notice = format("Redid: {}", w.undo.label(w.undo.size() - 1));
}
bool canUndo(const Workspace& w) { return w.canEdit() && w.undo.size() > 0; }
bool canRedo(const Workspace& w) { return w.canEdit() && w.undo.size() < w.undo.total(); }

/// Returns "crate" or "3 entities", with the number of their descendants: "crate and 2 below it".
std::string namesOf(const Workspace& w, const std::vector<ObjectId>& ids) {
    const std::vector<ObjectId> roots = outermost(w.document, ids);
    const std::size_t below = withDescendants(w.document, roots).size() - roots.size();
    const bool one = roots.size() == 1;
    const std::string names = one ? w.document.nameOf(roots.front()) : format("{} entities", roots.size());
    return below == 0 ? names : format("{} and {} below {}", names, below, one ? "it" : "them");
}

void duplicate(Workspace& w) {
    const std::vector<ObjectId> selected = w.document.selection.all();
    const std::string names = namesOf(w, selected);
    insertCopies(w.undo, duplicateEntities(w.document, selected), withDescendants(w.document, selected));
    w.undo.endGesture();
    w.notice = format("Duplicated {}", names);
}
/// Deletes the selected entities. @param verb  for the status bar: "Deleted", "Cut"
void deleteSelected(Workspace& w, std::string_view verb) {
    std::vector<ObjectId> ids = w.document.selection.all();
    const bool root = std::erase(ids, prefabRootOf(w.document)) > 0;
    if (!ids.empty()) {
        w.notice = format("{} {}", verb, namesOf(w, ids));
        w.undo.push(std::make_unique<DeleteEntities>(std::move(ids)));
        w.undo.endGesture();
    }
    if (root) w.notice = "The root entity of an open prefab cannot be removed; it stays";
}
void remove(Workspace& w) { deleteSelected(w, "Deleted"); }
void copy(Workspace& w) {
    w.clipboard = copyAsText(w.document, w.document.selection.all());
    w.notice = format("Copied {}", namesOf(w, w.document.selection.all()));
}
void cut(Workspace& w) { copy(w), deleteSelected(w, "Cut"); }
void paste(Workspace& w) {
    Pasted pasted = pasteFromText(w.prefabs(), w.clipboard);
    if (pasted.command == nullptr) {
        w.notice = pasted.why.empty() ? "The clipboard holds no entities" : pasted.why;
        return;
    }
    insertCopies(w.undo, std::move(pasted.command), std::move(pasted.originals));
    w.undo.endGesture();
    w.notice = pasted.unpacked.empty()
                   ? format("Pasted {}", namesOf(w, w.document.selection.all()))
                   : format("Pasted as plain entities: this project has no {}", pasted.unpacked.front());
}
/// Selects all entities that are neither hidden nor locked.
void selectAll(Workspace& w) {
    std::vector<ObjectId> ids = w.document.objects();
    std::erase_if(ids, [&](ObjectId id) { return isHiddenOrLocked(w.document, id); });
    w.document.selection.set(std::move(ids));
}
void escape(Workspace& w) {
    if (w.tool().cancel(w.tools())) return;
    if (w.paintsTiles() && !w.tiles.selected.empty()) return w.tiles.selected.clear();
    w.document.selection.clear();
}

const std::array kRows{
    Action{"edit.undo", "Edit", "Undo", control(Key::Z), canUndo, undoStep},
    Action{"edit.redo", "Edit", "Redo", control(Key::Y), canRedo, redoStep, nullptr, control(Key::Z, true)},
    line("Edit"),
    Action{"edit.cut", "Edit", "Cut", control(Key::X), withSelection, cut},
    Action{"edit.copy", "Edit", "Copy", control(Key::C), anySelection, copy},
    Action{"edit.paste", "Edit", "Paste", control(Key::V), editable, paste},
    Action{"edit.duplicate", "Edit", "Duplicate", control(Key::D), withSelection, duplicate},
    Action{"edit.delete", "Edit", "Delete", {Key::Delete}, withSelection, remove, nullptr, {Key::Backspace}},
    Action{"shape.remove",
           "Edit",
           "Remove corner",
           {Key::Delete},
           [](const Workspace& w) { return editable(w) && w.hasSelectedPart(); },
           [](Workspace& w) { w.tool().removeChosen(w.tools()); },
           nullptr,
           {Key::Backspace},
           During::Entities},
    line("Edit"),
    Action{"edit.selectAll", "Edit", "Select all", control(Key::A), editable, selectAll},
    line("Edit"),
    Action{"edit.find", "Edit", "Go to...", control(Key::P), always, ask<WindowRequest::FindFile>},
    Action{"edit.commands", "Edit", "Commands...", control(Key::P, true), always,
           ask<WindowRequest::FindCommand>},
    Action{"edit.filter", "Edit", "Find in the tree", control(Key::F), always,
           [](Workspace& w) { w.panelToShow = "Scene/filter", w.settings.layout.hidden = false; }},
    Action{"edit.escape", "Edit", "Cancel or clear selection", {Key::Escape}, always, escape},
    line("Edit"),
    Action{"edit.preferences", "Edit", "Preferences...", control(Key::Comma), always,
           ask<WindowRequest::Preferences>},
    Action{"edit.keys",
           "Edit",
           "Keys...",
           {Key::F1},
           always,
           [](Workspace& w) { ask<WindowRequest::Preferences>(w), w.panelToShow = "/Preferences/Keys"; }},
};

}  // namespace

std::span<const Action> editActions() { return kRows; }

}  // namespace plumb::editor
