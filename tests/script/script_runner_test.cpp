#include "script/script_runner.hpp"

#include "ecs/paused.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "tests/script/script_world.hpp"
#include "tests/support/allocations.hpp"

namespace plumb {
namespace {

using Scripts = ScriptWorld;

TEST_F(Scripts, runOnCreateOnceAndOnTickInEveryTick) {
    const EntityId entity = thing(R"(
        function Thing:onCreate() self.transform.x = 100 end
        function Thing:onTick(dt) self.transform.x = self.transform.x + self.speed * dt end
    )",
                                  "speed = number { 60, min = 0, unit = 'px/s' }");
    ASSERT_TRUE(problems.empty()) << problems[0].text();
    run();
    EXPECT_FLOAT_EQ(x(entity), 101.0f);
    run(10);
    EXPECT_FLOAT_EQ(x(entity), 111.0f);
    EXPECT_EQ(logText(), "");
}

TEST_F(Scripts, createNoStateWithoutAScript) {
    use({{"thing", "local Thing = script {} return Thing"}});
    run(3);
    EXPECT_EQ(world.findResource<ScriptState>(), nullptr);
    add("Thing");
    run();
    EXPECT_NE(world.findResource<ScriptState>(), nullptr);
}

TEST_F(Scripts, declarePropertiesAsFieldsInTheirOrder) {
    use({{"thing", R"(return script {
        doc = "Does things.",
        zeal = number { 2.5, min = 1, max = 3, unit = "px/s", doc = "How fast." },
        count = integer { 7 },
        alive = boolean(true),
        title = text("Hello"),
        at = vector(vec(1, 2)),
        tint = color("#ff8000"),
        target = entity {},
        mode = choice { "walk", "fly" },
        picture = texture {},
        ways = list(vector {}, 3),
        plain = 4,
    })"}});
    ASSERT_TRUE(problems.empty()) << problems[0].text();
    const TypeInfo* type = types.find("Thing");
    ASSERT_NE(type, nullptr);
    EXPECT_EQ(type->doc, "Does things.");
    std::string names;
    for (const FieldInfo& field : type->fields) names += std::string{field.name} + " ";
    EXPECT_EQ(names, "stopped plain zeal count alive title at tint target mode picture ways ");
    EXPECT_EQ(type->find("zeal")->unit, Unit::PixelsPerSecond);
    EXPECT_EQ(type->find("zeal")->max, 3.0f);
    EXPECT_EQ(type->find("ways")->capacity, 3u);
    EXPECT_EQ(type->find("ways")->element, FieldKind::Vec2);
    EXPECT_EQ(type->find("mode")->names.size(), 2u);
    const EntityId entity = add("Thing");
    run();
    EXPECT_EQ(property<float>(entity, "zeal"), 2.5f);
    EXPECT_EQ(property<std::int64_t>(entity, "count"), 7);
    EXPECT_TRUE(property<bool>(entity, "alive"));
    EXPECT_EQ(world.texts().find(property<TextId>(entity, "title")), "Hello");
    EXPECT_EQ(property<Vec2>(entity, "at"), (Vec2{1.0f, 2.0f}));
    EXPECT_EQ(property<Color>(entity, "tint"), (Color{255, 128, 0, 255}));
    EXPECT_EQ(property<float>(entity, "plain"), 4.0f);
}

TEST_F(Scripts, refuseWrongDeclarationsWithFileAndRemedy) {
    const std::pair<const char*, const char*> cases[] = {
        {"return script { a = {} }", "a table is not a property"},
        {"return script { a = number { 'x' } }", "Thing.a: expected a number, found a string"},
        {"return script { a = number { 1, unit = 'mm' } }", "unknown unit"},
        {"return script { a = choice {} }", "a choice needs names"},
        {"return script { a = list(number {}, 65) }", "a list has 1 to 64 items"},
        {"return script(4)", "table expected, got number"},
        {"local a = script {} return script {}", "a file declares one component"},
        {"x = = 1", "unexpected symbol near '='"},
        {"while true do end", "more than a million rounds"},
        {"script { a = 1 }", "the file must end with `return`"},
        {"return script { a = number { 1, maxx = 3 } }", "unknown option \"maxx\""},
        {"return script { a = number { 1, min = 5, max = 3 } }", "min is larger than max"},
        {"return script { entity = 1 }", "every script has this name"},
        {"return script { entity = number { 1 } }", "every script has this name"},
        {"return script { a = spawn('x', vec(0, 0)) }", "the world is not available while a file is loaded"}};
    for (const auto& [text, expected] : cases) {
        use({{"thing", text}});
        ASSERT_EQ(problems.size(), 1u) << text;
        EXPECT_NE(problems[0].text().find(expected), std::string::npos) << text << ": " << problems[0].text();
        EXPECT_EQ(problems[0].where.find("scripts/thing.lua"), 0u) << problems[0].text();
        EXPECT_EQ(types.find("Thing"), nullptr);
    }
}

TEST_F(Scripts, limitNumbersToTheirRangeAndRefuseOtherTypes) {
    const EntityId entity = thing(R"(
        function Thing:onTick()
            self.speed = 500
            assert(self.speed == 100)
            local ok, message = pcall(function() self.speed = "fast" end)
            self.message = message
        end
    )",
                                  "speed = number { 1, max = 100 }, message = text('')");
    run();
    EXPECT_EQ(property<float>(entity, "speed"), 100.0f);
    EXPECT_EQ(world.texts().find(property<TextId>(entity, "message")),
              "scripts/thing.lua:6: Thing.speed: expected a number, found a string");
}

TEST_F(Scripts, accessComponentsOfTheirEntity) {
    const EntityId entity = thing(R"(
        function Thing:onCreate()
            assert(self.sprite == nil)
            local sprite = self.entity:add("Sprite", { tint = "#ff000080", layer = 3 })
            assert(sprite == self.sprite and sprite.tint == "#ff000080")
            self.transform.position = self.transform.position + vec(1, 2) * 2
            assert(self.transform.position == vec(2, 4) and self.transform.y == 4)
            assert(self.entity:has("Sprite") and not self.entity:has("RigidBody"))
            self.entity:remove("Sprite")
            assert(self.sprite == nil)
            local ok, message = pcall(function() return sprite.tint end)
            assert(message:find("no longer has the component Sprite"), message)
            ok, message = pcall(function() return self.transform.positon end)
            assert(message:find('Transform has no field "positon"; did you mean "position"?', 1, true), message)
            ok, message = pcall(function() self.entity:add("Sprit") end)
            assert(message:find('no component "Sprit"; did you mean "Sprite"?', 1, true), message)
            self.found = findEntity("Anna") == self.entity
        end
    )",
                                  "found = false");
    run();
    EXPECT_EQ(logText(), "");
    EXPECT_TRUE(property<bool>(entity, "found"));
}

