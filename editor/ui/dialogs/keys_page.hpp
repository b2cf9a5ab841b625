#pragma once

#include <array>
#include <optional>
#include <string>

#include "editor/model/actions.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The page of the preferences on which a person says which keys do what.
class KeysPage {
public:
    void draw(Ui& ui);
    /// While it waits for keys to be pressed, they are for nothing else. @return whether it took them
    bool take(KeyBindings& keys, const Event& event);
    [[nodiscard]] bool listening() const { return listening_ != nullptr; }
    void stop();

private:
    [[nodiscard]] bool matches(const KeyBindings& keys, const Action& action) const;
    void drawRow(Ui& ui, const Action& action);
    void drawConflict(Ui& ui);

    std::array<char, 48> search_{};
    const Action* listening_ = nullptr;  ///< its keys are to be pressed
    std::optional<Shortcut> wanted_;     ///< these were, and they do something else by now
};

}  // namespace plumb::editor::ui
