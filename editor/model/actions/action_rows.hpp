#pragma once

#include "editor/model/actions.hpp"
#include "editor/model/workspace.hpp"

// Each file of this folder defines the actions of one menu; actions.cpp joins them in menu order. To add an
// action, add a row to one of these tables.

namespace plumb::editor {

std::span<const Action> fileActions();
std::span<const Action> editActions();
std::span<const Action> entityActions();
std::span<const Action> arrangeActions();
std::span<const Action> toolActions();
std::span<const Action> tileActions();
std::span<const Action> viewActions();
std::span<const Action> runActions();

// Conditions under which an action is enabled.

inline bool always(const Workspace&) { return true; }
inline bool editable(const Workspace& w) { return w.canEdit() && !w.document.scenePath.empty(); }
inline bool anySelection(const Workspace& w) { return !w.document.selection.empty(); }
inline bool withSelection(const Workspace& w) { return editable(w) && anySelection(w); }

// Parts of a table row.

constexpr Shortcut control(Key key, bool shift = false) { return {key, true, shift, false}; }
constexpr Shortcut shifted(Key key) { return {key, false, true, false}; }
/// A separator line in a menu.
constexpr Action line(std::string_view menu) { return {"", menu, "", {}}; }

/// Sends a request to the window, e.g. to open a dialog.
template <WindowRequest Request>
void ask(Workspace& workspace) {
    workspace.request = Request;
}

}  // namespace plumb::editor