TEST_F(Scripts, waitInHandlers) {
    const EntityId entity = thing(R"(
        function Thing:onCreate()
            self.step = 1
            wait()
            self.step = 2
            wait(0.1)
            self.step = 3
            waitUntil(function() return self.open end)
            self.step = 4
            local by, how = waitFor("hit")
            self.step = by + how
        end
    )",
                                  "step = 0, open = false");
    const auto step = [&] { return property<float>(entity, "step"); };
    run();
    EXPECT_EQ(step(), 1.0f);
    run();
    EXPECT_EQ(step(), 2.0f);
    run(5);
    EXPECT_EQ(step(), 2.0f);
    run();
    EXPECT_EQ(step(), 3.0f);
    run(20);
    EXPECT_EQ(step(), 3.0f);
    *static_cast<bool*>(types.find("Thing")->find("open")->in(world.find(*types.find("Thing"), entity))) =
        true;
    run();
    EXPECT_EQ(step(), 4.0f);
    ScriptEvent hit;
    hit.name = world.texts().add("hit");
    hit.add({ScriptValue::Kind::Integer, 20});
    hit.add({ScriptValue::Kind::Integer, 5});
    world.beginTick();
    world.emit(hit);
    world.update(1.0f / 60.0f);
    EXPECT_EQ(step(), 25.0f);
    EXPECT_EQ(logText(), "");
}

TEST_F(Scripts, doNotCallOnTickWhileItWaits) {
    const EntityId entity = thing(R"(
        function Thing:onTick() self.calls = self.calls + 1 wait(0.1) end
    )",
                                  "calls = 0");
    run(13);
    EXPECT_EQ(property<float>(entity, "calls"), 3.0f) << "in ticks 1, 7 and 13";
}

