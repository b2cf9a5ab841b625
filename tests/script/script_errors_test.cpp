#include "script/script_errors.hpp"

#include "core/text.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "script/script_handlers.hpp"
#include "tests/script/script_world.hpp"

namespace plumb {
namespace {

class ScriptErrors : public ScriptWorld {
protected:
    /// Calls a function body once in onCreate. @return the message that it has stopped with
    std::string errorOf(const std::string& body, const std::string& properties = "") {
        log.clear();
        const EntityId entity = thing("function Thing:onCreate() " + body + " end", properties);
        world.add<Sprite>(entity);
        run();
        world.destroy(entity);
        run();
        return log.empty() ? std::string{} : log[0];
    }
    void expectError(const std::string& body, const std::string& expected,
                     const std::string& properties = "") {
        const std::string message = errorOf(body, properties);
        EXPECT_NE(message.find(expected), std::string::npos) << body << ": " << message;
        EXPECT_EQ(message.find("scripts/thing.lua:2: "), 0u) << body << ": " << message;
    }
};

TEST_F(ScriptErrors, ofManyEntitiesInTheSameLineAreWrittenOnceAndCounted) {
    thing("function Thing:onTick()\nif self.first then error('one') end\nerror('two') end", "first = false");
    for (int i = 0; i < 999; ++i) add("Thing");
    const EntityId other = add("Thing");
    *static_cast<bool*>(types.find("Thing")->find("first")->in(world.find(*types.find("Thing"), other))) =
        true;
    run(3);
    ASSERT_EQ(log.size(), 3u) << logText().substr(0, 1000);
    EXPECT_EQ(log[0].find("scripts/thing.lua:4: two (in \"Anna\")"), 0u) << log[0];
    EXPECT_EQ(log[1].find("scripts/thing.lua:3: one (in \"Anna\")"), 0u) << log[1];
    EXPECT_EQ(log[2].find("scripts/thing.lua:4: the same line has stopped the scripts of 999 more entities"),
              0u)
        << log[2];
    EXPECT_TRUE(property<bool>(other, "stopped"));
}

TEST_F(ScriptErrors, ofEventHandlersAreCountedToo) {
    thing(
        "function Thing:onTick() if world:tick() == 1 then emit('bang') end end\n"
        "function Thing:onEvent_bang() error('oh') end");
    add("Thing");
    run(2);
    ASSERT_EQ(log.size(), 2u) << logText();
    EXPECT_EQ(log[1].find("scripts/thing.lua:3: the same line has stopped the script of one more entity"), 0u)
        << log[1];
}

TEST_F(ScriptErrors, sayThatAFunctionCallsItselfWithoutEnd) {
    for (const char* text :
         {"local function f() return 1 + f() end function Thing:onTick() f() end",
          "local function f(n) local t = {n, n} return f(n + 1) + #t end function Thing:onTick() f(1) end",
          "function Thing:f() self:f() self:f() end function Thing:onTick() self:f() end",
          "local t = setmetatable({}, {__index = function(t, k) return t[k + 1] end})"
          "function Thing:onTick() print(t[1]) end"}) {
        log.clear();
        const EntityId entity = thing(text);
        run(2);
        EXPECT_TRUE(property<bool>(entity, "stopped")) << text;
        world.destroy(entity);
        ASSERT_EQ(log.size(), 1u) << text << "\n" << logText();
        EXPECT_EQ(log[0].find("scripts/thing.lua:2: "), 0u) << log[0];
        EXPECT_NE(log[0].find("stack overflow"), std::string::npos) << log[0];
    }
}

TEST_F(ScriptErrors, nameTheHandlerThatAScriptWouldAssignInVain) {
    expectError("self.onTick = function() end",
                "self.onTick would never be called: handlers are functions of the file, function "
                "Thing:onTick(...)");
    expectError("self.onEvent_hit = function() end", "function Thing:onEvent_hit(...)");
    EXPECT_EQ(errorOf("self.once = function() end self.once()"), "") << "other functions may be assigned";
}

TEST_F(ScriptErrors, warnOfFunctionsThatSeemToBeHandlers) {
    const std::pair<const char*, const char*> cases[] = {
        {"OnTick", "onTick"},
        {"onUpdate", "onTick"},
        {"onStart", "onCreate"},
        {"onColisionEnter", "onCollisionEnter"},
        {"onTriggerEntered", "onTriggerEnter"},
        {"onDestroyed", "onDestroy"},
        {"onEventScore", "onEvent_score"},
        {"OnEvent_score", "onEvent_score"},
        {"onTik", "onTick"},
        {"onTcik", "onTick"},
        {"onCreat", "onCreate"},
        {"onTick", ""},
        {"onRoad", ""},
        {"onKick", ""},
        {"onEvent_score", ""},
        {"onHit", ""},
        {"onClick", ""},
        {"only", ""},
        {"update", ""},
    };
    for (const auto& [name, meant] : cases) EXPECT_EQ(handlerMeant(name), meant) << name;
    for (const std::string_view name : kScriptHandlers) EXPECT_TRUE(isHandlerName(name)) << name;
}

TEST_F(ScriptErrors, ofFunctionsSayWhatTheyExpect) {
    expectError("playSound(nil)", "path of a sound expected, got nil; a property of the kind sound is nil");
    expectError("playSound(self.noise)", "path of a sound expected, got nil", "noise = sound {}");
    expectError("tween(self.transform, { positon = vec(1, 2) }, 1)",
                "Transform has no field \"positon\"; did you mean \"position\"?");
    expectError("tween(self.transform, { 5 }, 1)", "the names of fields expected");
    expectError("tween(self, { count = 5 }, 1)",
                "Thing.count: a whole number cannot change gradually; declare it as number {...}",
                "count = integer { 1 }");
    expectError("tween(self.transform, { x = 'far' }, 1)", "Transform.x: expected a number, found a string");
    expectError("self.entity:add('Transform', { x = 3 })",
                "Transform has no field \"x\"; write position = vec(x, y)");
    expectError("waitUntil(function() wait(1) return true end)",
                "wait() cannot wait inside of a function that the engine calls for an answer");
}

TEST_F(ScriptErrors, ofValuesThatAreNotFiniteSaySo) {
    const char* calls[] = {"wait(%s)",
                           "waitFor('x', %s)",
                           "emitAfter(%s, 'x')",
                           "tween(self.transform, { rotation = 1 }, %s)",
                           "playSound('a.wav', %s)",
                           "shakeCamera(%s, 1)",
                           "shakeCamera(1, %s)",
                           "castRay(vec(%s, 0), vec(1, 0))",
                           "castRay(vec(0, 0), vec(0, %s))",
                           "overlapBox(vec(%s, 0), vec(1, 1))",
                           "overlapBox(vec(0, 0), vec(1, %s))",
                           "spawn('prefabs/a', vec(%s, 0))",
                           "teleport(self, vec(0, %s))",
                           "applyImpulse(self, vec(%s, 0))",
                           "world:createEntity(vec(0, %s))"};
    const std::pair<const char*, const char*> values[] = {
        {"0/0", "nan, e.g. 0/0"}, {"1/0", "infinity, e.g. 1/0"}, {"-1e300", "infinity, e.g. 1/0"}};
    for (const std::string call : calls) {
        for (const auto& [value, expected] : values) {
            std::string text = call;
            text.replace(text.find("%s"), 2, value);
            expectError(text, expected);
            expectError(text, " expected, got ");
        }
    }
}

}  // namespace
}  // namespace plumb
