#pragma once

#include <optional>
#include <string>

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Number field that reports a value only at the end of a drag or of typing, for values that are saved at
/// once. One object serves all number fields of a panel.
class DeferredNumber {
public:
    /// Draws the field in the current item width.
    /// @param path    widget path, for tests
    /// @param speed   change per px of a drag
    /// @param format  printf format of ImGui: "%.4g"
    /// @return        the new number, if an edit has ended and changed it
    std::optional<float> draw(Ui& ui, const std::string& path, float now, float speed, const char* format);

private:
    std::string path_;  // path of the field being edited; empty: none
    float value_ = 0.0f;
};

/// Text field that reports its text only after Enter or a click elsewhere. One object serves a panel.
class DeferredText {
public:
    /// @param path  widget path, for tests
    /// @return      the new text, if an edit has ended and changed it
    std::optional<std::string> draw(Ui& ui, const std::string& path, const std::string& now);

private:
    std::string path_;
    std::string before_;  // text of the field before the edit
    std::string text_;
};

}  // namespace plumb::editor::ui
