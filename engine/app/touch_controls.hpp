#pragma once

#include <string>

#include "input/input.hpp"

namespace plumb {

/// Returns the buttons that a page shows on a touch screen, as JSON: {"axes": [{"name": "Horizontal",
/// "negative":
/// {"key": "Left", "usage": 80}, "positive": {…}}, …], "actions": [{"name": "Jump", "key": "Space", "usage":
/// 44}, …]}, in the order of the map. A button presses the first key that is bound, `usage` is its USB usage
/// code. Left out: what has no key, and actions whose key another one of them has, too.
std::string touchControls(const ActionMap& map, const Input::Asked& asked);

/// The buttons that a page shows now.
class TouchControls {
public:
    /// Follows what the game has asked for since the last look, and its keys.
    /// @return true if the page needs others
    bool look(Input& input);
    [[nodiscard]] const std::string& text() const { return text_; }  ///< see touchControls()

private:
    std::string text_;
};

}  // namespace plumb
