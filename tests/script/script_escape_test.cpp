#include <ctime>
#include <filesystem>
#include <ostream>
#include <string>

#include <gtest/gtest.h>
#include <lua.hpp>

#include "core/random.hpp"
#include "core/text.hpp"
#include "script/script_arena.hpp"
#include "script/script_library.hpp"
#include "script/script_memory.hpp"
#include "script/script_source.hpp"
#include "tests/script/escapes/escape.hpp"

// Scripts that try to leave the sandbox, to crash, to hang, or to fill the memory.

namespace plumb {
namespace test {

/// Shows the name of a script instead of its bytes in reports.
static void PrintTo(const Escape& escape, std::ostream* out) { *out << escape.name; }

}  // namespace test

namespace {

using test::Escape;

constexpr int kBudgetOfScript = 1'000'000;
#if defined(__SANITIZE_ADDRESS__)
constexpr double kMaxSeconds = 20.0;
#else
constexpr double kMaxSeconds = 2.0;  // of the processor
#endif

/// Set by a function that no script can reach.
bool hasEscaped = false;
int canary(lua_State*) {
    hasEscaped = true;
    return 0;
}

int overBudget(lua_State* state) { return luaL_error(state, "the script takes too long"); }

/// The file that scripts try to write.
bool hasWritten() { return std::filesystem::exists("escaped.txt"); }

class ScriptEscape : public ::testing::TestWithParam<Escape>, public ScriptHost {
protected:
    ScriptEscape() {
        const ScriptAccess access{memory_};
        openScriptLibrary(access.state());
        lua_pushcfunction(access.state(), canary);
        lua_setfield(access.state(), LUA_REGISTRYINDEX, "canary");
        hasEscaped = false;
    }

    Random& random() override { return random_; }
    void print(std::string_view text) override { printed_ += text.size(); }

    struct Outcome {
        bool failed = false;
        std::string text;
    };

    /// Runs a script in an environment of its own, as the host of scripts does.
    Outcome run(const std::string& script) {
        const Result<std::string> prepared = prepareScript(script, "a.lua");
        if (!prepared) return {true, prepared.error().text()};
        const ScriptAccess access{memory_};
        const ScriptHostScope scope{*this};
        lua_State* state = access.state();
        const std::string text =
            format("local {}, {} = ... return function(...) ", kBudget, kOverBudget) + *prepared + "\nend";
        bool failed = luaL_loadbufferx(state, text.data(), text.size(), "=a.lua", "t") != LUA_OK;
        if (!failed) {
            pushScriptEnvironment(state);
            lua_setupvalue(state, -2, 1);
            lua_pushinteger(state, kBudgetOfScript);
            lua_pushcfunction(state, overBudget);
            failed = lua_pcall(state, 2, 1, 0) != LUA_OK || lua_pcall(state, 0, 1, 0) != LUA_OK;
        }
        const Outcome outcome{failed, textOfTop(state)};
        lua_settop(state, 0);
        return outcome;
    }

    static std::string textOfTop(lua_State* state) {
        lua_getglobal(state, "tostring");
        lua_insert(state, -2);
        static_cast<void>(lua_pcall(state, 1, 1, 0));
        const char* text = lua_tostring(state, -1);
        return text == nullptr ? luaL_typename(state, -1) : text;
    }

    ScriptMemory memory_;
    Random random_ = Random::seeded(5);
    std::size_t printed_ = 0;
};

/// Uses all parts of the library that another script could have changed.
constexpr const char* kHealthy = R"(
local names = {'table', 'string', 'math', 'coroutine', 'utf8', 'print', 'pcall', 'pairs', 'setmetatable'}
for _, name in ipairs(names) do assert(_G[name], name) end
local t = {3, 1, 2}
table.sort(t)
local co = coroutine.wrap(function() for i = 1, 3 do coroutine.yield(t[i]) end end)
local s = ('%d-%s'):format(co(), string.rep('ab', 2)) .. math.max(1, 2) .. utf8.char(97)
assert(stolen == nil and leaked == nil and getmetatable('') == false)
assert(select(2, pcall(error, 'x', 0)) == 'x')
return s .. ('axb'):gsub('x', '%%') .. tostring(t) .. tostring(print)
)";

TEST_P(ScriptEscape, isStopped) {
    const Escape& escape = GetParam();
    const std::clock_t start = std::clock();
    const Outcome outcome = run(escape.script);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    EXPECT_LT(seconds, kMaxSeconds);
    const std::string shown = outcome.text.substr(0, 300);
    EXPECT_EQ(outcome.failed, escape.fails) << shown;
    if (escape.fails) {
        EXPECT_NE(outcome.text.find(escape.expected), std::string::npos) << shown;
    } else {
        EXPECT_EQ(shown, escape.expected);
    }
    EXPECT_EQ(outcome.text.find("0x"), std::string::npos) << "an address? " << shown;
    EXPECT_LE(memory_.bytes(), ScriptArena::kBytes);
    EXPECT_FALSE(hasEscaped);
    EXPECT_FALSE(hasWritten());
    {
        const ScriptAccess access{memory_};
        lua_gc(access.state(), LUA_GCCOLLECT);
    }
    EXPECT_EQ(run(kHealthy).text, "1-abab2aa%btablefunction") << "the state is usable afterwards";
}

std::string nameOf(const ::testing::TestParamInfo<Escape>& escape) { return escape.param.name; }

INSTANTIATE_TEST_SUITE_P(Written, ScriptEscape, ::testing::ValuesIn(test::writtenEscapes()), nameOf);
INSTANTIATE_TEST_SUITE_P(Made, ScriptEscape, ::testing::ValuesIn(test::madeEscapes()), nameOf);

}  // namespace
}  // namespace plumb
