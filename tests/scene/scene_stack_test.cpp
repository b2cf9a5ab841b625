#include "scene/scene_stack.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "assets/asset_store.hpp"
#include "core/file.hpp"
#include "ecs/paused.hpp"
#include "ecs/world.hpp"
#include "input/input.hpp"
#include "reflect/type_registry.hpp"
#include "render/recording_device.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/persistent.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/drawing/soft_drawing.hpp"
#include "scene/files/world_field_context.hpp"
#include "scene/loaded_scene.hpp"
#include "scene/physics/contact_events.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/register_components.hpp"
#include "scene/systems/camera_system.hpp"
#include "scene/systems/physics_system.hpp"
#include "scene/world_transform.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

constexpr const char* kLevel = "scenes/level.scene.json";
constexpr const char* kMenu = "scenes/menu.scene.json";
constexpr const char* kHud = "scenes/hud.scene.json";
constexpr std::uint64_t kCrate = 0x11, kFloor = 0x12, kKept = 0x13, kButton = 0x21, kLamp = 0x31;

/// A level in which a crate bounces on a floor, a menu overlay that pauses it, and an overlay that does not.
class SceneStackTest : public ::testing::Test {
protected:
    void SetUp() override {
        registerSceneComponents(types_);
        world_.addSystem<PhysicsSystem>();
        world_.addSystem<CameraSystem>();
        write(kLevel, {R"("id": "11", "components": {"Transform": {"position": [50, 10]},
                          "Sprite": {"width": 16, "height": 16, "layer": 900}, "RigidBody": {"bounciness": 0.7},
                          "BoxCollider": {"width": 16, "height": 16}})",
                       R"("id": "12", "components": {"Transform": {"position": [0, 170]},
                          "Sprite": {"width": 400, "height": 16}, "BoxCollider": {"width": 400, "height": 16}})",
                       R"("id": "13", "components": {"Persistent": {}, "Transform": {"position": [20, 20]},
                          "RigidBody": {}})",
                       R"("id": "14", "components": {"Transform": {"position": [160, 90]}, "Camera": {}})"});
        write(kMenu, {R"("id": "21", "components": {"Transform": {"position": [5, 5]},
                         "Sprite": {"width": 8, "height": 8, "layer": -900}, "RigidBody": {},
                         "BoxCollider": {"width": 8, "height": 8}})",
                      R"("id": "22", "components": {"Transform": {"position": [10, 10]}, "Camera": {}})"});
        write(kHud, {R"("id": "31", "components": {"Transform": {},
                        "Sprite": {"width": 4, "height": 4}, "Overlay": {"pauses": false, "takesInput": false}})"});
        ASSERT_TRUE(switchScene(world_, context_, kLevel).ok());
    }

    void write(const std::string& path, const std::vector<std::string>& entities) {
        std::string text = R"({"format": 1, "effects": {}, "layers": [], "entities": [)";
        for (const std::string& entity : entities) {
            text.append(text.back() == '[' ? "{" : ", {").append(entity).append("}");
        }
        ASSERT_TRUE(writeFile(folder_.path / path, text.append("]}")).ok());
    }
    void tick(int count = 1) {
        for (int i = 0; i < count; ++i) {
            world_.beginTick();
            storePreviousTransforms(world_);
            world_.update(1.0f / 60.0f);
        }
    }
    Entity entity(std::uint64_t id) { return world_.entity(WorldFieldContext{world_}.entity(id)); }
    Vec2 at(std::uint64_t id) { return entity(id).get<Transform>().position; }
    /// Returns a hash of the world that ignores its tick count.
    std::uint64_t state() {
        const std::uint64_t tick = std::exchange(world_.tick, 0);
        const std::uint64_t hash = world_.hash();
        world_.tick = tick;
        return hash;
    }

    test::TemporaryFolder folder_;
    TypeRegistry types_;
    World world_{types_};
    SceneContext context_{types_, nullptr, folder_.path};
};

TEST_F(SceneStackTest, anOverlayPausesTheScenesBelowAndRunsItself) {
    tick(20);
    const Vec2 crate = at(kCrate);
    ASSERT_GT(crate.y, 11.0f);
    ASSERT_TRUE(openOverlay(world_, context_, kMenu).ok());

    tick(30);

    EXPECT_EQ(at(kCrate), crate);
    EXPECT_GT(at(kButton).y, 20.0f) << "the overlay's own bodies fall";
    EXPECT_TRUE(closeOverlay(world_));
    EXPECT_FALSE(entity(kButton));
    tick(5);
    EXPECT_GT(at(kCrate).y, crate.y);
    EXPECT_FALSE(closeOverlay(world_)) << "the lowest scene is no overlay";
}

