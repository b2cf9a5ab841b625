#include "editor/model/debug/script_debugger.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/log.hpp"
#include "core/text.hpp"
#include "ecs/world.hpp"
#include "tests/editor/support/script_game.hpp"

namespace plumb::editor {
namespace {

constexpr const char* kFile = "scripts/counter.lua";

class ScriptDebuggerTest : public ::testing::Test {
protected:
    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) play.step({});
    }
    /// Lets the game play until it stops at a line.
    void playOn(int most = 100) {
        play.setPaused(false);
        for (int i = 0; i < most && !play.paused(); ++i) static_cast<void>(play.advance(1.0 / 60.0, {}));
    }
    [[nodiscard]] int line() const { return debugger.halt() == nullptr ? 0 : debugger.halt()->line; }
    [[nodiscard]] std::int64_t tick() const {
        return debugger.halt() == nullptr ? -1 : debugger.halt()->moment.tick;
    }
    /// The value of a variable of the function that runs.
    [[nodiscard]] std::string variable(std::string_view name, std::size_t frame = 0) const {
        if (debugger.halt() == nullptr || debugger.halt()->frames.size() <= frame) return "(none)";
        for (const ScriptVariable& variable : debugger.halt()->frames[frame].variables) {
            if (variable.name == name) return variable.value;
        }
        return "(none)";
    }
    [[nodiscard]] WatchedField field(std::string_view name) const {
        const TypeInfo* type = game.content.types().find("Counter");
        return {play.find({0xa1}), type, type->find(name)};
    }
    /// The hash of the same game without a debugger.
    [[nodiscard]] std::uint64_t expectedHash(std::int64_t tick) const {
        const std::unique_ptr<PlaySession> plain = game.start();
        for (std::int64_t i = 0; i < tick; ++i) plain->tick({});
        return plain->world().hash();
    }

    ScriptGame game;
    PlayMode play;
    ScriptDebugger debugger{play};
};

TEST_F(ScriptDebuggerTest, stopsAtABreakpointWithTheVariablesAndTheWorldOfTheMoment) {
    play.start(game.start());
    debugger.breakpoints.toggle(kFile, 15);
    playOn();
    ASSERT_NE(debugger.halt(), nullptr);
    EXPECT_EQ(line(), 15);
    EXPECT_EQ(tick(), 1);
    EXPECT_TRUE(play.paused());
    EXPECT_EQ(play.ticks(), 0) << "the tick is not over";
    EXPECT_EQ(debugger.halt()->file, kFile);
    EXPECT_EQ(debugger.halt()->frames[0].function, "onTick");
    EXPECT_EQ(variable("far"), "2");
    EXPECT_EQ(variable("self").find("{count = 1"), 0u) << variable("self");
    EXPECT_EQ(play.find({0xa1}), debugger.halt()->entity);
    playOn();
    EXPECT_EQ(tick(), 1);
    EXPECT_EQ(play.find({0xa2}), debugger.halt()->entity) << "the other entity, in the same tick";
    playOn();
    EXPECT_EQ(tick(), 2);
    EXPECT_EQ(play.ticks(), 1);
    EXPECT_EQ(variable("far"), "4");
}

TEST_F(ScriptDebuggerTest, conditionsAreEvaluatedWithTheVariables) {
    play.start(game.start());
    debugger.breakpoints.set({kFile, 15, "far == 14 and self.hits > 1"});
    playOn();
    ASSERT_NE(debugger.halt(), nullptr);
    EXPECT_EQ(tick(), 7);
    EXPECT_EQ(debugger.halt()->problem, "");
    debugger.breakpoints.set({kFile, 15, "far >"});
    playOn();
    EXPECT_EQ(tick(), 7) << "the next line of this number, of the other entity";
    EXPECT_NE(debugger.halt()->problem, "") << "a condition with an error stops and says so";
    debugger.breakpoints.set({kFile, 15, "far == 2", false});
    EXPECT_FALSE(debugger.breakpoints.anyEnabled());
    playOn(20);
    EXPECT_EQ(debugger.halt(), nullptr);
    EXPECT_FALSE(play.paused());
}

