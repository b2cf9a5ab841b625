#include "script/script_vector.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>

#include <lua.hpp>

#include "core/text.hpp"
#include "math/angle.hpp"
#include "script/library/work.hpp"
#include "script/values/userdata.hpp"

namespace plumb::script {
namespace {

// Keys in the registry of the Lua state, by address.
constexpr char kRecent = 0;  // see Recent

/// The block of a vector.
struct VectorBlock {
    static constexpr BlockKind kKind = BlockKind::Vector;
    BlockKind kind = kKind;
    Vec2 value;
};

/// Vectors that were pushed last. They cannot be changed, so one with the same value is pushed again instead
/// of a new one: fields are often read many times between two changes. The user values of this userdata are
/// the vectors, and behind them their metatable.
struct Recent {
    static constexpr std::size_t kCount = 64;
    std::array<std::uint64_t, kCount> bits;  // of their values

    static constexpr int kMetatable = kCount + 1;  // user value

    Recent() { bits.fill(std::bit_cast<std::uint64_t>(kNoVector)); }
    static constexpr Vec2 kNoVector{std::numeric_limits<float>::quiet_NaN(), 0.0f};
    /// The place of a value: a hash of its bits.
    [[nodiscard]] static std::size_t placeOf(std::uint64_t bits) {
        constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;
        constexpr int kShift = 64 - 6;
        return bits * kGolden >> kShift;
    }
};

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
    const Vec2* vector = vectorAt(state, 1);
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
    std::construct_at(static_cast<Recent*>(lua_newuserdatauv(state, sizeof(Recent), Recent::kMetatable)));
    luaL_newlib(state, kOperators);
    luaL_newlib(state, kFunctions);
    lua_pushcclosure(state, index, 1);
    lua_setfield(state, -2, "__index");
    lua_pushliteral(state, "vec");
    lua_setfield(state, -2, "__name");
    lua_pushboolean(state, 0);
    lua_setfield(state, -2, "__metatable");
    lua_setiuservalue(state, -2, Recent::kMetatable);
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kRecent);
    lua_pushcfunction(state, makeVector);
    lua_setglobal(state, "vec");
}

void pushVector(lua_State* state, Vec2 value) {
    constexpr std::int64_t kVectorWork = 20;  // units of Work: 0.1 us
    spend(state, kVectorWork);
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kRecent);
    auto& recent = *static_cast<Recent*>(lua_touserdata(state, -1));
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const std::size_t place = Recent::placeOf(bits);
    const int userValue = static_cast<int>(place) + 1;
    const bool isNumber = value == value;  // a vector with NaN is equal to no other one
    if (recent.bits[place] == bits && isNumber) {
        lua_getiuservalue(state, -1, userValue);
    } else {
        auto* block = static_cast<VectorBlock*>(lua_newuserdatauv(state, sizeof(VectorBlock), 0));
        *block = {VectorBlock::kKind, value};
        lua_getiuservalue(state, -2, Recent::kMetatable);
        lua_setmetatable(state, -2);
        lua_pushvalue(state, -1);
        lua_setiuservalue(state, -3, userValue);
        recent.bits[place] = bits;
    }
    lua_replace(state, -2);
}

const Vec2* vectorAt(lua_State* state, int index) {
    const auto* block = blockAt<VectorBlock>(state, index);
    return block == nullptr ? nullptr : &block->value;
}

Vec2 checkVector(lua_State* state, int index) {
    const Vec2* vector = vectorAt(state, index);
    if (vector == nullptr) luaL_typeerror(state, index, "vec");
    return *vector;
}

}  // namespace plumb::script
