#include <gtest/gtest.h>

#include "app/scene_game.hpp"
#include "core/file.hpp"
#include "gameplay/game_progress.hpp"
#include "render/recording_device.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/physics/physics_times.hpp"
#include "tests/app/projects/platformer.hpp"
#include "tests/support/allocations.hpp"

namespace plumb {
namespace {

/// The platformer, drawn with a device that stores only what a graphics card would store.
class PlayedGame {
public:
    explicit PlayedGame(const std::string& scene)
        : game_{platformer(), scene}, renderer_{device_, game_.assets} {
        device_.recordsDraws = false;
        game_.assets.logging = false;
        game_.onCreate();
    }

    /// Runs left and right, jumps, and draws one frame per tick.
    void play(int ticks, int from = 0) {
        for (int i = from; i < ticks; ++i) {
            InputFrame frame;
            frame.set(Key::Right, i / 60 % 2 == 0);
            frame.set(Key::Left, i / 60 % 2 == 1);
            frame.set(Key::Space, i % 40 < 15);
            tickGame(game_, frame);
            moved_ += movedEntities(game_.world);
            const Viewport viewport{{}, 0, 0, 320, 180};
            renderer_.draw(game_.world, {320.0f, 180.0f}, 0.5f, viewport, &fillPlaceholders);
            renderer_.drawPhysics(game_.world, shown, renderer_.sceneView(), viewport);
        }
    }
    void open(const std::string& scene) { ASSERT_TRUE(game_.openScene(scene).ok()); }

    /// Plays 600 ticks from a snapshot; returns their number of allocations. The first tick is not counted:
    /// after restoring a world, queries rebuild their lists and the physics creates a new broad phase.
    std::size_t allocationsOfPlayingOn(const Snapshot& from) {
        game_.world.restore(from);
        play(1);
        const std::size_t before = test::allocations().made;
        play(600, 1);
        return test::allocations().made - before;
    }

    /// Draws all layers of the physics view. Times are measured but not written, because the length of their
    /// text, and so the memory for it, depends on the clock.
    void showPhysics() {
        for (const PhysicsLayer& layer : physicsLayers()) {
            if (layer.bit != kPhysicsTimes) shown.layers |= layer.bit;
        }
        shown.times = &times_;
        times_.watch(game_.world, true);
    }

    PhysicsShown shown;

    [[nodiscard]] const World& world() const { return game_.world; }
    [[nodiscard]] std::size_t moved() const { return moved_; }
    [[nodiscard]] std::size_t drawCalls() { return renderer_.renderer().counts().drawCalls; }
    [[nodiscard]] std::size_t texturesCreated() const { return device_.texturesCreated; }

private:
    RecordingDevice device_;
    SceneGame game_;
    SceneRenderer renderer_;
    PhysicsTimes times_;
    std::size_t moved_ = 0;
};

TEST(SteadyLevels, aDrawnTickOfEveryLevelAllocatesNothing) {
    int levels = 0;
    for (const std::string& scene : platformerScenes()) {
        SCOPED_TRACE(scene);
        PlayedGame game{scene};
        game.play(600);
        // The first run may allocate for new glyphs, more sprites or collected coins. The second run is equal
        // bit for bit and finds all memory allocated.
        const Snapshot start = game.world().save();
        game.play(600);
        const std::uint64_t end = game.world().hash();
        const std::size_t moved = game.moved();
        EXPECT_EQ(game.allocationsOfPlayingOn(start), 0u);
        EXPECT_EQ(game.world().hash(), end);
        EXPECT_GT(game.drawCalls(), 0u);
        const bool isMenu =
            scene.find("pause") != std::string::npos || scene.find("leave") != std::string::npos;
        if (!isMenu) {  // in menus nothing moves by itself
            EXPECT_GT(game.moved(), moved) << "no entity of this scene moves";
        }
        ++levels;
    }
    EXPECT_GE(levels, 6);
}

TEST(SteadyLevels, thePhysicsViewAllocatesNothingAndChangesNothing) {
    PlayedGame watched{"level1"}, alone{"level1"};
    watched.showPhysics();
    watched.play(600);
    const Snapshot start = watched.world().save();
    watched.play(600);
    EXPECT_EQ(watched.allocationsOfPlayingOn(start), 0u);
    EXPECT_GT(watched.drawCalls(), 2u);
    alone.play(1200);
    EXPECT_EQ(watched.world().hash(), alone.world().hash());
}

TEST(SteadyLevels, aHundredSwitchesThroughAllScenesLeakNoMemory) {
    const std::vector<std::string> scenes = platformerScenes();
    PlayedGame game{"level1"};
    const auto round = [&] {
        for (const std::string& scene : scenes) {
            game.open(scene);
            game.play(10);
        }
    };
    for (int i = 0; i < 8; ++i) round();  // tile layers that are not drawn are kept for 300 frames
    const std::size_t alive = test::allocations().alive();
    const std::size_t textures = game.texturesCreated();
    const std::size_t entities = game.world().entityCount();
    for (std::size_t switches = 0; switches < 100; switches += scenes.size()) round();
    EXPECT_EQ(test::allocations().alive(), alive);
    EXPECT_EQ(game.texturesCreated(), textures);
    EXPECT_EQ(game.world().entityCount(), entities);
}

}  // namespace
}  // namespace plumb
