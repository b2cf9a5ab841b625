#include "scene/drawing/draw_scene.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "ecs/hierarchy.hpp"
#include "math/angle.hpp"
#include "reflect/type_registry.hpp"
#include "render/recording_device.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/drawing/label.hpp"
#include "scene/components/drawing/parallax_layer.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/transform.hpp"
#include "scene/register_components.hpp"
#include "scene/systems/camera_system.hpp"
#include "scene/world_transform.hpp"
#include "tests/support/places.hpp"

namespace plumb {
namespace {

constexpr Vec2 kPicture{320.0f, 180.0f};
constexpr float kDt = 1.0f / 60.0f;

/// A world and a device that records draw calls instead of rendering.
struct DrawScene : testing::Test {
    TypeRegistry types;
    World world{types};
    AssetStore assets{{}, test::sourceFolder() / "assets"};
    RecordingDevice device;
    SceneRenderer renderer{device, assets};

    DrawScene() {
        registerSceneComponents(types);
        world.resource<PictureSize>().size = kPicture;
    }

    Entity addSprite(Vec2 place, int layer = 0) {
        Entity entity = world.createEntity();
        entity.addComponent<Transform>(place);
        Sprite& sprite = entity.addComponent<Sprite>(TextureId{}, 16, 8);
        sprite.pivot = {0.5f, 0.5f};
        sprite.layer = layer;
        return entity;
    }
    Entity addBackdrop(Vec2 factor, int layer) {
        Entity entity = world.createEntity();
        entity.addComponent<Transform>();
        entity.addComponent<Sprite>(TextureId{}, 320, 180).layer = layer;
        entity.addComponent<ParallaxLayer>().factor = factor;
        return entity;
    }
    Entity addCamera(Vec2 place) {
        Entity camera = world.createEntity();
        camera.addComponent<Transform>(place);
        camera.addComponent<Camera>();
        return camera;
    }
    /// Runs one tick in which only `change` modifies the world.
    template <class Change>
    void tick(Change change) {
        storePreviousTransforms(world);
        change();
        CameraSystem{}.update(world, kDt);
    }
    void draw(float alpha, int factor = 4) {
        device.clearDraws();
        renderer.draw(world, kPicture, alpha, {.width = 320 * factor, .height = 180 * factor});
    }
    /// Draws and returns the last sprite; its position is in px from the upper left corner of the image.
    SpriteInstance drawn(float alpha) {
        draw(alpha);
        SpriteInstance sprite = device.spriteDraws.back().instances.back();
        const ViewTransform& view = device.spriteDraws.back().batch.transform;
        const Vec2 clip = Vec2{dot(view.x, sprite.center), dot(view.y, sprite.center)} + view.offset;
        sprite.center = {(clip.x + 1.0f) * 0.5f * kPicture.x, (1.0f - clip.y) * 0.5f * kPicture.y};
        return sprite;
    }
};

TEST_F(DrawScene, positionRotationAndScaleAreDrawnBetweenTheLastTwoTicks) {
    Entity entity = addSprite({100.0f, 50.0f});
    tick([&] {
        auto& transform = entity.get<Transform>();
        transform.position = {140.0f, 70.0f};
        transform.rotation = 1.0f;
        transform.scale = {2.0f, 3.0f};
    });
    for (const float alpha : {0.0f, 0.25f, 0.5f, 1.0f}) {
        SCOPED_TRACE(alpha);
        const SpriteInstance sprite = drawn(alpha);
        EXPECT_NEAR(sprite.center.x, 100.0f + 40.0f * alpha, 1e-3f);
        EXPECT_NEAR(sprite.center.y, 50.0f + 20.0f * alpha, 1e-3f);
        EXPECT_NEAR(sprite.rotation, alpha, 1e-5f);
        EXPECT_NEAR(sprite.half.x, 8.0f * (1.0f + alpha), 1e-4f);
        EXPECT_NEAR(sprite.half.y, 4.0f * (1.0f + 2.0f * alpha), 1e-4f);
    }
}

TEST_F(DrawScene, rotationIsInterpolatedTheShortWay) {
    Entity entity = addSprite({100.0f, 50.0f});
    entity.get<Transform>().rotation = 3.0f;
    tick([&] { entity.get<Transform>().rotation = -3.0f; });
    const float half = drawn(0.5f).rotation;
    EXPECT_NEAR(std::fabs(std::remainder(half - 3.1415927f, 6.2831853f)), 0.0f, 1e-4f);
}

TEST_F(DrawScene, aChildFollowsItsParentBetweenTicks) {
    Entity parent = world.createEntity();
    parent.addComponent<Transform>(100.0f, 50.0f);
    Entity child = addSprite({20.0f, 0.0f});
    setParent(world, child, parent);
    tick([&] { parent.get<Transform>().rotation = 1.5707963f; });
    const Vec2 center = drawn(0.5f).center;
    EXPECT_NEAR(center.x, 100.0f + 20.0f * std::sqrt(0.5f), 1e-2f);
    EXPECT_NEAR(center.y, 50.0f + 20.0f * std::sqrt(0.5f), 1e-2f);
}

TEST_F(DrawScene, everySpriteThatOverlapsTheViewIsDrawn) {
    Random random = Random::seeded(4);
    const auto around = [&](float far) { return Vec2{random.between(-far, far), random.between(-far, far)}; };
    Entity parent;
    for (int i = 0; i < 3000; ++i) {
        Entity entity = addSprite(around(i % 3 == 0 ? 900.0f : 500.0f));
        Sprite& sprite = entity.get<Sprite>();
        sprite.width = 1 + static_cast<int>(random.below(300));
        sprite.height = 1 + static_cast<int>(random.below(300));
        sprite.pivot = around(2.0f);
        Transform& place = entity.get<Transform>();
        place.scale = around(1.5f);
        place.rotation = i % 2 == 0 ? 0.0f : random.between(-3.0f, 3.0f);
        if (i % 3 == 0) parent = entity;
        if (i % 3 == 1) setParent(world, entity.id(), parent.id());
    }
    storePreviousTransforms(world);
    SceneView all;
    all.view = {.center = {}, .size = {20000.0f, 20000.0f}};
    SceneView part;
    part.view = {.center = {40.0f, -30.0f}, .size = kPicture};
    DrawList everything, seen, expected;
    everything.begin(all.view), seen.begin(part.view), expected.begin(part.view);
    renderer.collect(world, all, everything);
    renderer.collect(world, part, seen);
    ASSERT_EQ(everything.instances().size(), 3000u);
    for (const SpriteInstance& one : everything.instances()) expected.instance(one, {}, 0);
    ASSERT_EQ(seen.instances().size(), expected.instances().size());
    for (std::size_t i = 0; i < seen.instances().size(); ++i)
        EXPECT_EQ(seen.instances()[i].center, expected.instances()[i].center) << i;
    EXPECT_GT(seen.instances().size(), 100u);
    EXPECT_LT(seen.instances().size(), 2900u);
}

TEST_F(DrawScene, positionAndZoomOfTheCameraAreInterpolated) {
    addSprite({160.0f, 90.0f});
    Entity camera = addCamera({160.0f, 90.0f});
    tick([] {});
    tick([&] {
        camera.get<Transform>().position = {120.0f, 90.0f};
        camera.get<Camera>().zoom = 3.0f;
    });
    draw(0.5f);
    const ViewTransform& view = device.spriteDraws.back().batch.transform;
    EXPECT_NEAR(view.x.x, 2.0f * 2.0f / kPicture.x, 1e-5f) << "zoom 2 is half way from 1 to 3";
    EXPECT_NEAR(drawn(0.5f).center.x, 160.0f + 2.0f * 20.0f, 0.2f);
}

TEST_F(DrawScene, aSpriteOfConstantSpeedMovesEvenlyAt144FramesPerSecond) {
    Entity entity = addSprite({20.0f, 50.0f});
    const auto step = [&] { entity.get<Transform>().position.x += 2.0f; };
    double time = 0.0;
    float before = 0.0f;
    tick(step);
    for (int frame = 0; frame < 144; ++frame) {
        time += 60.0 / 144.0;
        while (time >= 1.0) {
            time -= 1.0;
            tick(step);
        }
        const float x = drawn(static_cast<float>(time)).center.x;
        if (frame > 0) {
            EXPECT_NEAR((x - before) / (2.0f * 60.0f / 144.0f), 1.0f, 0.01f) << frame;
        }
        before = x;
    }
}

TEST_F(DrawScene, theOutlineOfALabelIsOnePixelWide) {
    Entity entity = world.createEntity();
    entity.addComponent<Transform>(100.0f, 50.0f);
    Label& label = entity.addComponent<Label>();
    label.text = world.texts().add("i");
    label.color = {250, 240, 200, 255};
    draw(1.0f);
    ASSERT_EQ(device.spriteDraws.size(), 1u);
    const std::vector<SpriteInstance> plain = device.spriteDraws.front().instances;
    label.outline = {20, 15, 35, 255};
    draw(1.0f);
    const std::vector<SpriteInstance> outlined = device.spriteDraws.front().instances;
    ASSERT_EQ(plain.size(), 1u);
    ASSERT_EQ(outlined.size(), 9u);
    for (std::size_t i = 0; i < 8; ++i) {
        const Vec2 aside = outlined[i].center - plain[0].center;
        EXPECT_EQ(outlined[i].tint, label.outline);
        EXPECT_EQ(std::max(std::fabs(aside.x), std::fabs(aside.y)), 1.0f);
    }
    EXPECT_EQ(outlined.back().tint, label.color);
    EXPECT_EQ(outlined.back().center, plain[0].center);
}

TEST_F(DrawScene, aTeleportIsNotInterpolated) {
    Entity entity = addSprite({20.0f, 50.0f});
    tick([&] { teleport(entity.get<Transform>(), {300.0f, 150.0f}); });
    for (const float alpha : {0.0f, 0.3f, 0.9f, 1.0f}) EXPECT_EQ(drawn(alpha).center, (Vec2{300.0f, 150.0f}));
}

TEST_F(DrawScene, aCameraThatMovesFartherThanItsViewIsNotInterpolated) {
    Entity hero = addSprite({160.0f, 90.0f});
    Entity camera = addCamera({160.0f, 90.0f});
    camera.get<Camera>().follow = hero;
    tick([] {});
    tick([&] { hero.get<Transform>().position.x += 30.0f; });
    EXPECT_NEAR(cameraView(world, kPicture, 0.5f).center.x, 175.0f, 1e-3f) << "a normal step is interpolated";
    tick([&] { teleport(hero.get<Transform>(), {2000.0f, 90.0f}); });
    for (const float alpha : {0.0f, 0.4f, 1.0f}) {
        EXPECT_EQ(cameraView(world, kPicture, alpha).center, (Vec2{2000.0f, 90.0f}));
    }
}

TEST_F(DrawScene, theFirstFrameShowsTheTargetOfTheCamera) {
    Entity hero = addSprite({1000.0f, 400.0f});
    Entity camera = addCamera({});
    camera.get<Camera>().follow = hero;
    camera.get<Camera>().offset = {0.0f, -20.0f};
    camera.get<Camera>().limits = {0.0f, 0.0f, 1100.0f, 600.0f};
    const Vec2 early = cameraView(world, kPicture, 0.5f).center;
    EXPECT_EQ(early, (Vec2{1100.0f - 160.0f, 380.0f}));
    tick([] {});
    EXPECT_EQ(cameraView(world, kPicture, 0.5f).center, early);
}

TEST_F(DrawScene, softwareRenderingDrawsBackdropsSmallAndEnlargesThemOnce) {
    addBackdrop({0.0f, 0.0f}, -100);
    addBackdrop({0.3f, 0.0f}, -90);
    addSprite({100.0f, 50.0f}, 5);
    draw(1.0f);
    EXPECT_TRUE(device.showCalls.empty()) << "not used with a graphics card";

    device.software = true;
    draw(1.0f);
    ASSERT_EQ(device.showCalls.size(), 1u);
    EXPECT_EQ(device.textureSize(device.targetTexture(device.showCalls.front().source)),
              (PixelSize{320, 180}));
    EXPECT_EQ(device.showCalls.front().viewport.width, 1280);
    for (const auto& sprites : device.spriteDraws) {
        const bool backdrop = sprites.instances.front().half.x > 100.0f;
        EXPECT_EQ(sprites.viewport.width, backdrop ? 320 : 1280);
    }

    draw(1.0f, 1);
    EXPECT_TRUE(device.showCalls.empty()) << "nothing is enlarged at a window scale of 1";
    addBackdrop({0.5f, 0.5f}, -95).get<Transform>().rotation = 0.1f;
    draw(1.0f);
    ASSERT_EQ(device.showCalls.size(), 1u);
    EXPECT_EQ(device.spriteDraws.front().viewport.width, 320);
    EXPECT_EQ(device.spriteDraws.front().instances.size(), 1u)
        << "layers from the rotated backdrop upward are drawn at window resolution";
}

TEST_F(DrawScene, softwareRenderingUsesAtMostTripleResolution) {
    addBackdrop({0.0f, 0.0f}, -100);
    addSprite({100.0f, 50.0f}, 5);
    device.software = true;
    for (const auto& [factor, drawn] : {std::pair{6, 3}, {8, 4}, {9, 3}, {12, 3}}) {
        SCOPED_TRACE(factor);
        draw(1.0f, factor);
        ASSERT_EQ(device.showCalls.size(), 2u);
        EXPECT_EQ(device.showCalls.front().viewport.width, 320 * drawn);
        EXPECT_EQ(device.showCalls.back().viewport.width, 320 * factor);
        EXPECT_EQ(device.showCalls.back().source, device.showCalls.front().viewport.target);
        EXPECT_EQ(device.spriteDraws.back().viewport.width, 320 * drawn);
    }
    for (const int factor : {2, 3, 4, 5, 7}) {
        draw(1.0f, factor);
        EXPECT_EQ(device.showCalls.size(), 1u) << factor;
    }
}

TEST_F(DrawScene, backdropsAreAlignedToPixelsForAnyCamera) {
    addBackdrop({0.37f, 0.21f}, -90);
    Entity camera = addCamera({160.0f, 90.0f});
    for (const bool software : {false, true}) {
        device.software = software;
        const float grid = software ? 1.0f : 4.0f;
        for (int i = 0; i < 50; ++i) {
            SCOPED_TRACE(i);
            teleport(camera.get<Transform>(),
                     Vec2{160.0f, 90.0f} + Vec2{7.13f, 3.7f} * static_cast<float>(i));
            const SpriteInstance sprite = drawn(1.0f);
            const Vec2 corner = (sprite.center - sprite.half) * grid;
            EXPECT_NEAR(corner.x, std::round(corner.x), 2e-2f);
            EXPECT_NEAR(corner.y, std::round(corner.y), 2e-2f);
        }
    }
}

}  // namespace
}  // namespace plumb
