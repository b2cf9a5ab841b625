#include "script/script_frames.hpp"

#include <algorithm>
#include <cstddef>

#include <lua.hpp>

#include "core/text.hpp"
#include "script/script_context.hpp"
#include "script/script_errors.hpp"
#include "script/script_list.hpp"
#include "script/script_source.hpp"
#include "script/script_state.hpp"

namespace plumb::script {
namespace {

constexpr int kMaxFrames = 32;               // functions listed
constexpr int kMaxVariables = 100;           // of a function
constexpr std::size_t kMaxEntries = 8;       // of a table
constexpr std::size_t kMaxText = 120;        // bytes of a value
constexpr int kStackNeeded = 13;             // values that a description needs on the stack
constexpr int kMaxInstructions = 1'000'000;  // of an expression

std::string shortened(std::string text, std::size_t most) {
    if (text.size() <= most) return text;
    std::size_t end = most;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
        --end;  // not inside of a letter
    text.resize(end);
    return text + "...";
}

std::string numberText(lua_Number number) {
    // Fields are floats: 0.1 instead of 0.10000000149011612.
    const auto single = static_cast<float>(number);
    return static_cast<lua_Number>(single) == number ? shortestText(single) : shortestText(number);
}

/// The value at an index that is no table.
std::string plainText(lua_State* state, int index) {
    switch (lua_type(state, index)) {
        case LUA_TNIL: return "nil";
        case LUA_TBOOLEAN: return lua_toboolean(state, index) != 0 ? "true" : "false";
        case LUA_TNUMBER:
            return lua_isinteger(state, index) != 0
                       ? format("{}", static_cast<long long>(lua_tointeger(state, index)))
                       : numberText(lua_tonumber(state, index));
        case LUA_TSTRING: return "\"" + shortened(textAt(state, index), kMaxText) + "\"";
        case LUA_TUSERDATA: {
            // Only entities, components and vectors are userdata: their texts are made by the engine.
            std::string text = luaL_tolstring(state, index, nullptr);
            lua_pop(state, 1);
            return text;
        }
        default: return luaL_typename(state, index);
    }
}

struct Entry {
    lua_Integer number = 0;  // of a key that is an integer
    std::string name;        // of another key
    std::string value;
};

/// The first entries of the table at an index, sorted by key: the order in a table differs between runs.
std::vector<Entry> entriesOf(lua_State* state, int index) {
    constexpr std::size_t kMaxVisited = 1000;
    std::vector<Entry> entries;
    const int table = lua_absindex(state, index);
    for (lua_pushnil(state); lua_next(state, table) != 0; lua_pop(state, 1)) {
        if (entries.size() == kMaxVisited) {
            lua_pop(state, 2);
            break;
        }
        Entry& entry = entries.emplace_back();
        if (lua_isinteger(state, -2) != 0) {
            entry.number = lua_tointeger(state, -2);
        } else {
            entry.name =
                lua_type(state, -2) == LUA_TSTRING ? textAt(state, -2) : format("[{}]", plainText(state, -2));
        }
        entry.value = lua_istable(state, -1) ? "{...}" : plainText(state, -1);
    }
    const auto before = [](const Entry& a, const Entry& b) {
        return a.name != b.name ? a.name < b.name : a.number < b.number;
    };
    std::sort(entries.begin(), entries.end(), before);
    return entries;
}

/// "{1, 2, speed = 3}"
std::string tableText(lua_State* state, int index) {
    std::string text;
    std::size_t count = 0;
    lua_Integer next = 1;
    for (const Entry& entry : entriesOf(state, index)) {
        if (count++ == kMaxEntries) {
            text += ", ...";
            break;
        }
        if (!text.empty()) text += ", ";
        const bool inOrder = entry.name.empty() && entry.number == next;
        if (inOrder) ++next;
        text += inOrder              ? entry.value
                : entry.name.empty() ? format("[{}] = {}", static_cast<long long>(entry.number), entry.value)
                                     : format("{} = {}", entry.name, entry.value);
    }
    return shortened("{" + text, kMaxText) + "}";
}

std::string textOfValue(lua_State* state, int index) {
    if (!lua_istable(state, index)) return plainText(state, index);
    pushItems(state, index);
    std::string text = tableText(state, -1);
    lua_pop(state, 1);
    return text;
}

/// Calls `visit(name)` for each variable of a function, its value on top of the stack: local ones from the
/// innermost block to the outermost, then those of the functions around it.
template <class Visit>
void eachVariable(lua_State* coroutine, lua_Debug& function, Visit visit) {
    int count = 0;
    while (count < kMaxVariables && lua_getlocal(coroutine, &function, count + 1) != nullptr) {
        lua_pop(coroutine, 1);
        ++count;
    }
    for (int i = count; i > 0; --i) {
        const char* name = lua_getlocal(coroutine, &function, i);
        if (name[0] != '(') visit(std::string_view{name});  // "(temporary)" and the like
        lua_pop(coroutine, 1);
    }
    lua_getinfo(coroutine, "f", &function);
    const int closure = lua_gettop(coroutine);
    for (int i = 1; i <= kMaxVariables; ++i) {
        const char* name = lua_getupvalue(coroutine, closure, i);
        if (name == nullptr) break;
        const std::string_view known{name};
        if (!startsWith(known, "__") && known != "_ENV") visit(known);  // names of prepareScript()
        lua_pop(coroutine, 1);
    }
    lua_pop(coroutine, 1);
}

std::vector<ScriptVariable> variablesOf(lua_State* coroutine, lua_Debug& function) {
    std::vector<ScriptVariable> variables;
    eachVariable(coroutine, function, [&](std::string_view name) {
        const bool isHidden = std::any_of(variables.begin(), variables.end(),
                                          [name](const ScriptVariable& other) { return other.name == name; });
        if (isHidden || lua_isfunction(coroutine, -1)) return;
        variables.push_back({std::string{name}, textOfValue(coroutine, -1)});
    });
    return variables;
}

/// Returns the name under which a script has the function on top of the stack; empty if it has none.
std::string nameInScript(lua_State* coroutine) {
    const Context* context = currentContext();
    if (context == nullptr) return {};
    const int function = lua_gettop(coroutine);
    std::string name;
    for (const ScriptState::Loaded& script : context->state.loaded) {
        if (script.table == 0 || !name.empty()) continue;
        lua_rawgeti(coroutine, LUA_REGISTRYINDEX, script.table);
        for (lua_pushnil(coroutine); lua_next(coroutine, -2) != 0; lua_pop(coroutine, 1)) {
            if (lua_rawequal(coroutine, -1, function) != 0 && lua_type(coroutine, -2) == LUA_TSTRING)
                name = textAt(coroutine, -2);
        }
        lua_settop(coroutine, function);
    }
    return name;
}

std::string lineName(const lua_Debug& function) {
    return format("function of line {}", function.linedefined);
}

std::string nameOf(lua_State* coroutine, lua_Debug& function) {
    lua_getinfo(coroutine, "f", &function);
    std::string name = nameInScript(coroutine);
    lua_pop(coroutine, 1);
    if (name.empty() && function.name != nullptr) name = function.name;
    return name.empty() ? lineName(function) : name;
}

/// Calls `visit(lua_Debug&)` for each function of scripts that is being called, innermost first.
template <class Visit>
void eachFrame(lua_State* coroutine, Visit visit) {
    lua_Debug function;
    for (int level = 0; level < kMaxFrames && lua_getstack(coroutine, level, &function) != 0; ++level) {
        lua_getinfo(coroutine, "Sln", &function);
        if (function.currentline >= 0) visit(function);  // otherwise a function of the engine
    }
}

ScriptFrame placeOf(const lua_Debug& function) {
    ScriptFrame frame;
    frame.file = function.source[0] == '@' ? function.source + 1 : function.source;
    frame.line = function.currentline;
    return frame;
}

// ---- expressions

void stopExpression(lua_State* state, lua_Debug*) { luaL_error(state, "it takes too long"); }

/// Pushes the table of global variables of a function; those of all scripts if it uses none.
void pushGlobals(lua_State* coroutine, lua_Debug& function) {
    lua_getinfo(coroutine, "f", &function);
    const int closure = lua_gettop(coroutine);
    for (int i = 1;; ++i) {
        const char* name = lua_getupvalue(coroutine, closure, i);
        if (name == nullptr) break;
        if (std::string_view{name} == "_ENV") return lua_remove(coroutine, closure);
        lua_pop(coroutine, 1);
    }
    lua_pop(coroutine, 1);
    lua_pushglobaltable(coroutine);
}

/// Pushes a table of the variables of a function that shows its global variables too.
void pushEnvironment(lua_State* coroutine, lua_Debug& function) {
    lua_newtable(coroutine);
    const int table = lua_gettop(coroutine);
    // A variable that is nil is not in the table, so a global one of its name is visible: a small difference.
    eachVariable(coroutine, function, [&](std::string_view name) {
        lua_pushlstring(coroutine, name.data(), name.size());
        lua_pushvalue(coroutine, -1);
        if (lua_rawget(coroutine, table) == LUA_TNIL) {
            lua_pop(coroutine, 1);
            lua_pushvalue(coroutine, -2);
            lua_rawset(coroutine, table);
        } else {
            lua_pop(coroutine, 2);
        }
    });
    lua_newtable(coroutine);
    pushGlobals(coroutine, function);
    lua_setfield(coroutine, -2, "__index");
    lua_setmetatable(coroutine, table);
}

}  // namespace

int scriptDepth(lua_State* coroutine) {
    lua_Debug function;
    int known = 0, above = 1;  // level `above - 1` may exist, level `known - 1` does
    while (lua_getstack(coroutine, above - 1, &function) != 0) known = above, above *= 2;
    while (known + 1 < above) {
        const int middle = known + (above - known) / 2;
        (lua_getstack(coroutine, middle - 1, &function) != 0 ? known : above) = middle;
    }
    return known;
}

std::vector<ScriptFrame> framesOf(lua_State* coroutine) {
    if (lua_checkstack(coroutine, kStackNeeded) == 0) return placesOf(coroutine);
    std::vector<ScriptFrame> frames;
    eachFrame(coroutine, [&](lua_Debug& function) {
        ScriptFrame& frame = frames.emplace_back(placeOf(function));
        frame.function = nameOf(coroutine, function);
        frame.variables = variablesOf(coroutine, function);
    });
    return frames;
}

std::vector<ScriptFrame> placesOf(lua_State* coroutine) {
    std::vector<ScriptFrame> frames;
    eachFrame(coroutine, [&](lua_Debug& function) {
        ScriptFrame& frame = frames.emplace_back(placeOf(function));
        frame.function = function.name != nullptr ? function.name : lineName(function);
    });
    return frames;
}

Evaluation evaluate(lua_State* coroutine, std::string_view expression) {
    Evaluation result;
    lua_Debug function;
    if (lua_checkstack(coroutine, kStackNeeded) == 0 || lua_getstack(coroutine, 0, &function) == 0) {
        result.problem = "no function of a script is running";
        return result;
    }
    const int top = lua_gettop(coroutine);
    // In a coroutine of its own: the hook that calls this function disables hooks in the other.
    lua_State* thread = lua_newthread(coroutine);
    lua_sethook(thread, stopExpression, LUA_MASKCOUNT, kMaxInstructions);
    const std::string text = "return (" + std::string{expression} + "\n)";
    const bool isLoaded = luaL_loadbufferx(thread, text.data(), text.size(), "=condition", "t") == LUA_OK;
    if (isLoaded) {
        pushEnvironment(coroutine, function);
        lua_xmove(coroutine, thread, 1);
        lua_setupvalue(thread, -2, 1);
    }
    if (isLoaded && lua_pcall(thread, 0, 1, 0) == LUA_OK) {
        result.holds = lua_toboolean(thread, -1) != 0;
        result.value = textOfValue(thread, -1);
    } else {
        result.problem = textAt(thread, -1);
    }
    lua_settop(coroutine, top);
    return result;
}

}  // namespace plumb::script