TEST_F(SceneStackTest, closingAnOverlayRestoresTheSceneBitForBit) {
    std::vector<std::uint64_t> undisturbed;
    Snapshot start = world_.save();
    for (int i = 0; i < 200; ++i) tick(), undisturbed.push_back(state());

    world_.restore(start);
    for (int i = 0; i < 200; ++i) {
        tick();
        ASSERT_EQ(state(), undisturbed[static_cast<std::size_t>(i)]) << "tick " << i;
        if (i % 7 != 0) continue;
        ASSERT_TRUE(openOverlay(world_, context_, kMenu).ok());
        EXPECT_NE(state(), undisturbed[static_cast<std::size_t>(i)]);
        tick(i % 5);
        world_.createEntity().addComponent<Transform>();  // an entity created by code while the menu is open
        if (i % 3 == 0) {
            ASSERT_TRUE(openOverlay(world_, context_, kHud).ok());
            tick(2);
            ASSERT_TRUE(closeOverlay(world_));
        }
        ASSERT_TRUE(closeOverlay(world_));
        ASSERT_EQ(state(), undisturbed[static_cast<std::size_t>(i)]) << "tick " << i;
    }
}

TEST_F(SceneStackTest, nestedOverlaysAreClosedOneByOne) {
    write("scenes/second.scene.json", {R"("id": "41", "components": {"Transform": {}, "RigidBody": {}})"});
    ASSERT_TRUE(openOverlay(world_, context_, kMenu).ok());
    tick(5);
    const Vec2 button = at(kButton);
    ASSERT_TRUE(openOverlay(world_, context_, "scenes/second.scene.json").ok());
    tick(5);
    EXPECT_EQ(at(kButton), button);
    EXPECT_GT(at(0x41).y, 0.0f);
    closeOverlay(world_);
    tick();
    EXPECT_GT(at(kButton).y, button.y);
    EXPECT_TRUE(entity(kCrate).hasComponent<Paused>());
    closeOverlay(world_);
    EXPECT_EQ(world_.count<Paused>(), 0u);
}

TEST_F(SceneStackTest, anOverlayMayLetTheScenesBelowRunWithInput) {
    ASSERT_TRUE(openOverlay(world_, context_, kHud).ok());
    const Vec2 crate = at(kCrate);
    tick(10);
    EXPECT_GT(at(kCrate).y, crate.y);
    InputFrame frame;
    frame.set(Key::Space, true);
    world_.resource<Input>().advance(frame);
    EXPECT_TRUE(inputFor(world_, entity(kCrate)).isPressed(Action::Jump));
    EXPECT_TRUE(inputFor(world_, entity(kLamp)).isPressed(Action::Jump));
}

TEST_F(SceneStackTest, theTopmostSceneGetsTheInput) {
    write(kHud, {R"("id": "31", "components": {"Transform": {}, "Overlay": {"pauses": false}})"});
    ASSERT_TRUE(openOverlay(world_, context_, kHud).ok());
    InputFrame frame;
    frame.set(Key::Space, true);
    world_.resource<Input>().advance(frame);
    EXPECT_FALSE(inputFor(world_, entity(kCrate)).isHeld(Action::Jump));
    EXPECT_TRUE(inputFor(world_, entity(kLamp)).isHeld(Action::Jump));
    closeOverlay(world_);
    EXPECT_TRUE(inputFor(world_, entity(kCrate)).isHeld(Action::Jump));
}

TEST_F(SceneStackTest, anOverlayThatCannotBeReadChangesNothing) {
    tick(10);
    const std::uint64_t before = state();
    ASSERT_TRUE(writeFile(folder_.path / "scenes/broken.scene.json", "{").ok());
    for (const char* path : {"scenes/broken.scene.json", "scenes/nowhere.scene.json", kLevel}) {
        const auto opened = openOverlay(world_, context_, path);
        ASSERT_FALSE(opened.ok()) << path;
        EXPECT_FALSE(opened.error().remedy.empty());
        EXPECT_EQ(state(), before) << path;
    }
}

TEST_F(SceneStackTest, changingTheSceneRemovesTheStackButKeepsPersistentEntities) {
    write("scenes/title.scene.json", {R"("id": "51", "components": {"Transform": {}})"});
    tick(10);
    ASSERT_TRUE(openOverlay(world_, context_, kMenu).ok());
    const Entity made = world_.createEntity();
    tick(3);
    const Vec2 kept = at(kKept);
    ASSERT_TRUE(switchScene(world_, context_, "scenes/title.scene.json").ok());

    EXPECT_FALSE(entity(kCrate) || entity(kButton) || made.alive());
    ASSERT_TRUE(entity(kKept));
    EXPECT_EQ(world_.count<Paused>(), 0u);
    EXPECT_EQ(world_.entityCount(), 2u);
    EXPECT_EQ(world_.resource<LoadedScenes>().scenes.size(), 1u);
    tick(3);
    EXPECT_GT(at(kKept).y, kept.y) << "the persistent entity keeps moving";
}

/// An event, and the key of its handler.
struct Scored {};

