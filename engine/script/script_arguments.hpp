#pragma once

#include "math/vec2.hpp"

struct lua_State;

namespace plumb::script {

// Arguments of functions that change the world, where a value that is not finite would spread unseen.

/// Returns the number that is argument number `index`; raises an error if it is none, or is not finite.
float checkFinite(lua_State* state, int index);
/// As checkFinite(); `otherwise` if there is no argument.
float optionalFinite(lua_State* state, int index, float otherwise);
/// Returns the vector that is argument number `index`; raises an error if it is none, or is not finite.
Vec2 checkFiniteVector(lua_State* state, int index);

}  // namespace plumb::script
