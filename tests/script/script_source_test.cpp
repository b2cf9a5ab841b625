#include "script/script_source.hpp"

#include <algorithm>

#include <gtest/gtest.h>
#include <lua.hpp>

#include "core/text.hpp"

namespace plumb {
namespace {

/// Runs a prepared script with a budget; the script returns one value.
/// @return the value as text, or the error
std::string run(std::string_view script, int budget = 1000) {
    const Result<std::string> prepared = prepareScript(script, "a.lua");
    if (!prepared) return prepared.error().text();
    lua_State* state = luaL_newstate();
    luaL_openlibs(state);
    const std::string text =
        format("local {} = {} local function {}() error('over budget') end return (function(...) ", kBudget,
               budget, kOverBudget) +
        *prepared + "\nend)()";
    static_cast<void>(luaL_loadbuffer(state, text.data(), text.size(), "=a.lua") ||
                      lua_pcall(state, 0, 1, 0));
    std::string result = luaL_tolstring(state, -1, nullptr);
    lua_close(state);
    return result;
}

TEST(ScriptSource, meansTheSameAsBefore) {
    EXPECT_EQ(run("local s = 0 for i = 1, 10 do s = s + i end return s"), "55");
    EXPECT_EQ(run("local s = 0 for i, v in ipairs({3, 4}) do s = s + i * v end return s"), "11");
    EXPECT_EQ(run("local s = 0 while s < 7 do s = s + 2 end return s"), "8");
    EXPECT_EQ(run("local s = 0 repeat local t = s s = s + 1 until t > 4 return s"), "6");
    EXPECT_EQ(run("local function f(a, ...) return a + select('#', ...) end return f(1, 2, 3)"), "3");
    EXPECT_EQ(run("local t = {} function t.a:b(x) return x end t.a = {} return 'never'"),
              "a.lua:1: attempt to index a nil value (field 'a')");
    EXPECT_EQ(run("local s = 0 for i = 1, 5 do if i % 2 == 0 then goto continue end s = s + i ::continue:: "
                  "end return s"),
              "9");
    EXPECT_EQ(run("local i = 0 while (function() local n = 0 while n < 2 do n = n + 1 end i = i + n return i "
                  "< 6 end)() do "
                  "do local x = 1 end end return i"),
              "6");
    EXPECT_EQ(run("#!/usr/bin/lua\nreturn 1 --[==[ for while ]] do ]==] + 2"), "3");
    EXPECT_EQ(run("return #[[for i = 1, 2 do]] .. \"while 'do'\\\" do\" .. 'repeat'"),
              "15while 'do'\" dorepeat");
    EXPECT_EQ(run("return 0x1p-1 + 1e+1 + .5 + 3 // 2"), "12.0");
    EXPECT_EQ(run("local a = {1, 2} return a[a[1]] + #a"), "3");
}

TEST(ScriptSource, stopsWhatNeverEnds) {
    for (const char* script :
         {"while true do end", "repeat until false", "for i = 1, math.huge do end", "::again:: goto again",
          "local function f() return f() end f()", "for i = 1, 1000 do for k = 1, 1000 do end end",
          "while (function() return true end)() do end", "local f f = function() f() end f()"}) {
        EXPECT_NE(run(script).find("over budget"), std::string::npos) << script << ": " << run(script);
    }
    EXPECT_EQ(run("local n = 0 for i = 1, 1000 do n = i end return n", 1000), "1000");
    EXPECT_NE(run("local n = 0 for i = 1, 1001 do n = i end return n", 1000).find("over budget"),
              std::string::npos);
}

TEST(ScriptSource, keepsTheNumbersOfLines) {
    const std::string_view script =
        "for i = 1,\n 3\ndo\n  local x = i\nend\nlocal function f(\n a,\n b)\nend\nerror('here')";
    EXPECT_EQ(run(script), "a.lua:10: here");
    const Result<std::string> prepared = prepareScript(script, "a.lua");
    EXPECT_EQ(std::count(prepared->begin(), prepared->end(), '\n'),
              std::count(script.begin(), script.end(), '\n'));
}

TEST(ScriptSource, refusesPowersThatDifferBetweenMachines) {
    EXPECT_EQ(run("return 3^2"), "9.0");
    EXPECT_EQ(run("return 3 ^ --[[two]] 2"), "9.0");
    EXPECT_EQ(run("return '2^0.5'"), "2^0.5");
    EXPECT_EQ(run("\n\nreturn 2^0.5"),
              "a.lua:3: powers other than ^2 have different last digits on different machines; write "
              "math.pow(x, y), or "
              "products");
    for (const char* script :
         {"return 2^x", "return 2^2.5", "return 2^-2", "return 2^(2)", "return 2^20", "return 2^"})
        EXPECT_NE(run(script).find("powers other than"), std::string::npos) << script;
    EXPECT_EQ(run("return '\xff'"), "a.lua: the file is not UTF-8 text; save it as UTF-8");
}

TEST(ScriptSource, brokenTextsReachLuaUnchanged) {
    for (const char* script : {"for", "while true", "function", "function f(", "end end end", "repeat",
                               "'abc", "[[abc", "--[[abc", "goto", "do do do", "x = [=[ ]]"}) {
        const std::string error = run(script);
        EXPECT_NE(error.find("a.lua:"), std::string::npos) << script << ": " << error;
    }
}

}  // namespace
}  // namespace plumb
