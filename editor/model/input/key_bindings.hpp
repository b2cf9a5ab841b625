#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "editor/model/input/shortcut.hpp"
#include "reflect/json_fwd.hpp"

namespace plumb::editor {

struct Action;

/// Parses a key combination such as "Ctrl+Shift+Z". @return nothing if the text is not a valid combination
std::optional<Shortcut> shortcutFromText(std::string_view text);

/// The keyboard shortcuts of all actions: the defaults of the action table, overridden by those the user set.
class KeyBindings {
public:
    /// Returns all shortcuts of an action; the first one is shown in menus and tooltips.
    [[nodiscard]] std::vector<Shortcut> of(const Action& action) const;
    /// Returns the shortcut shown in menus and tooltips; `Key::None` if the action has none.
    [[nodiscard]] Shortcut shownOf(const Action& action) const;
    [[nodiscard]] bool matches(const Action& action, const Event& event) const;
    /// Returns the label followed by the keys, e.g. "Undo  (Ctrl+Z)", for tooltips.
    [[nodiscard]] std::string labelOf(const Action& action) const { return labelOf(action, {}); }
    /// @param label  replaces the action's own label; empty: the action's own
    [[nodiscard]] std::string labelOf(const Action& action, std::string_view label) const;

    /// Assigns the keys to this action, and removes them from every conflicting action.
    void bind(const Action& action, Shortcut keys);
    void unbind(const Action& action);
    void reset(const Action& action);  ///< restores the default shortcuts
    void resetAll() { chosen_.clear(); }
    [[nodiscard]] bool isChanged(const Action& action) const;
    [[nodiscard]] bool anyChanged() const { return !chosen_.empty(); }
    /// Returns another action that has these keys and is available at the same time, so that the keys would
    /// be ambiguous; null if there is none.
    [[nodiscard]] const Action* conflict(const Action& action, Shortcut keys) const;

    [[nodiscard]] Json toJson() const;
    /// Reports and skips unknown actions and invalid keys.
    static KeyBindings fromJson(const Json& json, const std::string& where, std::vector<Error>& problems);

    friend bool operator==(const KeyBindings& a, const KeyBindings& b) { return a.chosen_ == b.chosen_; }

private:
    std::map<std::string, std::vector<Shortcut>, std::less<>> chosen_;  ///< user's shortcuts by action id
};

}  // namespace plumb::editor
