#pragma once

#include <optional>
#include <string>

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// A number of which only the end of a drag, or of typing, counts: for what is written into a file at once.
/// One for a panel.
class HeldNumber {
public:
    /// Draws it as wide as the next item is to be.
    /// @param path    how tests call it
    /// @param speed   by how much one px of a drag changes it
    /// @param format  as ImGui wants it: "%.4g"
    /// @return        the number that was let go, if it is another one
    std::optional<float> draw(Ui& ui, const std::string& path, float now, float speed, const char* format);

private:
    std::string path_;  // what is dragged; empty: nothing
    float value_ = 0.0f;
};

/// A name that counts when Enter is pressed or another thing is clicked. One for a panel.
class HeldText {
public:
    /// @param path  how tests call it
    /// @return      what was typed, if it is something else
    std::optional<std::string> draw(Ui& ui, const std::string& path, const std::string& now);

private:
    std::string path_;
    std::string before_;  // what stood there when typing began
    std::string text_;
};

}  // namespace plumb::editor::ui
