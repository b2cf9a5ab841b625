#include "script/script_vector.hpp"

#include <lua.hpp>

#include "core/text.hpp"
#include "math/angle.hpp"
#include "script/library/work.hpp"

namespace plumb::script {
namespace {

constexpr const char* kVector = "vec";

float checkFloat(lua_State* state, int index) { return static_cast<float>(luaL_checknumber(state, index)); }

int makeVector(lua_State* state) {
    pushVector(state, {checkFloat(state, 1), checkFloat(state, 2)});
    return 1;
}

int add(lua_State* state) {
    pushVector(state, checkVector(state, 1) + checkVector(state, 2));
    return 1;
}
int subtract(lua_State* state) {
    pushVector(state, checkVector(state, 1) - checkVector(state, 2));
    return 1;
}
int multiply(lua_State* state) {
    if (lua_type(state, 1) == LUA_TNUMBER) {
        pushVector(state, checkVector(state, 2) * checkFloat(state, 1));
    } else {
        pushVector(state, checkVector(state, 1) * checkFloat(state, 2));
    }
    return 1;
}
int divide(lua_State* state) {
    pushVector(state, checkVector(state, 1) / checkFloat(state, 2));
    return 1;
}
int negate(lua_State* state) {
    pushVector(state, -checkVector(state, 1));
    return 1;
}
int equals(lua_State* state) {
    const Vec2* a = vectorAt(state, 1);
    const Vec2* b = vectorAt(state, 2);
    lua_pushboolean(state, a != nullptr && b != nullptr && *a == *b ? 1 : 0);
    return 1;
}

int lengthOf(lua_State* state) {
    lua_pushnumber(state, length(checkVector(state, 1)));
    return 1;
}
int normalizedOf(lua_State* state) {
    pushVector(state, normalized(checkVector(state, 1)));
    return 1;
}
int dotOf(lua_State* state) {
    lua_pushnumber(state, dot(checkVector(state, 1), checkVector(state, 2)));
    return 1;
}
int crossOf(lua_State* state) {
    lua_pushnumber(state, cross(checkVector(state, 1), checkVector(state, 2)));
    return 1;
}
int distanceOf(lua_State* state) {
    lua_pushnumber(state, distance(checkVector(state, 1), checkVector(state, 2)));
    return 1;
}
int rotatedOf(lua_State* state) {
    pushVector(state, rotated(checkVector(state, 1), checkFloat(state, 2)));
    return 1;
}
int angleOfVector(lua_State* state) {
    const Vec2 v = checkVector(state, 1);
    lua_pushnumber(state, arcTangent(v.y, v.x));
    return 1;
}
int lerpOf(lua_State* state) {
    pushVector(state, lerp(checkVector(state, 1), checkVector(state, 2), checkFloat(state, 3)));
    return 1;
}

int toText(lua_State* state) {
    const Vec2 v = checkVector(state, 1);
    {
        const std::string text = format("({}, {})", v.x, v.y);
        lua_pushlstring(state, text.data(), text.size());
    }
    return 1;
}

/// The upvalue is the table of functions.
int index(lua_State* state) {
    const auto* vector = static_cast<const Vec2*>(lua_touserdata(state, 1));
    std::size_t size = 0;
    const char* name = lua_type(state, 2) == LUA_TSTRING ? lua_tolstring(state, 2, &size) : nullptr;
    if (size == 1 && (name[0] == 'x' || name[0] == 'y')) {
        lua_pushnumber(state, name[0] == 'x' ? vector->x : vector->y);
        return 1;
    }
    lua_pushvalue(state, 2);
    lua_rawget(state, lua_upvalueindex(1));
    return 1;
}

int refuseChange(lua_State* state) {
    return luaL_error(state,
                      "a vector cannot be changed: instead of body.velocity.x = 3 write body.velocity = "
                      "vec(3, body.velocity.y)");
}

constexpr luaL_Reg kOperators[] = {
    {"__add", add},    {"__sub", subtract}, {"__mul", multiply},          {"__div", divide},
    {"__unm", negate}, {"__eq", equals},    {"__newindex", refuseChange}, {"__tostring", toText},
    {nullptr, nullptr}};

constexpr luaL_Reg kFunctions[] = {{"length", lengthOf}, {"normalized", normalizedOf}, {"dot", dotOf},
                                   {"cross", crossOf},   {"distance", distanceOf},     {"rotated", rotatedOf},
                                   {"lerp", lerpOf},     {"angle", angleOfVector},     {nullptr, nullptr}};

}  // namespace

void addVectors(lua_State* state) {
    luaL_newmetatable(state, kVector);
    luaL_setfuncs(state, kOperators, 0);
    luaL_newlib(state, kFunctions);
    lua_pushcclosure(state, index, 1);
    lua_setfield(state, -2, "__index");
    lua_pushboolean(state, 0);
    lua_setfield(state, -2, "__metatable");
    lua_pop(state, 1);
    lua_pushcfunction(state, makeVector);
    lua_setglobal(state, "vec");
}

void pushVector(lua_State* state, Vec2 value) {
    constexpr std::int64_t kVectorWork = 20;  // units of Work: 0.1 us
    spend(state, kVectorWork);
    *static_cast<Vec2*>(lua_newuserdatauv(state, sizeof(Vec2), 0)) = value;
    luaL_setmetatable(state, kVector);
}

const Vec2* vectorAt(lua_State* state, int index) {
    return static_cast<const Vec2*>(luaL_testudata(state, index, kVector));
}

Vec2 checkVector(lua_State* state, int index) {
    return *static_cast<const Vec2*>(luaL_checkudata(state, index, kVector));
}

}  // namespace plumb::script
