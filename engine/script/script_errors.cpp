#include "script/script_errors.hpp"

#include <string_view>

#include <lua.hpp>

#include "core/text.hpp"
#include "ecs/world.hpp"
#include "scene/components/name.hpp"

namespace plumb::script {
namespace {

constexpr int kMaxLevels = 8;         // functions listed
constexpr int kMaxLocals = 12;        // variables listed
constexpr std::size_t kMaxText = 40;  // bytes of a value

std::string entityName(const World& world, EntityId entity) {
    const Name* name = world.find<Name>(entity);
    const std::string_view text = name == nullptr ? std::string_view{} : world.texts().find(name->text);
    return text.empty() ? format("entity {}", entity.index) : std::string{text};
}

/// The value at the top of the stack, without calling functions of scripts.
std::string valueText(lua_State* state) {
    std::string text;
    switch (lua_type(state, -1)) {
        case LUA_TNIL: return "nil";
        case LUA_TBOOLEAN: return lua_toboolean(state, -1) != 0 ? "true" : "false";
        case LUA_TNUMBER:
            return lua_isinteger(state, -1) != 0
                       ? format("{}", static_cast<long long>(lua_tointeger(state, -1)))
                       : shortestText(lua_tonumber(state, -1));
        case LUA_TSTRING: text = textAt(state, -1); break;
        case LUA_TUSERDATA:
            text = luaL_tolstring(state, -1, nullptr);
            lua_pop(state, 1);
            return text;
        default: return luaL_typename(state, -1);
    }
    if (text.size() > kMaxText) text.resize(kMaxText);
    return "\"" + text + "\"";
}

/// "speed = 40, target = nil" of a function.
std::string localsOf(lua_State* coroutine, const lua_Debug& function) {
    std::string list;
    for (int i = 1; i <= kMaxLocals; ++i) {
        const char* name = lua_getlocal(coroutine, &function, i);
        if (name == nullptr) break;
        if (name[0] != '(') list += format("{}{} = {}", list.empty() ? "" : ", ", name, valueText(coroutine));
        lua_pop(coroutine, 1);
    }
    return list;
}

}  // namespace

std::string textAt(lua_State* state, int index) {
    if (lua_type(state, index) != LUA_TSTRING)
        return format("an error that is a {}", luaL_typename(state, index));
    std::size_t size = 0;
    const char* text = lua_tolstring(state, index, &size);
    return {text, size};
}

Error handlerError(lua_State* coroutine, const World& world, EntityId entity) {
    std::string message = textAt(coroutine, -1);
    std::string where, functions, locals;
    lua_Debug function;
    for (int level = 0; level < kMaxLevels && lua_getstack(coroutine, level, &function) != 0; ++level) {
        lua_getinfo(coroutine, "Sln", &function);
        if (function.currentline < 0) continue;  // a function of the engine
        const std::string line =
            format("{}:{}", static_cast<const char*>(function.short_src), function.currentline);
        if (where.empty()) {
            where = line;
            locals = localsOf(coroutine, function);
        }
        functions += format("\n  in {} at {}", function.name == nullptr ? "a handler" : function.name, line);
    }
    if (startsWith(message, where + ": ")) message.erase(0, where.size() + 2);
    std::string what = format("{} (in \"{}\")", message, entityName(world, entity));
    what += functions;
    if (!locals.empty()) what += "\n  with " + locals;
    return {where.empty() ? std::string{"scripts"} : where, what,
            "the script of this entity is stopped until its file is changed"};
}

}  // namespace plumb::script
