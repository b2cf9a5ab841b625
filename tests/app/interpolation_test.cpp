#include <gtest/gtest.h>

#include "app/scene_game.hpp"
#include "gameplay/components.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/transform.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/scene_requests.hpp"
#include "tests/support/places.hpp"

namespace plumb {
namespace {

constexpr Vec2 kPicture{320.0f, 180.0f};
constexpr float kFarthest = 24.0f;  ///< px per tick; no entity of the game moves faster

/// Maximum distance that an entity, except the camera, is drawn to move between the last two ticks, px.
float farthestStep(const World& world) {
    float farthest = 0.0f;
    for (auto [entity, transform] : world.query<const Transform>(without<Camera>)) {
        farthest = std::max(farthest, distance(transform.previousPosition, transform.position));
    }
    return farthest;
}

/// Displacement of the camera view in a tick, px. The camera may move fast after a respawn, but by less than
/// half of its view.
float cameraStep(World& world) {
    return distance(cameraView(world, kPicture, 0.0f).center, cameraView(world, kPicture, 1.0f).center);
}

TEST(Interpolation, nothingIsInterpolatedAcrossTeleportsAndSceneChanges) {
    Result<Project> project = loadProject(test::sourceFolder() / "projects/platformer");
    ASSERT_TRUE(project.ok());
    SceneGame game{*project, "level1"};
    game.assets.logging = false;
    game.onCreate();
    for (int tick = 0; tick < 900; ++tick) {
        SCOPED_TRACE(tick);
        InputFrame frame;
        frame.set(Key::Right, tick % 120 < 90);
        frame.set(Key::Space, tick % 45 < 12);
        if (tick == 250) {
            Entity player = game.world.first<PlayerController, Transform>();
            ASSERT_TRUE(player);
            // far below the level, so that the player dies and respawns
            teleport(player.get<Transform>(), {300.0f, 5000.0f});
        }
        if (tick == 600) {
            game.world.resource<SceneRequests>().next = game.world.texts().add("scenes/level3.scene.json");
        }
        tickGame(game, frame);
        ASSERT_LE(farthestStep(game.world), kFarthest);
        ASSERT_LE(cameraStep(game.world), kPicture.x * 0.5f);
    }
    EXPECT_GT(cameraView(game.world, kPicture, 1.0f).center.x, 0.0f);
}

}  // namespace
}  // namespace plumb
