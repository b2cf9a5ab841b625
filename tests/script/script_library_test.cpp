#include "script/script_library.hpp"

#include <string>

#include <gtest/gtest.h>
#include <lua.hpp>

#include "core/random.hpp"
#include "script/script_memory.hpp"

namespace plumb {
namespace {

class ScriptLibrary : public ::testing::Test, public ScriptHost {
protected:
    Random& random() override { return random_; }
    void print(std::string_view text) override { printed += std::string{text} + "\n"; }

    /// Runs a script in a new state. @return its value as text, or the error
    std::string run(const std::string& script) {
        ScriptMemory memory;
        const ScriptAccess access{memory};
        const ScriptHostScope scope{*this};
        openScriptLibrary(access.state());
        lua_State* state = access.state();
        static_cast<void>(luaL_loadbuffer(state, script.data(), script.size(), "=a.lua") ||
                          lua_pcall(state, 0, 1, 0));
        const char* text = lua_tostring(state, -1);
        return text == nullptr ? luaL_typename(state, -1) : text;
    }

    std::string printed;
    Random random_ = Random::seeded(5);
};

constexpr const char* kJoin =
    "local s = '' for k, v in pairs(t) do s = s .. tostring(k) .. '=' .. tostring(v) .. ' ' end "
    "return s";

TEST_F(ScriptLibrary, pairsVisitsNumbersThenStringsThenBooleans) {
    EXPECT_EQ(run(std::string{"local t = {b = 1, a = 2, [3] = 3, [1.5] = 4, [-2] = 5, 'x', [true] = 6, "
                              "[false] = 7, aa = 8, "
                              "['\\xff'] = 9, [''] = 0} "} +
                  kJoin),
              "-2=5 1=x 1.5=4 3=3 =0 a=2 aa=8 b=1 \xff=9 false=7 true=6 ");
    EXPECT_EQ(run(std::string{"local t = {10, 20, 30} "} + kJoin), "1=10 2=20 3=30 ");
    EXPECT_EQ(run(std::string{"local t = {} "} + kJoin), "");
    EXPECT_EQ(run("local t = {} for i = 1, 1000 do t['k' .. i * 7919 % 1000] = i end "
                  "local before = '' for k in pairs(t) do assert(before < k) before = k end return before"),
              "k999");
}

TEST_F(ScriptLibrary, pairsAllowsToRemoveAndChangeWhatIsVisited) {
    EXPECT_EQ(run("local t = {a = 1, b = 2, c = 3} local n = 0 for k in pairs(t) do t[k] = nil n = n + 1 end "
                  "return n .. tostring(next(t))"),
              "3nil");
    EXPECT_EQ(run("local t = {a = 1, b = 2, c = 3} local s = '' for k in pairs(t) do t.b = nil s = s .. k "
                  "end return s"),
              "ac");
    EXPECT_EQ(run("local t = setmetatable({}, {__pairs = function(t) return function(_, k) return not k and "
                  "7 or nil end, t "
                  "end}) local s = 0 for k in pairs(t) do s = s + k end return s"),
              "7");
}

TEST_F(ScriptLibrary, pairsRefusesKeysWithoutAnOrder) {
    EXPECT_NE(run("local t = {[{}] = 1} for k in pairs(t) do end").find("a key is a table; only numbers"),
              std::string::npos);
    EXPECT_EQ(run("local t = {[{}] = 1} return tostring(next(t) ~= nil)"), "true")
        << "the test for an empty table works";
}

TEST_F(ScriptLibrary, nextHasTheOrderOfPairs) {
    EXPECT_EQ(run("local t = {b = 1, a = 2, [3] = 3, [true] = 4} local s, k = '', next(t) "
                  "while k ~= nil do s = s .. tostring(k) k = next(t, k) end return s"),
              "3abtrue");
}

TEST_F(ScriptLibrary, sortIsStableAndSafe) {
    EXPECT_EQ(run("local t = {} for i = 1, 100 do t[i] = {key = i * 37 % 5, at = i} end "
                  "table.sort(t, function(a, b) return a.key < b.key end) "
                  "for i = 2, 100 do local a, b = t[i - 1], t[i] "
                  "assert(a.key < b.key or (a.key == b.key and a.at < b.at)) end return #t"),
              "100");
    EXPECT_EQ(run("local t = {3, 1, 2} table.sort(t) return table.concat(t, ',')"), "1,2,3");
    EXPECT_EQ(run("local t = {'b', 'a', 'c'} table.sort(t, function(a, b) return a > b end) return "
                  "table.concat(t)"),
              "cba");
    EXPECT_EQ(run("local t = {} for i = 1, 500 do t[i] = i end table.sort(t, function() return true end) "
                  "return #t"),
              "500");
    EXPECT_NE(run("local t = {1, {}} table.sort(t)").find("attempt to compare"), std::string::npos);
    EXPECT_EQ(run("local t = {2, 1} local ok, e = pcall(table.sort, t, function() error('x', 0) end) return "
                  "e .. t[1]"),
              "x2");
}

TEST_F(ScriptLibrary, textsContainNoAddresses) {
    EXPECT_EQ(run("return tostring({}) .. tostring(print) .. tostring(coroutine.create(print))"),
              "tablefunctionthread");
    EXPECT_EQ(run("return string.format('%s %s %5.1f %d %q', {}, nil, 2.25, 3, 'x')"),
              "table nil   2.2 3 \"x\"");
    EXPECT_EQ(
        run("return ('%s%%%s'):format(setmetatable({}, {__tostring = function() return 'own' end}), true)"),
        "own%true");
    EXPECT_EQ(run("return tostring(0/0) .. tostring(-(0/0)) .. tostring(1/0) .. tostring(-1/0)"),
              "nannaninf-inf");
    for (const char* format : {"%p", "%a", "%A"})
        EXPECT_NE(run(std::string{"return string.format('"} + format + "', 1)").find("on each machine"),
                  std::string::npos);
    EXPECT_EQ(run("print('a', 1, nil, {})"), "nil");
    EXPECT_EQ(printed, "a\t1\tnil\ttable\n");
}

TEST_F(ScriptLibrary, mathIsCloseAndHasTheRandomNumbersOfTheHost) {
    EXPECT_EQ(run("local function near(a, b) return math.abs(a - b) < 2e-6 * math.max(1, math.abs(b)) end "
                  "assert(near(math.sin(1), 0.8414709848)) assert(near(math.cos(1), 0.5403023059)) "
                  "assert(near(math.tan(1), 1.5574077247)) assert(near(math.asin(0.5), 0.5235987756)) "
                  "assert(near(math.acos(0.5), 1.0471975512)) assert(near(math.atan(1), 0.7853981634)) "
                  "assert(near(math.atan(1, -1), 2.3561944902)) assert(near(math.exp(2), 7.3890560989)) "
                  "assert(near(math.log(10), 2.3025850930)) assert(near(math.log(8, 2), 3)) "
                  "assert(near(math.pow(2, 0.3), 1.2311444133)) assert(math.pow(2, 10) == 1024) "
                  "assert(math.pow(2, -1) == 0.5) assert(math.pow(2, 0.5) == math.sqrt(2)) return 'good'"),
              "good");
    Random same = Random::seeded(5);
    const std::uint32_t first = same.below(6) + 1;
    EXPECT_EQ(run("return math.random(6)"), std::to_string(first));
    EXPECT_EQ(run("for i = 1, 1000 do local r = math.random() assert(r >= 0 and r < 1) "
                  "local n = math.random(-3, 3) assert(n >= -3 and n <= 3) end return 'good'"),
              "good");
    EXPECT_NE(run("return math.random(0)").find("interval is empty"), std::string::npos);
    EXPECT_NE(run("math.randomseed(1)").find("one seed"), std::string::npos);
}

TEST_F(ScriptLibrary, reachesNothingOutside) {
    for (const char* name : {"io", "os", "debug", "package", "require", "load", "loadfile", "loadstring",
                             "dofile", "collectgarbage", "warn", "string.dump", "getmetatable('').__index"}) {
        const std::string result = run(std::string{"return type("} + name + ")");
        EXPECT_TRUE(result == "nil" || result.find("attempt to index") != std::string::npos)
            << name << ": " << result;
    }
    EXPECT_EQ(run("return tostring(getmetatable(''))"), "false");
    EXPECT_NE(run("setmetatable({}, {__gc = function() end})").find("__gc is not available"),
              std::string::npos);
    EXPECT_NE(run("setmetatable({}, {__mode = 'k'})").find("__mode is not available"), std::string::npos);
    EXPECT_NE(run("setmetatable('', {})").find("table expected"), std::string::npos);
    EXPECT_EQ(
        run("local p = setmetatable({}, {__metatable = 1}) return select(2, pcall(setmetatable, p, {}))"),
        "cannot change a protected metatable");
}

TEST_F(ScriptLibrary, repRepeatsATextWithWhatIsBetween) {
    EXPECT_EQ(run(R"(
        for _, text in ipairs({'', 'x', 'ab', 'a\0b', ('0123456789'):sub(1, 7)}) do
            for _, between in ipairs({'', '-', ', '}) do
                for count = -1, 70 do
                    local parts = {}
                    for i = 1, count do parts[i] = text end
                    local expected = table.concat(parts, between)
                    assert(text:rep(count, between) == expected, count .. text .. between)
                    if between == '' then assert(text:rep(count) == expected) end
                end
            end
        end
        return #('abc'):rep(100000, ';')
    )"),
              "399999");
}

}  // namespace
}  // namespace plumb
