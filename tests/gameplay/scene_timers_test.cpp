#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "gameplay/delayed_events.hpp"
#include "gameplay/game_functions.hpp"
#include "gameplay/systems/timer_system.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/persistent.hpp"
#include "scene/components/transform.hpp"
#include "scene/register_components.hpp"
#include "scene/scene_requests.hpp"
#include "scene/scene_stack.hpp"
#include "tests/support/temporary_folder.hpp"

// A timer belongs to the scene that asked for it: it rests and ends with it.

namespace plumb {
namespace {

constexpr const char* kLevel = "scenes/level.scene.json";
constexpr const char* kNext = "scenes/next.scene.json";
constexpr const char* kMenu = "scenes/menu.scene.json";
constexpr const char* kHud = "scenes/hud.scene.json";

struct Ring {
    int number = 0;
};
using Heard = std::vector<std::pair<std::uint64_t, int>>;

struct Listener {
    Heard* heard = nullptr;

    void update(World& world, float) const {
        for (const Ring& ring : world.events<Ring>()) heard->emplace_back(world.tick, ring.number);
    }
};

class SceneTimers : public ::testing::Test {
protected:
    void SetUp() override {
        registerSceneComponents(types);
        world.addSystem<TimerSystem>();
        world.addSystem<Listener>().heard = &heard;
        for (const char* path : {kLevel, kNext, kMenu}) write(path, "{}");
        write(kHud, R"({"Overlay": {"pauses": false, "takesInput": false}})");
        ASSERT_TRUE(switchScene(world, context, kLevel).ok());
    }
    void write(const char* path, const std::string& components) {
        const std::string text = R"({"format": 1, "effects": {}, "layers": [], "entities": [{"id": "1)" +
                                 std::to_string(++ids) + R"(", "components": )" + components + "}]}";
        ASSERT_TRUE(writeFile(folder.path / path, text).ok());
    }
    void open(const char* overlay) { ASSERT_TRUE(openOverlay(world, context, overlay).ok()); }
    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) {
            world.beginTick();
            world.update(1.0f / 60.0f);
        }
    }

    test::TemporaryFolder folder;
    TypeRegistry types;
    World world{types};
    SceneContext context{types, nullptr, folder.path};
    Heard heard;
    int ids = 0;
};

TEST_F(SceneTimers, restWhileAnOverlayPausesTheirScene) {
    emitAfter(world, 0.5f, Ring{1});
    run(10);
    open(kMenu);
    emitAfter(world, 0.1f, Ring{2});
    run(100);
    EXPECT_EQ(heard, (Heard{{16, 2}})) << "of the overlay, which runs";
    EXPECT_TRUE(closeOverlay(world));
    run(100);
    EXPECT_EQ(heard, (Heard{{16, 2}, {130, 1}})) << "30 ticks, and 100 in which it rested";
}

TEST_F(SceneTimers, goOnUnderAnOverlayThatDoesNotPause) {
    emitAfter(world, 0.5f, Ring{1});
    run(10);
    open(kHud);
    run(40);
    EXPECT_EQ(heard, (Heard{{30, 1}}));
}

TEST_F(SceneTimers, endWithTheirScene) {
    emitAfter(world, 0.5f, Ring{1});
    run(10);
    ASSERT_TRUE(switchScene(world, context, kNext).ok());
    emitAfter(world, 0.5f, Ring{2});
    run(20);
    ASSERT_TRUE(switchScene(world, context, kNext).ok()) << "the same scene, loaded again";
    open(kMenu);
    emitAfter(world, 0.5f, Ring{3});
    run(10);
    EXPECT_TRUE(closeOverlay(world));
    run(100);
    EXPECT_EQ(heard, Heard{});
    EXPECT_TRUE(world.resource<DelayedEvents>().entries.empty());
}

TEST_F(SceneTimers, thatAnOverlaySetsAfterItHasClosedItselfBelongToTheSceneBelow) {
    open(kMenu);
    run(5);
    emitAfter(world, 0.0f, Ring{1});
    hideOverlay(world);
    emitAfter(world, 0.0f, Ring{2});
    world.resource<SceneRequests>() = {};
    EXPECT_TRUE(closeOverlay(world));
    run(5);
    EXPECT_EQ(heard, (Heard{{6, 2}}));
}

TEST_F(SceneTimers, ofPersistentEntitiesSurviveTheScene) {
    const Entity kept = world.createEntity(), other = world.createEntity();
    kept.addComponent<Persistent>();
    emitAfter(world, kept.id(), 0.5f, Ring{1});
    emitAfter(world, other.id(), 0.5f, Ring{2});
    run(10);
    ASSERT_TRUE(switchScene(world, context, kNext).ok());
    run(5);
    open(kMenu);
    run(50);
    EXPECT_EQ(heard, Heard{}) << "the entity is paused like others";
    EXPECT_TRUE(closeOverlay(world));
    run(50);
    EXPECT_EQ(heard, (Heard{{80, 1}}));
}

TEST_F(SceneTimers, keepTheOrderInWhichTheyWereSet) {
    emitAfter(world, 0.5f, Ring{1});
    emitAfter(world, 0.4f, Ring{2});
    run(10);
    open(kMenu);
    run(6);
    emitAfter(world, 20.0f / 60.0f, Ring{3});
    run(10);
    EXPECT_TRUE(closeOverlay(world));
    run(30);
    EXPECT_EQ(heard, (Heard{{40, 2}, {46, 1}})) << "due 24 and 30, and 16 ticks of rest";
    heard.clear();
    emitAfter(world, 40.0f / 60.0f, Ring{4});
    run(10);
    open(kMenu);
    run(10);
    EXPECT_TRUE(closeOverlay(world));
    emitAfter(world, 30.0f / 60.0f, Ring{5});
    run(40);
    EXPECT_EQ(heard, (Heard{{106, 4}, {106, 5}})) << "due in the same tick";
}

TEST_F(SceneTimers, areRewoundWithTheScenes) {
    emitAfter(world, 0.5f, Ring{1});
    run(10);
    open(kMenu);
    run(7);
    const Snapshot paused = world.save();
    EXPECT_TRUE(closeOverlay(world));
    run(60);
    const Heard first = heard;
    EXPECT_EQ(first, (Heard{{37, 1}}));
    const std::uint64_t hash = world.hash();
    heard.clear();
    world.restore(paused);
    EXPECT_TRUE(closeOverlay(world));
    run(60);
    EXPECT_EQ(heard, first);
    EXPECT_EQ(world.hash(), hash);
}

}  // namespace
}  // namespace plumb
