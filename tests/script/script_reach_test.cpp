#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <lua.hpp>

#include "script/script_library.hpp"
#include "script/script_memory.hpp"

namespace plumb {
namespace {

/// Walks all that is reachable from the globals: fields and metatables of tables, and upvalues of functions.
class Reach {
public:
    explicit Reach(lua_State* state) : state_{state} {
        lua_newtable(state_);  // what was seen, so that nothing is freed and its address used again
        lua_pushglobaltable(state_);
        visit("");
        lua_pushliteral(state_, "");
        if (lua_getmetatable(state_, -1) != 0) visit("text");
    }

    std::set<std::string> functions;  ///< paths of functions of C
    std::set<std::string> others;     ///< paths of userdata and of functions of Lua

private:
    /// Visits the value on top of the stack, and removes it.
    void visit(const std::string& path) {
        luaL_checkstack(state_, 10, "deep");
        const int type = lua_type(state_, -1);
        if (type == LUA_TFUNCTION || type == LUA_TUSERDATA || type == LUA_TLIGHTUSERDATA ||
            type == LUA_TTHREAD) {
            (lua_iscfunction(state_, -1) != 0 ? functions : others).insert(path);
        }
        if (isNew()) {
            if (type == LUA_TTABLE) visitFields(path);
            // pairs() of a table of the library knows the same table as the __index beside it.
            const bool isPairs = path.ends_with("{}.__pairs");
            if (type == LUA_TFUNCTION)
                visitUpvalues(isPairs ? path.substr(0, path.rfind('.')) + ".__index" : path + "^");
            if (type == LUA_TTABLE && lua_getmetatable(state_, -1) != 0) visit(path + "{}");
        }
        lua_pop(state_, 1);
    }
    bool isNew() {
        const void* address = lua_topointer(state_, -1);
        return address != nullptr && seen_.insert(address).second;
    }
    void visitFields(const std::string& path) {
        for (lua_pushnil(state_); lua_next(state_, -2) != 0;) {
            const std::string name = lua_type(state_, -2) == LUA_TSTRING ? lua_tostring(state_, -2) : "?";
            visit(path.empty() ? name : path + "." + name);
        }
    }
    void visitUpvalues(const std::string& path) {
        for (int i = 1; lua_getupvalue(state_, -1, i) != nullptr; ++i) visit(path);
    }

    lua_State* state_;
    std::set<const void*> seen_;
};

/// Names of all functions of C that scripts may reach; "a{}.b" is field b of the metatable of a, "f^" an
/// upvalue of f.
std::set<std::string> allowed() {
    std::set<std::string> all;
    const auto add = [&](const std::string& before, const std::string& names) {
        std::istringstream in{names};
        for (std::string name; in >> name;) all.insert(before + name);
    };
    add("",
        "assert error getmetatable ipairs next pairs pcall print rawequal rawget rawlen rawset select "
        "select^ "
        "setmetatable tonumber tostring type xpcall");
    const std::map<std::string, std::string> tables{
        {"coroutine", "close close^ create isyieldable resume resume^ running status wrap yield"},
        {"math",
         "abs acos asin atan ceil cos deg exp floor fmod log max min modf pow rad random randomseed sin "
         "sqrt tan tointeger type ult"},
        {"string",
         "byte char find format format^ gmatch gsub len lower lower^ match pack pack^ packsize rep rep^ "
         "reverse reverse^ sub unpack unpack^ upper upper^"},
        {"table", "concat insert move pack remove sort unpack unpack^"},
        {"utf8", "char codepoint codepoint^ codes len len^ offset offset^"}};
    for (const auto& [table, names] : tables) {
        add(table + "{}.__index.", names);
        add(table + "{}.", "__newindex __pairs");
    }
    return all;
}

TEST(ScriptReach, containsOnlyFunctionsOfTheList) {
    ScriptMemory memory;
    const ScriptAccess access{memory};
    openScriptLibrary(access.state());
    Reach reach{access.state()};
    const std::set<std::string> list = allowed();
    std::set<std::string> found;
    for (const std::string& path : reach.functions) {
        // Metamethods of texts do arithmetic with them; their table is that of string.
        if (path.rfind("text.__", 0) == 0) continue;
        found.insert(path);
        EXPECT_TRUE(list.count(path) == 1) << path;
    }
    for (const std::string& path : list) EXPECT_TRUE(found.count(path) == 1) << "missing: " << path;
    EXPECT_TRUE(reach.others.empty()) << *reach.others.begin();
}

}  // namespace
}  // namespace plumb