TEST_F(ScriptDebuggerTest, stepsIntoOverAndOutOfFunctions) {
    play.start(game.start());
    debugger.breakpoints.toggle(kFile, 11);
    playOn();
    EXPECT_EQ(line(), 11);
    debugger.stepOver({});
    EXPECT_EQ(line(), 12) << "over the function twice";
    debugger.stepBack();
    EXPECT_EQ(line(), 4) << "the line that ran before";
    EXPECT_EQ(variable("y"), "2");
    EXPECT_EQ(debugger.halt()->frames.size(), 2u);
    EXPECT_EQ(debugger.halt()->frames[0].function, "twice");
    EXPECT_EQ(debugger.halt()->frames[1].function, "onTick");
    EXPECT_EQ(debugger.halt()->frames[1].line, 11);
    EXPECT_EQ(variable("dt", 1).substr(0, 5), "0.016");
    debugger.stepOut({});
    EXPECT_EQ(line(), 12);
    debugger.stepOut({});
    EXPECT_EQ(line(), 9) << "the first line of the next handler: onTick of the other entity";
}

TEST_F(ScriptDebuggerTest, stepsBackVisitTheSameLinesInReverseOrder) {
    play.start(game.start());
    play.setPaused(true);
    std::vector<Halt> forth;
    for (int i = 0; i < 120; ++i) {
        debugger.stepInto({});
        ASSERT_NE(debugger.halt(), nullptr) << i;
        forth.push_back(*debugger.halt());
    }
    std::vector<int> lines;
    for (const Halt& halt : forth) {
        if (halt.moment.tick == 2) lines.push_back(halt.line);
    }
    const std::vector<int> once{9, 10, 11, 2, 3, 4, 12, 15, 16};
    std::vector<int> twice = once;
    twice.insert(twice.end(), once.begin(), once.end());
    EXPECT_EQ(lines, twice);
    for (std::size_t i = forth.size() - 1; i-- > 0;) {
        debugger.stepBack();
        ASSERT_NE(debugger.halt(), nullptr);
        ASSERT_EQ(debugger.halt()->moment, forth[i].moment);
        ASSERT_EQ(debugger.halt()->line, forth[i].line);
        ASSERT_EQ(debugger.halt()->entity, forth[i].entity);
        ASSERT_EQ(variable("far"), [&] {
            for (const ScriptVariable& known : forth[i].frames[0].variables) {
                if (known.name == "far") return known.value;
            }
            return std::string{"(none)"};
        }());
    }
    debugger.stepBack();
    EXPECT_EQ(debugger.halt()->moment, forth[0].moment) << "there is no line before the first";
    EXPECT_NE(debugger.notice(), "");
    for (std::size_t i = 1; i < forth.size(); ++i) {
        debugger.stepInto({});
        ASSERT_EQ(debugger.halt()->moment, forth[i].moment);
    }
}

TEST_F(ScriptDebuggerTest, theGameIsTheSameAsWithoutADebugger) {
    play.start(game.start());
    debugger.breakpoints.set({kFile, 13, "self.hits >= 0"});
    for (int i = 0; i < 40; ++i) {
        playOn();
        ASSERT_NE(debugger.halt(), nullptr);
        if (i % 3 == 0) debugger.stepBack();
        if (i % 5 == 0) debugger.stepOut({});
        debugger.stepOver({});
    }
    debugger.breakpoints.clear();
    playOn(10);
    play.setPaused(true);
    EXPECT_GT(play.ticks(), 30);
    EXPECT_EQ(play.world().hash(), expectedHash(play.ticks()));
    play.seek(20);
    EXPECT_EQ(play.world().hash(), expectedHash(20)) << "the recording too";
}

TEST_F(ScriptDebuggerTest, leavingTheMiddleOfATickRestoresTheTickBefore) {
    play.start(game.start());
    run(9);
    debugger.stepInto({});
    for (int i = 0; i < 4; ++i) debugger.stepOver({});
    ASSERT_NE(debugger.halt(), nullptr);
    play.seek(9);
    EXPECT_EQ(debugger.halt(), nullptr);
    EXPECT_EQ(play.world().hash(), expectedHash(9));
    debugger.stepInto({});
    ASSERT_NE(debugger.halt(), nullptr);
    play.seek(4);
    EXPECT_EQ(play.world().hash(), expectedHash(4));
    EXPECT_EQ(play.newest(), 10);
}

