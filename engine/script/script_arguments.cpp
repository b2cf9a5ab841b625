#include "script/script_arguments.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include <lua.hpp>

#include "script/script_vector.hpp"

namespace plumb::script {
namespace {

/// Fields and functions store single precision: a larger number is infinite there.
bool fits(double number) { return std::fabs(number) <= double{std::numeric_limits<float>::max()}; }

/// "nan" of Lua has a sign that differs between machines.
const char* nameOf(double number) { return std::isnan(number) ? "nan, e.g. 0/0" : "infinity, e.g. 1/0"; }

}  // namespace

float checkFinite(lua_State* state, int index) {
    const double number = luaL_checknumber(state, index);
    if (!fits(number))
        luaL_argerror(state, index,
                      lua_pushfstring(state, "a finite number expected, got %s", nameOf(number)));
    return static_cast<float>(number);
}

float optionalFinite(lua_State* state, int index, float otherwise) {
    return lua_isnoneornil(state, index) ? otherwise : checkFinite(state, index);
}

Vec2 checkFiniteVector(lua_State* state, int index) {
    const Vec2 vector = checkVector(state, index);
    for (const auto& [name, number] : {std::pair{"x", vector.x}, std::pair{"y", vector.y}}) {
        if (!std::isfinite(number))
            luaL_argerror(state, index,
                          lua_pushfstring(state, "a finite vector expected, got one whose %s is %s", name,
                                          nameOf(double{number})));
    }
    return vector;
}

}  // namespace plumb::script
