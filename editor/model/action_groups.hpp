#pragma once

#include <string>

#include "editor/model/actions.hpp"

namespace plumb::editor {

/// Where an action stands in a list of all of them: by its menu, or by its kind when it stands in none.
std::string groupOf(const Action& action);

}  // namespace plumb::editor