TEST_F(Scripts, receiveContactsOfBothSides) {
    thing(R"(
        function Thing:onCollisionEnter(other, contact)
            self.hits = self.hits + 1
            self.up = contact.normal.y
            self.isFloor = other:has("RigidBody") == false
        end
    )",
          "hits = 0, up = 0, isFloor = false");
    const EntityId box = add("Thing", {0.0f, -20.0f});
    world.add<RigidBody>(box);
    world.add<BoxCollider>(box, 10.0f, 10.0f);
    const EntityId floor = world.createEntity().id();
    world.add<Transform>(floor, Vec2{-50.0f, 0.0f});
    world.add<BoxCollider>(floor, 100.0f, 10.0f);
    run(60);
    EXPECT_EQ(property<float>(box, "hits"), 1.0f);
    EXPECT_NEAR(property<float>(box, "up"), 1.0f, 1e-3f) << "from the box towards the floor";
    EXPECT_TRUE(property<bool>(box, "isFloor"));
    EXPECT_EQ(logText(), "");
}

TEST_F(Scripts, handleAnOverlapOfTwoTriggersOnce) {
    thing(R"(
        function Thing:onTriggerEnter(other) self.hits = self.hits + 1 end
    )",
          "hits = 0");
    const EntityId entity = add("Thing");
    for (const EntityId id : {entity, add("Thing")}) {
        world.add<RigidBody>(id).gravityScale = 0.0f;
        world.add<BoxCollider>(id, 10.0f, 10.0f).isTrigger = true;
    }
    run(5);
    EXPECT_EQ(property<float>(entity, "hits"), 1.0f);
    EXPECT_EQ(logText(), "");
}

TEST_F(Scripts, warnOfNamesThatAreNearlyHandlers) {
    thing("function Thing:OnTick() end function Thing:onUpdate() end function Thing:onHit() end");
    run();
    ASSERT_EQ(log.size(), 2u) << logText();
    EXPECT_EQ(log[0], "scripts/thing.lua: the engine does not call \"OnTick\"; name the function onTick");
}

