#pragma once

#include <string>

#include "editor/model/actions.hpp"

namespace plumb::editor {

/// Returns the heading of an action in the list of all actions: its menu, or the capitalized prefix of its id
/// ("tiles.keep1": "Tiles") for an action that is in no menu.
std::string groupOf(const Action& action);

}  // namespace plumb::editor
