#pragma once

#include <array>
#include <optional>
#include <string>

#include "editor/model/actions.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The page of the preferences on which the user assigns keyboard shortcuts to actions.
class KeysPage {
public:
    void draw(Ui& ui);
    /// Handles an event while the page waits for the user to press a new shortcut.
    /// @return true if the event was used and must have no other effect
    bool take(KeyBindings& keys, const Event& event);
    /// True while the page waits for the user to press a new shortcut.
    [[nodiscard]] bool listening() const { return listening_ != nullptr; }
    /// Stops waiting for a new shortcut.
    void stop();

private:
    [[nodiscard]] bool matches(const KeyBindings& keys, const Action& action) const;  ///< search finds action
    void drawRow(Ui& ui, const Action& action);
    void drawConflict(Ui& ui);

    std::array<char, 48> search_{};      ///< text of the search field
    const Action* listening_ = nullptr;  ///< action whose new shortcut is awaited; null: none
    std::optional<Shortcut> wanted_;     ///< pressed shortcut, if another action already has it
};

}  // namespace plumb::editor::ui
