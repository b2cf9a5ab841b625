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

/// "Ctrl+Shift+Z" as keys, and nothing for what is none.
std::optional<Shortcut> shortcutFromText(std::string_view text);

/// Which keys do what: those of the table of actions, and what a person chose instead.
class KeyBindings {
public:
    /// The keys of an action, the ones that are shown first.
    [[nodiscard]] std::vector<Shortcut> of(const Action& action) const;
    /// The first of them.
    [[nodiscard]] Shortcut shownOf(const Action& action) const;
    [[nodiscard]] bool matches(const Action& action, const Event& event) const;
    /// The label with the keys behind it, "Undo  (Ctrl+Z)", for tooltips.
    [[nodiscard]] std::string labelOf(const Action& action) const { return labelOf(action, {}); }
    /// @param label  another one than the action's own
    [[nodiscard]] std::string labelOf(const Action& action, std::string_view label) const;

    /// Takes the keys for this action, and away from whatever else they would do at the same time.
    void bind(const Action& action, Shortcut keys);
    void unbind(const Action& action);
    void reset(const Action& action);
    void resetAll() { chosen_.clear(); }
    [[nodiscard]] bool isChanged(const Action& action) const;
    [[nodiscard]] bool anyChanged() const { return !chosen_.empty(); }
    /// What else these keys do when this action counts; null: nothing.
    [[nodiscard]] const Action* conflict(const Action& action, Shortcut keys) const;

    [[nodiscard]] Json toJson() const;
    /// Actions that are no more and keys that are none are reported and left out.
    static KeyBindings fromJson(const Json& json, const std::string& where, std::vector<Error>& problems);

    friend bool operator==(const KeyBindings& a, const KeyBindings& b) { return a.chosen_ == b.chosen_; }

private:
    std::map<std::string, std::vector<Shortcut>, std::less<>> chosen_;  ///< by the action's id
};

}  // namespace plumb::editor
