#pragma once

#include <string>

namespace plumb {

/// Shows a message in a window of its own, and waits until the user has closed it. For errors before the game
/// has a window. Returns false without a display.
bool showMessage(const std::string& title, const std::string& text);

}  // namespace plumb
