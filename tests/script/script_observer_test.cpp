#include "script/script_observer.hpp"

#include <lua.hpp>

#include "script/script_frames.hpp"
#include "tests/script/script_world.hpp"

namespace plumb {
namespace {

/// Notes lines, and abandons the scripts of the tick at one of them.
class Notes final : public ScriptObserver {
public:
    [[nodiscard]] bool watches() const override { return on; }
    [[nodiscard]] bool abandons() const override { return abandoned; }
    void handlerBegins(EntityId entity, TypeKey) override { entities.push_back(entity); }
    bool onLine(lua_State* coroutine, const char*, int line, int depth) override {
        lines.push_back(line);
        depths.push_back(depth);
        if (line == valueAt) value = script::evaluate(coroutine, expression);
        abandoned = abandoned || line == last;
        return !abandoned;
    }
    void handlerEnds() override { ++ends; }

    bool on = true;
    bool abandoned = false;
    int last = 0;  // line at which the tick is abandoned; 0: none
    int valueAt = 0;
    std::string expression;
    script::Evaluation value;
    std::vector<EntityId> entities;
    std::vector<int> lines, depths;
    int ends = 0;
};

class ScriptObserverTest : public ScriptWorld {
protected:
    ScriptObserverTest() { world.provide(static_cast<ScriptObserver&>(notes)); }
    Notes notes;
};

constexpr const char* kTwice = R"(local function twice(x)
    return x * 2
end
function Thing:onTick()
    self.n = twice(self.n + 1)
    wait(0)
    self.n = self.n + 100
end)";

TEST_F(ScriptObserverTest, seesTheLinesOfHandlersWithTheirDepth) {
    const EntityId entity = thing(kTwice, "n = number {}");
    run();
    // Line 1 is that of the declaration.
    EXPECT_EQ(notes.lines, (std::vector<int>{5, 6, 2, 3, 7}));
    EXPECT_EQ(notes.depths, (std::vector<int>{1, 1, 2, 2, 1}));
    EXPECT_EQ(notes.entities, std::vector<EntityId>{entity});
    EXPECT_EQ(notes.ends, 1) << "it waits";
    notes.lines.clear();
    run();
    EXPECT_EQ(notes.lines, (std::vector<int>{8, 9, 5, 6, 2, 3, 7})) << "it goes on, ends and begins again";
    EXPECT_EQ(notes.ends, 3);
}

TEST_F(ScriptObserverTest, thatDoesNotWatchLeavesNoHook) {
    const EntityId entity = thing(kTwice, "n = number {}");
    run();
    notes.on = false;
    notes.lines.clear();
    run(10);
    EXPECT_TRUE(notes.lines.empty());
    EXPECT_GT(property<float>(entity, "n"), 100.0f);
}

TEST_F(ScriptObserverTest, abandonedScriptsReportNoErrorAndAreNotStopped) {
    const EntityId first = thing(
        "function Thing:onTick()\n"
        "    pcall(function()\n"
        "        self.n = 1\n"
        "    end)\n"
        "    self.n = 2\n"
        "end",
        "n = number {}");
    const EntityId second = add("Thing");
    notes.last = 4;
    run();
    EXPECT_EQ(property<float>(first, "n"), 0.0f) << "pcall() does not help";
    EXPECT_EQ(property<float>(second, "n"), 0.0f) << "no other handler begins";
    EXPECT_FALSE(property<bool>(first, "stopped"));
    EXPECT_EQ(logText(), "");
    EXPECT_EQ(notes.entities.size(), 1u);
}

TEST_F(ScriptObserverTest, expressionsSeeVariablesPropertiesAndGlobals) {
    const auto valueOf = [&](const char* expression) {
        notes.expression = expression;
        notes.valueAt = 8;
        run(2);
        return notes.value.problem.empty() ? notes.value.value : "problem: " + notes.value.problem;
    };
    thing(kTwice, "n = number {}");
    EXPECT_EQ(valueOf("self.n > 1"), "true");
    EXPECT_EQ(valueOf("twice(21)"), "42") << "a variable of the file";
    EXPECT_EQ(valueOf("math.floor(2.5)"), "2");
    EXPECT_EQ(valueOf("nothing"), "nil");
    EXPECT_EQ(valueOf("{1, 2, x = 'a'}"), "{1, 2, x = \"a\"}");
    EXPECT_EQ(valueOf("self.n >").find("problem: "), 0u);
    EXPECT_NE(valueOf("(function() while true do end end)()").find("too long"), std::string::npos);
    EXPECT_EQ(logText(), "");
}

}  // namespace
}  // namespace plumb
