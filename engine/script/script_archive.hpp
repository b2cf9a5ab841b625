#pragma once

struct lua_State;

namespace plumb {

class World;
struct ScriptState;

namespace script {

/// Makes the scripts what they were when the game was saved, from ScriptState::saved, which becomes empty. A
/// script has the values of its `self`, and a file those of its local and global variables; onCreate() is not
/// called. To be called when all files are loaded. @return false if the saved values are damaged
bool takeSaved(lua_State* state, World& world, ScriptState& scripts);

}  // namespace script
}  // namespace plumb
