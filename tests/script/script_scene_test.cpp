#include "core/file.hpp"
#include "input/input.hpp"
#include "scene/components/persistent.hpp"
#include "scene/scene_stack.hpp"
#include "tests/script/script_world.hpp"
#include "tests/support/temporary_folder.hpp"

// Scripts in scenes that change, pause and end.

namespace plumb {
namespace {

constexpr const char* kLevel = "scenes/level.scene.json";
constexpr const char* kNext = "scenes/next.scene.json";
constexpr const char* kMenu = "scenes/menu.scene.json";

class ScriptScenes : public ScriptWorld {
protected:
    void SetUp() override {
        const std::string empty = R"({"format": 1, "effects": {}, "layers": [], "entities": []})";
        for (const char* path : {kLevel, kNext, kMenu})
            ASSERT_TRUE(writeFile(folder.path / path, empty).ok());
        change(kLevel);
    }
    void change(const char* scene) { ASSERT_TRUE(switchScene(world, context, scene).ok()); }
    /// Adds an entity whose script counts what it hears, and which survives all scenes.
    EntityId addListener() {
        const EntityId listener = add("Board");
        world.add<Persistent>(listener);
        return listener;
    }
    float heard(EntityId listener) const { return property<float>(listener, "heard", "Board"); }

    static constexpr const char* kBoard =
        "local Board = script { heard = 0 }"
        "function Board:onEvent_late() self.heard = self.heard + 1 end "
        "function Board:onEvent_gone(by) self.heard = self.heard + by end return Board";

    test::TemporaryFolder folder;
    SceneContext context{types, nullptr, folder.path};
};

TEST_F(ScriptScenes, endTheTimersOfTheirEntitiesUnlessThesePersist) {
    use({{"thing",
          "local Thing = script {} function Thing:onCreate() emitAfter(0.5, 'late') end return Thing"},
         {"board", kBoard}});
    const EntityId listener = addListener();
    add("Thing");
    run(10);
    change(kNext);
    run(60);
    EXPECT_EQ(heard(listener), 0.0f);
    world.add<Persistent>(add("Thing"));
    run(10);
    change(kLevel);
    run(60);
    EXPECT_EQ(heard(listener), 1.0f);
}

TEST_F(ScriptScenes, letTimersRestUnderAnOverlay) {
    use({{"thing",
          "local Thing = script {} function Thing:onCreate() emitAfter(0.5, 'late') end return Thing"},
         {"board", kBoard}});
    const EntityId listener = add("Board");
    add("Thing");
    run(11);
    ASSERT_TRUE(openOverlay(world, context, kMenu).ok());
    run(60);
    EXPECT_TRUE(closeOverlay(world));
    run(19);
    EXPECT_EQ(heard(listener), 0.0f) << "set in tick 1, due 30 ticks later, of which 10 were over";
    run(1);
    EXPECT_EQ(heard(listener), 1.0f);
}

TEST_F(ScriptScenes, callOnDestroyForWhatEndsWhileTheSceneGoesOn) {
    use({{"thing", R"(local Thing = script { points = 10 }
        function Thing:onCreate() self.value = self.points end
        function Thing:onTick() if self.value == 10 and world:tick() == 3 then self:destroy() end end
        function Thing:onDestroy()
            assert(self.value == 3000 or not self:isAlive() and self.transform == nil)
            emit("gone", self.value)
        end
        return Thing)"},
         {"board", kBoard}});
    const EntityId listener = addListener();
    const TypeInfo& type = *types.find("Thing");
    const auto addWorth = [&](float points) {
        const EntityId entity = add("Thing");
        std::memcpy(type.find("points")->in(world.find(type, entity)), &points, sizeof points);
        return entity;
    };
    addWorth(10.0f);
    const EntityId byCode = addWorth(200.0f);
    const EntityId loses = addWorth(3000.0f);
    addWorth(40000.0f);
    run(2);
    EXPECT_EQ(heard(listener), 0.0f);
    run(1);
    EXPECT_EQ(heard(listener), 10.0f) << "in the tick in which the script has destroyed it";
    world.destroy(byCode);
    run(1);
    EXPECT_EQ(heard(listener), 210.0f);
    world.remove(type, loses);
    run(1);
    EXPECT_EQ(heard(listener), 3210.0f);
    change(kNext);
    run(3);
    EXPECT_EQ(heard(listener), 3210.0f) << "the fourth one has ended with its scene";
    EXPECT_EQ(logText(), "");
}

TEST_F(ScriptScenes, stopWaitingForAnEventThatDoesNotCome) {
    const EntityId entity = thing(R"(
        function Thing:onCreate()
            self.first = waitFor("hit", 0.5) == nil and 1 or 2
            self.second = waitFor("hit", 0.5)
            self.third = waitFor("hit")
        end
    )",
                                  "first = 0, second = 0, third = 0");
    const auto hit = [&](int by) {
        world.beginTick();
        world.emit(scriptEvent(world, "hit", by));
        world.update(1.0f / 60.0f);
    };
    run(30);
    EXPECT_EQ(property<float>(entity, "first"), 0.0f);
    run(1);
    EXPECT_EQ(property<float>(entity, "first"), 1.0f) << "30 ticks after tick 1";
    run(10);
    hit(7);
    EXPECT_EQ(property<float>(entity, "second"), 7.0f);
    run(600);
    EXPECT_EQ(property<float>(entity, "third"), 0.0f) << "without a limit it goes on waiting";
    hit(9);
    EXPECT_EQ(property<float>(entity, "third"), 9.0f);
    EXPECT_EQ(logText(), "");
}

TEST_F(ScriptScenes, hearKeysAndTheMouseLikeActions) {
    const EntityId entity = thing(R"(
        function Thing:onTick()
            local function state(name)
                return (input:isPressed(name) and "P" or "") .. (input:isHeld(name) and "H" or "") ..
                    (input:isReleased(name) and "R" or "") .. "."
            end
            self.seen = self.seen .. state("Q") .. state("Mouse Right") .. " "
        end
    )",
                                  "seen = ''");
    for (const bool held : {false, true, true, false}) {
        InputFrame frame;
        frame.set(Key::Q, held);
        frame.mouseButtons = held ? 1u << static_cast<unsigned>(MouseButton::Right) : 0u;
        world.resource<Input>().advance(frame);
        run();
    }
    EXPECT_EQ(world.texts().find(property<TextId>(entity, "seen")), ".. PH.PH. H.H. R.R. ");
    EXPECT_EQ(logText(), "");
}

}  // namespace
}  // namespace plumb
