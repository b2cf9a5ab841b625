#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <lua.hpp>

#include "math/logarithm.hpp"
#include "math/portable.hpp"
#include "script/library/library_parts.hpp"

namespace plumb::script {
namespace {

constexpr lua_Number kLn10 = 2.302585092994046;

float argument(lua_State* state, int index) { return static_cast<float>(luaL_checknumber(state, index)); }

/// A function of one number.
template <float (*Function)(float)>
int ofNumber(lua_State* state) {
    lua_pushnumber(state, static_cast<lua_Number>(Function(argument(state, 1))));
    return 1;
}

float tangent(float x) { return sine(x) / cosine(x); }
float arcSine(float x) { return arcTangent(x, std::sqrt(std::max(0.0f, (1.0f - x) * (1.0f + x)))); }
float arcCosine(float x) { return arcTangent(std::sqrt(std::max(0.0f, (1.0f - x) * (1.0f + x))), x); }

int arcTangentOf(lua_State* state) {
    const float y = argument(state, 1);
    const float x = static_cast<float>(luaL_optnumber(state, 2, 1.0));
    lua_pushnumber(state, static_cast<lua_Number>(arcTangent(y, x)));
    return 1;
}

lua_Number logarithm(float x) {
    if (std::isnan(x) || x < 0.0f) return std::numeric_limits<lua_Number>::quiet_NaN();
    if (x == 0.0f) return -std::numeric_limits<lua_Number>::infinity();
    if (std::isinf(x)) return std::numeric_limits<lua_Number>::infinity();
    return static_cast<lua_Number>(logarithm10(x)) * kLn10;
}

int logarithmOf(lua_State* state) {
    const lua_Number value = logarithm(argument(state, 1));
    const bool hasBase = !lua_isnoneornil(state, 2);
    lua_pushnumber(state, hasBase ? value / logarithm(argument(state, 2)) : value);
    return 1;
}

/// x^n by squaring, exact where the products are.
lua_Number wholePower(lua_Number base, std::uint64_t exponent) {
    lua_Number result = 1.0;
    for (; exponent != 0; exponent >>= 1, base *= base) {
        if ((exponent & 1) != 0) result *= base;
    }
    return result;
}

int power(lua_State* state) {
    constexpr lua_Number kMaxWhole = 1024.0;  // larger exponents overflow or reach 0 or 1
    const lua_Number base = luaL_checknumber(state, 1);
    const lua_Number exponent = luaL_checknumber(state, 2);
    if (std::floor(exponent) == exponent && std::fabs(exponent) <= kMaxWhole) {
        const lua_Number value = wholePower(base, static_cast<std::uint64_t>(std::fabs(exponent)));
        lua_pushnumber(state, exponent < 0.0 ? 1.0 / value : value);
    } else if (exponent == 0.5) {
        lua_pushnumber(state, std::sqrt(base));
    } else {
        const lua_Number value = exponent * logarithm(static_cast<float>(base));
        lua_pushnumber(state, static_cast<lua_Number>(exponential(static_cast<float>(value))));
    }
    return 1;
}

/// As in Lua: random() in [0, 1), random(n) in 1..n, random(a, b) in a..b.
int random(lua_State* state) {
    Random& generator = hostRandom(state);
    if (lua_gettop(state) == 0) {
        lua_pushnumber(state, static_cast<lua_Number>(generator.next64() >> 11) * 0x1p-53);
        return 1;
    }
    const bool both = lua_gettop(state) > 1;
    const lua_Integer low = both ? luaL_checkinteger(state, 1) : 1;
    const lua_Integer high = luaL_checkinteger(state, both ? 2 : 1);
    luaL_argcheck(state, low <= high, both ? 2 : 1, "interval is empty");
    const std::uint64_t count = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
    luaL_argcheck(state, count != 0 && count <= 0xffffffffu, both ? 2 : 1, "interval is too large");
    const auto offset = generator.below(static_cast<std::uint32_t>(count));
    lua_pushinteger(state, static_cast<lua_Integer>(static_cast<std::uint64_t>(low) + offset));
    return 1;
}

int randomSeed(lua_State* state) {
    return luaL_error(state,
                      "math.randomseed is not available: the game has one seed, so that replays repeat it");
}

constexpr luaL_Reg kFunctions[] = {{"sin", ofNumber<sine>},
                                   {"cos", ofNumber<cosine>},
                                   {"tan", ofNumber<tangent>},
                                   {"asin", ofNumber<arcSine>},
                                   {"acos", ofNumber<arcCosine>},
                                   {"atan", arcTangentOf},
                                   {"exp", ofNumber<exponential>},
                                   {"log", logarithmOf},
                                   {"pow", power},
                                   {"random", random},
                                   {"randomseed", randomSeed},
                                   {nullptr, nullptr}};

}  // namespace

void addMath(lua_State* state) {
    lua_getglobal(state, LUA_MATHLIBNAME);
    luaL_setfuncs(state, kFunctions, 0);
    // Only some builds of Lua have them, and most have different last digits on different machines.
    for (const char* name : {"atan2", "cosh", "frexp", "ldexp", "log10", "sinh", "tanh"}) {
        lua_pushnil(state);
        lua_setfield(state, -2, name);
    }
    lua_pop(state, 1);
}

}  // namespace plumb::script
