#include "script/values/self.hpp"

#include <vector>

#include "core/random.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "tests/script/script_world.hpp"

namespace plumb {
namespace {

using ScriptSelf = ScriptWorld;

TEST_F(ScriptSelf, saysThatAComponentIsGoneWhateverWasReadBefore) {
    thing(R"(
        function Thing:onCreate()
            for i = 1, 3 do
                assert(self.sprite == nil and self.sprite == nil)
                local sprite = self.entity:add("Sprite", { layer = i })
                assert(self.sprite == sprite and self.sprite.layer == i)
                self.entity:remove("Sprite")
                local ok, message = pcall(function() return sprite.layer end)
                assert(not ok and message:find("no longer has the component Sprite"), message)
                ok, message = pcall(function() sprite.layer = 3 end)
                assert(not ok and message:find("no longer has the component Sprite"), message)
            end
        end
    )");
    run();
    EXPECT_EQ(logText(), "");
}

TEST_F(ScriptSelf, readsMoreComponentsThanItKeeps) {
    const std::vector<std::string> kinds{"Transform", "Sprite",      "Camera",
                                         "RigidBody", "BoxCollider", "Label"};
    std::string names;
    for (const std::string& type : kinds) {
        ASSERT_NE(this->types.find(type), nullptr) << type;
        names += "\"" + type + "\", ";
    }
    thing("local names = { " + names + R"(}
        function Thing:onTick()
            for _, name in ipairs(names) do
                if not self.entity:has(name) then self.entity:add(name) end
            end
            for round = 1, 3 do
                for _, name in ipairs(names) do
                    local key = name:sub(1, 1):lower() .. name:sub(2)
                    assert(tostring(self[key]) == name, name)
                    assert(self[key] == self.entity:get(name), name)
                end
            end
        end
    )");
    add("Thing", {5.0f, 0.0f});
    run(2);
    EXPECT_EQ(logText(), "");
}

/// Entities come and go, so that addresses in Lua are used again, and snapshots bring others back. Each
/// script must see its own property and its own transform.
TEST_F(ScriptSelf, isNeverThatOfAnotherEntity) {
    use({{"thing", R"(
        local Thing = script { number = 0, checks = 0, other = entity {} }
        function Thing:onTick()
            local keep = {}
            for i = 1, 5 do keep[i] = { self } end
            assert(self.transform.x == self.number)
            self.transform.x = self.number + 1
            assert(self.transform.x == self.number + 1)
            self.transform.x = self.number
            local other = self.other and self.other.thing
            if other then assert(other.transform.x == other.number and other.number ~= self.number) end
            self.checks = self.checks + 1
        end
        return Thing)"}});
    const TypeInfo& type = *types.find("Thing");
    const auto give = [&](EntityId entity, std::string_view field, auto value) {
        std::memcpy(type.find(field)->in(world.find(type, entity)), &value, sizeof value);
    };
    Random random = Random::seeded(3);
    std::vector<EntityId> all;
    float number = 0.0f;
    const auto spawn = [&] {
        const EntityId entity = add("Thing", {number, 0.0f});
        give(entity, "number", number++);
        if (!all.empty()) give(entity, "other", all[random.below(static_cast<std::uint32_t>(all.size()))]);
        all.push_back(entity);
    };
    Snapshot snapshot;
    std::vector<EntityId> then;
    for (int tick = 0; tick < 300; ++tick) {
        for (int i = 0; i < 3; ++i) spawn();
        while (all.size() > 12) {
            const std::uint32_t at = random.below(static_cast<std::uint32_t>(all.size()));
            if (random.below(2) == 0)
                world.destroy(all[at]);
            else
                world.remove(type, all[at]);
            all.erase(all.begin() + at);
        }
        if (tick % 40 == 20) snapshot = world.save(), then = all;
        if (tick % 40 == 35) world.restore(snapshot), all = then;
        run();
        ASSERT_EQ(logText(), "") << tick;
    }
    EXPECT_GT(property<float>(all.front(), "checks"), 0.0f);
}

TEST_F(ScriptSelf, belongsToItsEntityWhateverItsFieldSays) {
    const EntityId first = thing(R"(
        function Thing:onTick()
            for _, wrong in ipairs({ findEntity("Bob"), 5 }) do
                self.entity = wrong
                self.count = self.count + 1
                assert(self.transform.x == 3 and self:isAlive())
            end
        end
    )",
                                 "count = 0");
    world.get<Transform>(first).position.x = 3.0f;
    const EntityId bob = world.createEntity().id();
    world.add<Transform>(bob, Vec2{7.0f, 0.0f});
    world.add<Name>(bob, Name{world.texts().add("Bob")});
    run(2);
    EXPECT_EQ(logText(), "");
    EXPECT_EQ(property<float>(first, "count"), 4.0f);
}

TEST_F(ScriptSelf, hasPropertiesWithLongNames) {
    const std::string name(60, 'n');  // Lua keeps texts of more than 40 bytes not only once
    const EntityId entity = thing("function Thing:onTick() for i = 1, 3 do self[('n'):rep(60)] = self." +
                                      name + " + 1 self.b = self.b + 1 end end",
                                  name + " = 4, b = 0");
    run();
    EXPECT_EQ(logText(), "");
    EXPECT_EQ(property<float>(entity, name), 7.0f);
    EXPECT_EQ(property<float>(entity, "b"), 3.0f);
}

TEST_F(ScriptSelf, canAssignAPropertyThatAFunctionHides) {
    const EntityId entity = thing(
        "function Thing:speed() return 5 end function Thing:onTick() assert(self:speed() == 5) self.speed = "
        "8 "
        "assert(self:speed() == 5) end",
        "speed = 2");
    run();
    EXPECT_EQ(logText(), "");
    EXPECT_EQ(property<float>(entity, "speed"), 8.0f);
}

TEST_F(ScriptSelf, isAnArgumentOfFunctionsAlsoAfterItsScriptHasEnded) {
    use({{"thing", "local Thing = script { } return Thing"}, {"watcher", R"(
            local Watcher = script { target = entity {}, seen = 0 }
            function Watcher:onCreate()
                local thing = self.target.thing
                assert(thing.transform.x == 9 and thing:isAlive())
                self.target:remove("Thing")
                wait(0.1)
                assert(self.target.thing == nil and thing.transform.x == 9 and thing:isAlive())
                local ok, message = pcall(function() return thing.stopped end)
                assert(not ok and message:find("no longer has the component Thing"), message)
                self.target:destroy()
                wait(0.1)
                ok, message = pcall(function() return thing.stopped end)
                assert(not ok and message:find("the entity of this Thing was destroyed"), message)
                assert(not thing:isAlive() and thing.transform == nil)
                self.seen = 1
            end
            return Watcher)"}});
    const EntityId target = add("Thing", {9.0f, 0.0f});
    run();
    const EntityId watcher = add("Watcher");
    const TypeInfo& type = *types.find("Watcher");
    std::memcpy(type.find("target")->in(world.find(type, watcher)), &target, sizeof target);
    run(30);
    EXPECT_EQ(logText(), "");
    EXPECT_EQ(property<float>(watcher, "seen", "Watcher"), 1.0f);
}

}  // namespace
}  // namespace plumb
