#pragma once

#include <string>
#include <string_view>

namespace plumb {

class World;

/// Appends the key of an action, or both keys of an axis, e.g. "Left/Right", as the player has them now: the
/// first key of the list; without keys the first button or stick; "none" if the list is empty.
/// @return false if the game has neither an action nor an axis of this name
bool appendKey(const World& world, std::string_view name, std::string& out);

}  // namespace plumb
