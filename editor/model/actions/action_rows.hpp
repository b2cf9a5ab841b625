#pragma once

#include "editor/model/actions.hpp"
#include "editor/model/workspace.hpp"

// One file per menu gives its rows; actions.cpp puts them together in the order of the menus. A new action is
// one row in one of them.

namespace plumb::editor {

std::span<const Action> fileActions();
std::span<const Action> editActions();
std::span<const Action> entityActions();
std::span<const Action> arrangeActions();
std::span<const Action> toolActions();
std::span<const Action> tileActions();
std::span<const Action> viewActions();
std::span<const Action> runActions();

// When a row can be chosen.

inline bool always(const Workspace&) { return true; }
inline bool editable(const Workspace& w) { return w.canEdit() && !w.document.scenePath.empty(); }
inline bool anySelection(const Workspace& w) { return !w.document.selection.empty(); }
inline bool withSelection(const Workspace& w) { return editable(w) && anySelection(w); }

// What a row says.

constexpr Shortcut control(Key key, bool shift = false) { return {key, true, shift, false}; }
constexpr Shortcut shifted(Key key) { return {key, false, true, false}; }
/// A line between two groups of a menu.
constexpr Action line(std::string_view menu) { return {"", menu, "", {}}; }

/// Asks the window for what only it can do.
template <WindowRequest Request>
void ask(Workspace& workspace) {
    workspace.request = Request;
}

}  // namespace plumb::editor
