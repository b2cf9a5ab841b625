#pragma once

#include "math/vec2.hpp"

struct lua_State;

namespace plumb::script {

/// Adds `vec(x, y)` to a new state: vectors are values, so their x and y cannot be assigned. They have +, -,
/// *,
/// /, ==, and the functions length, normalized, dot, cross, distance, rotated, lerp and angle.
void addVectors(lua_State* state);

void pushVector(lua_State* state, Vec2 value);
/// Returns the vector at an index, or null if the value is none.
const Vec2* vectorAt(lua_State* state, int index);
/// Returns the vector that is argument number `index`; raises an error if it is none.
Vec2 checkVector(lua_State* state, int index);

}  // namespace plumb::script
