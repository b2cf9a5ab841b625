#include <string>

#include "script/library/work.hpp"
#include "tests/script/script_world.hpp"

namespace plumb {
namespace {

// How much a handler may do: numbers of rounds, not times, so they are the same on every machine.

class ScriptWork : public ScriptWorld {
protected:
    /// Runs a handler that never ends, which counts its rounds in thousands. @return the rounds
    double roundsOf(const std::string& text) {
        const EntityId entity = thing("function Thing:onTick() local n, keep = 0 while true do " + text +
                                          " n = n + 1 if n % 1000 == 0 then self.count = n end end end",
                                      "count = 0");
        run();
        EXPECT_TRUE(property<bool>(entity, "stopped")) << text;
        const double rounds = property<float>(entity, "count");
        world.destroy(entity);
        return rounds;
    }
};

TEST_F(ScriptWork, limitsTablesAndTextsThatAreGarbageAtOnce) {
    const auto most = static_cast<double>(script::Work::kMax);
    constexpr double kBlock = 14.0;  // units of a block, without its bytes
    for (const char* text : {"keep = {}", "keep = { n }", "keep = { a = n }", "keep = 'x' .. n",
                             "keep = function() return n end"}) {
        log.clear();
        const double rounds = roundsOf(text);
        EXPECT_LT(rounds, most / kBlock) << text;
        EXPECT_GT(rounds, 200e3) << text;
        ASSERT_EQ(log.size(), 1u) << logText();
        EXPECT_NE(log[0].find("too much work"), std::string::npos) << log[0];
    }
}

TEST_F(ScriptWork, saysWhatAHandlerMakesTooManyOf) {
    for (const char* text : {"keep = {}", "keep = ('x'):rep(1000) .. 'y'"}) {
        log.clear();
        const EntityId entity =
            thing(std::string{"function Thing:onTick() local keep while true do "} + text + " end end");
        run();
        ASSERT_EQ(log.size(), 1u) << logText();
        EXPECT_NE(log[0].find("scripts/thing.lua:2: it makes too many tables and texts"), std::string::npos)
            << log[0];
        EXPECT_TRUE(property<bool>(entity, "stopped"));
        world.destroy(entity);
    }
}

TEST_F(ScriptWork, limitsTheBytesOfTexts) {
    const auto bytes = static_cast<double>(script::Work::kMax) * 8.0;
    for (const double length : {1e4, 1e6}) {
        log.clear();
        const std::string size = std::to_string(static_cast<int>(length));
        const double rounds =
            roundsOf("keep = ('x'):rep(" + size + ") n = n + 999");  // each round counts as a thousand
        EXPECT_LT(rounds / 1000.0, bytes / length) << length;
        EXPECT_GT(rounds / 1000.0, bytes / length / 4.0) << length;
    }
}

TEST_F(ScriptWork, isEnoughForMuchInOneTick) {
    const EntityId entity = thing(R"(
        function Thing:onTick()
            local all = {}
            for i = 1, 10000 do all[i] = { x = i, y = i, name = "place " .. i } end
            local parts = {}
            for i = 1, 10000 do parts[i] = ("line %06d: some text, of one hundred bytes with its end"):format(i) end
            local text = table.concat(parts, "\n")
            for i = 1, 4 do text = text .. text end
            assert(#text > 1000000)
            self.count = self.count + #all
        end
    )",
                                  "count = 0");
    run(3);
    EXPECT_EQ(logText(), "");
    EXPECT_EQ(property<float>(entity, "count"), 30000.0f);
}

TEST_F(ScriptWork, tellsTheEndOfTheMemoryFromThatOfTheWork) {
    roundsOf("keep = { keep, n, n, n, n, n, n, n, n, n, n, n, n, n, n, n, n }");
    ASSERT_EQ(log.size(), 1u) << logText();
    EXPECT_NE(log[0].find("not enough memory"), std::string::npos) << log[0];
}

}  // namespace
}  // namespace plumb