TEST_F(Scripts, exchangeEvents) {
    use({{"ball", R"(local Ball = script {}
        function Ball:onTick() emit("score", 10, self.entity) emitAfter(0.05, "late", "x") end
        return Ball)"},
         {"board", R"(local Board = script { score = 0, from = entity {}, late = 0 }
        function Board:onEvent_score(by, from) self.score = self.score + by self.from = from end
        function Board:onEvent_late(text) assert(text == "x") self.late = self.late + 1 end
        return Board)"}});
    const EntityId ball = add("Ball");
    const EntityId board = add("Board");
    run(4);
    EXPECT_EQ(property<float>(board, "score", "Board"), 40.0f);
    EXPECT_EQ(property<EntityId>(board, "from", "Board"), ball);
    EXPECT_EQ(property<float>(board, "late", "Board"), 1.0f);
    EXPECT_EQ(logText(), "");
}

TEST_F(Scripts, receiveEventsOfCode) {
    const EntityId entity = thing(R"(
        function Thing:onEvent_hit(by, from, where)
            assert(by == 2.5 and from == self.entity and where == vec(3, 4))
            self.hits = self.hits + 1
        end
        function Thing:onEvent_word(text, yes, count) self.word = text .. tostring(yes) .. count end
    )",
                                  "hits = 0, word = ''");
    run();
    world.beginTick();
    world.emit(scriptEvent(world, "hit", 2.5f, entity, Vec2{3.0f, 4.0f}));
    world.emit(scriptEvent(world, "word", "ab", true, 7));
    world.update(1.0f / 60.0f);
    EXPECT_EQ(property<float>(entity, "hits"), 1.0f);
    EXPECT_EQ(world.texts().find(property<TextId>(entity, "word")), "abtrue7");
    EXPECT_EQ(logText(), "");
}

TEST_F(Scripts, callFunctionsOfOtherScripts) {
    use({{"door", R"(local Door = script { open = false }
        function Door:unlock() self.open = true return "done" end
        return Door)"},
         {"key", R"(local Key = script { door = entity {} }
        function Key:onTick() assert(self.door.door:unlock() == "done" and self.door.door.open) end
        return Key)"}});
    const EntityId door = add("Door");
    const EntityId key = add("Key");
    std::memcpy(types.find("Key")->find("door")->in(world.find(*types.find("Key"), key)), &door, sizeof door);
    run();
    EXPECT_TRUE(property<bool>(door, "open", "Door"));
    EXPECT_EQ(logText(), "");
}

TEST_F(Scripts, shareFilesByRequire) {
    use({{"util", "local util = {} function util.twice(x) return 2 * x end return util"},
         {"thing", R"(local util = require("util")
        local Thing = script { value = 0 }
        function Thing:onTick() self.value = util.twice(21) end
        return Thing)"}});
    ASSERT_TRUE(problems.empty()) << problems[0].text();
    const EntityId entity = add("Thing");
    run();
    EXPECT_EQ(property<float>(entity, "value"), 42.0f);
    use({{"thing", "local a = require('nothing') return script {}"}});
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_NE(problems[0].text().find("there is no file \"scripts/nothing.lua\""), std::string::npos);
}

TEST_F(Scripts, stopAtAnErrorThatSaysWhere) {
    const EntityId entity = thing(R"(
        local function deeper(x) return x.y.z end
        function Thing:onTick()
            self.calls = self.calls + 1
            local speed, name = 40, "Bob"
            deeper({ a = 1 })
        end
    )",
                                  "calls = 0");
    run(5);
    EXPECT_EQ(property<float>(entity, "calls"), 1.0f);
    EXPECT_TRUE(property<bool>(entity, "stopped"));
    ASSERT_EQ(log.size(), 1u);
    EXPECT_EQ(log[0].find("scripts/thing.lua:3: attempt to index a nil value (field 'y') (in \"Anna\")"), 0u)
        << log[0];
    EXPECT_NE(log[0].find("in onTick at scripts/thing.lua:7"), std::string::npos) << log[0];
    EXPECT_NE(log[0].find("with x = {a = 1}"), std::string::npos) << log[0];
}

TEST_F(Scripts, stopWhatNeverEndsAndWhatNeedsTooMuchMemory) {
    const EntityId endless = thing("function Thing:onTick() while true do end end");
    run(2);
    ASSERT_EQ(log.size(), 1u);
    EXPECT_NE(log[0].find("scripts/thing.lua:2: it takes more than a million rounds"), std::string::npos)
        << log[0];
    EXPECT_TRUE(property<bool>(endless, "stopped"));
    world.destroy(endless);
    log.clear();
    const EntityId busy =
        thing("function Thing:onTick() while true do self.transform.position = vec(1, 2) * 0.5 end end");
    run(2);
    ASSERT_EQ(log.size(), 1u) << logText();
    EXPECT_NE(log[0].find("scripts/thing.lua:2: the script does too much work"), std::string::npos) << log[0];
    EXPECT_TRUE(property<bool>(busy, "stopped"));
    world.destroy(busy);
    log.clear();
    const EntityId greedy = thing(
        "function Thing:onTick() local t = {} for i = 1, 900000 do t[i] = {i, i, i, i, i, i, i, i} end end");
    run(2);
    ASSERT_EQ(log.size(), 1u) << logText();
    EXPECT_NE(log[0].find("not enough memory"), std::string::npos) << log[0];
    EXPECT_TRUE(property<bool>(greedy, "stopped"));
    world.destroy(greedy);
    log.clear();
    const EntityId other = thing("function Thing:onTick() self.calls = self.calls + 1 end", "calls = 0");
    run(3);
    EXPECT_EQ(property<float>(other, "calls"), 3.0f);
}

TEST_F(Scripts, reloadKeepsPropertiesFieldsAndWaitingHandlers) {
    const EntityId entity = thing(R"(
        function Thing:onCreate() self.secret = 5 wait(0.5) self.step = self.step + self.secret end
        function Thing:onTick() self.speed = self.speed + 1 end
    )",
                                  "speed = 10, step = 0");
    run(3);
    EXPECT_EQ(property<float>(entity, "speed"), 13.0f);
    use({{"thing", R"(local Thing = script { step = 0, extra = 7, speed = 10 }
        function Thing:onCreate() error("not again") end
        function Thing:onReload() self.extra = self.extra + self.secret end
        function Thing:onTick() self.speed = self.speed + 100 end
        return Thing)"}});
    run();
    EXPECT_EQ(property<float>(entity, "speed"), 113.0f);
    EXPECT_EQ(property<float>(entity, "extra"), 12.0f);
    run(60);
    EXPECT_EQ(property<float>(entity, "step"), 5.0f) << "the handler that waited went on";
    EXPECT_EQ(logText(), "");
}

TEST_F(Scripts, keepTheOldVersionOfAFileWithAnError) {
    const EntityId entity = thing("function Thing:onTick() self.calls = self.calls + 1 end", "calls = 0");
    run();
    use({{"thing", "local Thing = script {"}});
    ASSERT_EQ(problems.size(), 1u);
    run();
    EXPECT_EQ(property<float>(entity, "calls"), 2.0f);
}

TEST_F(Scripts, goOnAfterTheErrorIsMended) {
    const EntityId entity = thing("function Thing:onTick() error('oh') end", "calls = 0");
    run(2);
    EXPECT_TRUE(property<bool>(entity, "stopped"));
    use({{"thing",
          "local Thing = script { calls = 0 } function Thing:onTick() self.calls = self.calls + 1 end return "
          "Thing"}});
    run(2);
    EXPECT_EQ(property<float>(entity, "calls"), 2.0f);
}

TEST_F(Scripts, restoreLocalsAndWaitsFromSnapshots) {
    thing(R"(
        function Thing:onCreate()
            local secret = 0
            while true do
                secret = secret + math.random(1, 6)
                self.total = secret
                wait(0.05 + secret % 3 * 0.02)
            end
        end
    )",
          "total = 0");
    for (int i = 0; i < 20; ++i) add("Thing");
    run(10);
    std::vector<std::uint64_t> hashes;
    const Snapshot snapshot = world.save();
    for (int i = 0; i < 50; ++i) run(), hashes.push_back(world.hash());
    for (int round = 0; round < 3; ++round) {
        world.restore(snapshot);
        for (int i = 0; i < 50; ++i) {
            run();
            ASSERT_EQ(world.hash(), hashes[static_cast<std::size_t>(i)]) << round << " " << i;
        }
    }
    EXPECT_EQ(logText(), "");
}

TEST_F(Scripts, allocateNothingInSteadyTicks) {
    use({{"thing", R"(local Thing = script { speed = 40, hits = 0 }
        function Thing:onTick(dt)
            local x = self.transform.x + self.speed * dt
            if x > 100 then self.speed = -self.speed end
            self.transform.position = self.transform.position + vec(self.speed * dt, 0)
            emit("hit", self.entity, 1)
            local text = "at " .. x
        end
        function Thing:onEvent_hit(by, count) self.hits = self.hits + count wait(0.05) end
        return Thing)"}});
    for (int i = 0; i < 20; ++i) add("Thing");
    run(120);
    const std::size_t before = test::allocations().made;
    run(120);
    EXPECT_EQ(test::allocations().made, before);
    EXPECT_EQ(logText(), "");
}

TEST_F(Scripts, endWithTheirEntities) {
    const EntityId entity = thing("function Thing:onTick() emit('tick') wait(1) emit('tick') end");
    run(3);
    world.destroy(entity);
    run(3);
    const ScriptState& state = *world.findResource<ScriptState>();
    EXPECT_TRUE(state.waits.empty());
    EXPECT_FALSE(state.hasInstances());
    EXPECT_FALSE(hasScripts(world));
}

TEST_F(Scripts, restWhileTheirEntityIsPaused) {
    const EntityId entity = thing("function Thing:onTick() self.calls = self.calls + 1 end", "calls = 0");
    run(2);
    world.add<Paused>(entity);
    run(3);
    EXPECT_EQ(property<float>(entity, "calls"), 2.0f);
    world.remove<Paused>(entity);
    run(1);
    EXPECT_EQ(property<float>(entity, "calls"), 3.0f);
}

TEST_F(Scripts, boundEventsThatCauseOneAnother) {
    thing("function Thing:onCreate() emit('a') end function Thing:onEvent_a() emit('a') end");
    run();
    ASSERT_EQ(log.size(), 1u);
    EXPECT_EQ(log[0].find("event \"a\": more than 10,000 events in a tick"), 0u) << log[0];
}

TEST_F(Scripts, refuseToWaitInOwnCoroutines) {
    thing(R"(function Thing:onTick() coroutine.wrap(function() wait(1) end)() end)");
    run();
    ASSERT_EQ(log.size(), 1u);
    EXPECT_NE(log[0].find("wait() works in handlers"), std::string::npos) << log[0];
}

}  // namespace
}  // namespace plumb