TEST_F(SceneStackTest, waitingEventsEndWithTheirSceneButNotWithOverlays) {
    write("scenes/title.scene.json", {R"("id": "51", "components": {"Transform": {}})"});
    world_.openInbox<Scored>(typeKey<Scored>());
    const auto received = [&] {
        int count = 0;
        world_.deliver<Scored>(typeKey<Scored>(), [&](const Scored&) { ++count; });
        return count;
    };
    for (const char* scene : {kLevel, "scenes/title.scene.json", "scenes/title.scene.json"}) {
        world_.emit(Scored{});
        ASSERT_TRUE(switchScene(world_, context_, scene).ok());
        EXPECT_EQ(received(), 0) << scene;
    }
    world_.emit(Scored{});
    ASSERT_TRUE(openOverlay(world_, context_, kMenu).ok());
    EXPECT_EQ(received(), 1);
    world_.emit(Scored{});
    ASSERT_TRUE(closeOverlay(world_));
    EXPECT_EQ(received(), 1);
    world_.emit(Scored{});
    EXPECT_FALSE(switchScene(world_, context_, "scenes/none.scene.json").ok());
    EXPECT_EQ(received(), 1) << "the scene continues";
}

TEST_F(SceneStackTest, errorsAreReportedAgainAfterASuccessfulChangeOfTheScene) {
    Reports& reports = world_.reports();
    EXPECT_TRUE(reports.isFirst("a", "b"));
    EXPECT_FALSE(switchScene(world_, context_, "scenes/none.scene.json").ok());
    EXPECT_FALSE(reports.isFirst("a", "b"));
    ASSERT_TRUE(openOverlay(world_, context_, kMenu).ok());
    EXPECT_FALSE(reports.isFirst("a", "b"));
    ASSERT_TRUE(switchScene(world_, context_, kLevel).ok());
    EXPECT_TRUE(reports.isFirst("a", "b"));
}

TEST_F(SceneStackTest, aPersistentEntityOfAnOverlayStaysWhenItCloses) {
    ASSERT_TRUE(openOverlay(world_, context_, kMenu).ok());
    entity(kButton).addComponent<Persistent>();
    closeOverlay(world_);
    ASSERT_TRUE(entity(kButton));
    const Vec2 button = at(kButton);
    tick(5);
    EXPECT_GT(at(kButton).y, button.y);
}

TEST_F(SceneStackTest, aSnapshotContainsTheStack) {
    tick(10);
    const std::uint64_t left = state();
    ASSERT_TRUE(openOverlay(world_, context_, kMenu).ok());
    tick(5);
    const Snapshot inMenu = world_.save();
    const std::uint64_t hash = world_.hash();
    closeOverlay(world_);
    tick(20);

    world_.restore(inMenu);

    EXPECT_EQ(world_.hash(), hash);
    ASSERT_TRUE(closeOverlay(world_));
    EXPECT_EQ(state(), left);
}

TEST_F(SceneStackTest, savingWhileAnOverlayIsOpenWritesAllOfTheSceneBelow) {
    const std::string before = sceneToJson(world_, context_, sceneId(kLevel));
    ASSERT_TRUE(openOverlay(world_, context_, kMenu).ok());
    EXPECT_EQ(sceneToJson(world_, context_, sceneId(kLevel)), before);
}

TEST_F(SceneStackTest, overlaysAreDrawnOnTopEachWithItsOwnCamera) {
    ASSERT_TRUE(openOverlay(world_, context_, kMenu).ok());
    EXPECT_EQ(cameraView(world_, {320, 180}, 1.0f, 0).center, (Vec2{160, 90}));
    EXPECT_EQ(cameraView(world_, {320, 180}, 1.0f, 1).center, (Vec2{10, 10}));

    RecordingDevice device;
    AssetStore assets;
    SceneRenderer renderer{device, assets};
    renderer.draw(world_, {320, 180}, 1.0f, {TargetHandle{}, 0, 0, 320, 180});

    // The crate has the highest layer and the button the lowest, but the button's scene is drawn on top.
    ASSERT_EQ(device.spriteDraws.size(), 2u);
    EXPECT_EQ(device.spriteDraws[0].instances.size(), 2u);
    EXPECT_EQ(device.spriteDraws[1].instances.size(), 1u);
}

TEST_F(SceneStackTest, pausedSoftBodiesAreStillDrawn) {
    write("scenes/soft.scene.json",
          {R"("id": "41", "components": {"Transform": {"position": [50, 10]}, "Jelly": {"radius": 20}})",
           R"("id": "42", "components": {"Transform": {"position": [160, 90]}, "Camera": {}})"});
    ASSERT_TRUE(switchScene(world_, context_, "scenes/soft.scene.json").ok());
    tick(30);
    const auto polygons = [this] {
        DrawList list;
        list.begin({{160, 90}, {320, 180}});
        drawSoftBodies(world_, {{{160, 90}, {320, 180}}}, list);
        return std::pair{list.items().size(), physics::bodyCount(lowestPhysics(world_)->world)};
    };
    const auto before = polygons();
    EXPECT_GT(before.first, 24u);
    ASSERT_TRUE(openOverlay(world_, context_, kMenu).ok());
    tick(10);
    EXPECT_EQ(polygons(), before);
    EXPECT_TRUE(closeOverlay(world_));
    EXPECT_EQ(polygons(), before);
}

}  // namespace
}  // namespace plumb