TEST_F(ScriptDebuggerTest, runsBackToTheLineThatChangedAField) {
    play.start(game.start());
    run(50);
    play.setPaused(true);
    ASSERT_TRUE(debugger.runBackToChange(field("hits")));
    EXPECT_EQ(tick(), 48) << "hits grow in every third tick";
    EXPECT_EQ(line(), 13);
    EXPECT_EQ(debugger.halt()->entity, play.find({0xa1}));
    ASSERT_TRUE(debugger.runBackToChange(field("hits")));
    EXPECT_EQ(tick(), 45);
    EXPECT_EQ(line(), 13);
    debugger.stepOver({});
    ASSERT_TRUE(debugger.runBackToChange(field("hits")));
    EXPECT_EQ(tick(), 45) << "the line before, in the same tick";
    EXPECT_EQ(line(), 13);
    EXPECT_FALSE(debugger.runBackToChange(field("stopped")));
    EXPECT_EQ(tick(), 45) << "nothing was found, so it stays";
    EXPECT_NE(debugger.notice().find("was not changed"), std::string::npos);
}

TEST(ScriptDebuggerLog, linesThatRunAgainAreLoggedOnce) {
    const ScriptGame game{{{"counter",
                            "local Counter = script {}\nfunction Counter:onTick()\n"
                            "print('a', world:tick())\nprint('b', world:tick())\nend\n"
                            "return Counter"}}};
    std::vector<std::string> log;
    const LogSink before = setLogSink([&](const LogLine& line) {
        if (line.channel == "Script") log.push_back(line.text);
    });
    {
        PlayMode play;
        ScriptDebugger debugger{play};
        play.start(game.start(R"({"format": 1, "entities": [
            {"id": "00000000000000a1", "components": {"Counter": {}}}]})"));
        debugger.breakpoints.toggle(kFile, 4);
        play.step({});
        EXPECT_EQ(log, (std::vector<std::string>{"a\t1"}));
        debugger.stepBack();
        debugger.stepBack();
        debugger.stepInto({});
        debugger.stepInto({});
        EXPECT_EQ(log.size(), 1u);
        debugger.stepInto({});
        EXPECT_EQ(log, (std::vector<std::string>{"a\t1", "b\t1"}));
        play.step({});
        play.step({});
        EXPECT_EQ(log, (std::vector<std::string>{"a\t1", "b\t1", "a\t2"}));
    }
    setLogSink(before);
}

TEST(ScriptDebuggerErrors, goBackLeadsToTheTickBeforeTheError) {
    const ScriptGame game{{{"counter",
                            "local Counter = script {}\nfunction Counter:onTick()\n"
                            "local n = world:tick()\nif n == 20 then error('twenty') end\nend\n"
                            "return Counter"}}};
    const LogSink before = setLogSink([](const LogLine&) {});
    PlayMode play;
    ScriptDebugger debugger{play};
    play.start(game.start());
    for (int i = 0; i < 40; ++i) play.step({});
    EXPECT_FALSE(debugger.goBackTo(50));
    ASSERT_TRUE(debugger.goBackTo(19));
    EXPECT_EQ(play.ticks(), 19);
    debugger.stepInto({});
    debugger.stepInto({});
    debugger.stepInto({});
    ASSERT_NE(debugger.halt(), nullptr);
    EXPECT_EQ(debugger.halt()->line, 4);
    EXPECT_EQ(debugger.halt()->frames[0].variables[0].value, "20");
    setLogSink(before);
}

TEST(BreakpointFile, keepsLinesConditionsAndWhatIsOff) {
    Breakpoints breakpoints;
    breakpoints.set({"scripts/b.lua", 7, "x > 3", false});
    breakpoints.toggle("scripts/a.lua", 12);
    breakpoints.toggle("scripts/a.lua", 2);
    std::vector<Error> problems;
    const Breakpoints read = Breakpoints::fromJson(breakpoints.toJson(), "breakpoints.json", problems);
    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(read.all(), breakpoints.all());
    EXPECT_EQ(read.all().front().line, 2);
    breakpoints.toggle("scripts/a.lua", 2);
    EXPECT_EQ(breakpoints.find("scripts/a.lua", 2), nullptr);
}

}  // namespace
}  // namespace plumb::editor
