#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <lua.hpp>

#include "core/random.hpp"
#include "script/script_library.hpp"

// Our patterns against those of Lua's own library.

namespace plumb {
namespace {

class Patterns : public ::testing::Test {
protected:
    Patterns() : ours{luaL_newstate()}, theirs{luaL_newstate()} {
        openScriptLibrary(ours);
        luaL_openlibs(theirs);
        run(ours, kDescribe);
        run(theirs, kDescribe);
    }
    ~Patterns() override {
        lua_close(ours);
        lua_close(theirs);
    }

    static constexpr const char* kDescribe = R"(
function describe(...)
  local s = select('#', ...) .. ':'
  for i = 1, select('#', ...) do s = s .. tostring((select(i, ...))) .. ';' end
  return s
end
function all(f, s, p) local r = '' for a, b in f(s, p) do r = r .. '[' .. tostring(a) .. ',' .. tostring(b) .. ']' end return r end)";

    static std::string run(lua_State* state, const std::string& script) {
        static_cast<void>(luaL_loadstring(state, script.c_str()) || lua_pcall(state, 0, 1, 0));
        const char* text = lua_tostring(state, -1);
        std::string result = text == nullptr ? "" : text;
        lua_settop(state, 0);
        return result;
    }
    /// Calls a function of string in both libraries.
    void compare(const std::string& call) {
        const std::string script =
            "local ok, r = pcall(function() return describe(" + call + ") end) return ok and r or 'error'";
        EXPECT_EQ(run(ours, script), run(theirs, script)) << call;
    }

    lua_State* ours;
    lua_State* theirs;
};

TEST_F(Patterns, agreeWithThoseOfLua) {
    const std::vector<std::string> patterns{"a",
                                            "^a",
                                            "b$",
                                            "^$",
                                            "",
                                            ".",
                                            ".-",
                                            ".*",
                                            ".+",
                                            "a?b",
                                            "(a)(b)",
                                            "()a()",
                                            "%a+",
                                            "%d*",
                                            "%s",
                                            "%u%l",
                                            "[abc]+",
                                            "[^abc]+",
                                            "[a-c]",
                                            "[%a_][%w_]*",
                                            "[]]",
                                            "[^]]",
                                            "[a-]",
                                            "%b()",
                                            "%f[%w]%w+",
                                            "(.)%1",
                                            "((a)b)",
                                            "%.",
                                            "%%",
                                            "x*",
                                            "a-b",
                                            "a+b*c?",
                                            "^(%s*)(.-)%s*$",
                                            "(%w+)=(%w+)",
                                            "%x+",
                                            "%p",
                                            "%g",
                                            "%c",
                                            "[%d%s]",
                                            "a.b",
                                            "(a*(.)%w(%s*))",
                                            "^",
                                            "$",
                                            "a$b",
                                            "[%]]",
                                            "%S+",
                                            "[^%s]+",
                                            "[\\0-\\31]",
                                            "(",
                                            ")",
                                            "[a",
                                            "%",
                                            "%b",
                                            "%f",
                                            "%1",
                                            "(()",
                                            "[^",
                                            "a**",
                                            "%z",
                                            "%",
                                            "()",
                                            "(a-)*"};
    const std::vector<std::string> texts{
        "",         "a",           "ab",        "aab",   "hello world",     "key=value, other=thing",
        "(a(b)c)d", "  trim me  ", "x]y",       "a-b",   "THE (quick) fox", "aaa",
        "abab",     "1.5e3",       "tab\\tend", "[a]%1", "\\0a\\0"};
    for (const std::string& pattern : patterns) {
        for (const std::string& text : texts) {
            const std::string arguments = "'" + text + "', '" + pattern + "'";
            compare("string.find(" + arguments + ")");
            compare("string.find(" + arguments + ", 2)");
            compare("string.find(" + arguments + ", -2)");
            compare("string.find(" + arguments + ", 1, true)");
            compare("string.match(" + arguments + ")");
            compare("all(string.gmatch, " + arguments + ")");
            compare("string.gsub(" + arguments + ", '<%0>')");
            compare("string.gsub(" + arguments + ", '%1%%', 1)");
            compare("string.gsub(" + arguments + ", {a = 'x', b = false})");
            compare("string.gsub(" + arguments + ", function(a, b) return b or a end)");
        }
    }
}

TEST_F(Patterns, randomPatternsAgreeWithThoseOfLua) {
    Random random = Random::seeded(11);
    const std::string_view letters = "ab(%)[]^$.*+-?1wdbf";
    for (int i = 0; i < 30'000; ++i) {
        std::string pattern, text;
        for (std::uint32_t k = random.below(8); k > 0; --k)
            pattern += letters[random.below(static_cast<std::uint32_t>(letters.size()))];
        for (std::uint32_t k = random.below(10); k > 0; --k) text += "ab1 ("[random.below(5)];
        const std::string arguments = "'" + text + "', '" + pattern + "'";
        compare("string.find(" + arguments + ")");
        compare("string.gsub(" + arguments + ", '<%0>')");
        if (HasFailure()) return;
    }
}

TEST_F(Patterns, stopInALimitedNumberOfSteps) {
    const std::string setUp = "local s = string.rep('a', 3000) local ok, e = pcall(string.find, s, ";
    for (const char* pattern :
         {"'.-.-.-.-b'", "'.*.*.*.*b'", "'(.*)(.*)(.*)b'", "'a-a-a-a-b$'", "'[ab]*[ab]*[ab]*c'"})
        EXPECT_NE(run(ours, setUp + pattern + ") return tostring(e)").find("too many steps"),
                  std::string::npos)
            << pattern;
    EXPECT_EQ(run(ours, "return #('  x  '):rep(200):match('^%s*(.-)%s*$')"), "996");
    EXPECT_NE(run(ours,
                  "local p = string.rep('a?', 300) local ok, e = pcall(string.find, string.rep('a', 300), p) "
                  "return "
                  "tostring(e)")
                  .find("nested too deeply"),
              std::string::npos);
}

}  // namespace
}  // namespace plumb
