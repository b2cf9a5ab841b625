#include "render/renderer.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "math/portable.hpp"
#include "render/recording_device.hpp"

namespace plumb {
namespace {

const View kView{.center = {160.0f, 90.0f}, .size = {320.0f, 180.0f}};
const Viewport kWindow{.width = 320, .height = 180};

Image whiteImage(int width, int height) {
    return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width * height * 4), 255)};
}

std::vector<TextureHandle> makeTextures(RenderDevice& device, int count) {
    std::vector<TextureHandle> textures;
    for (int i = 0; i < count; ++i)
        textures.push_back(device.createTexture(whiteImage(8, 8), TextureFilter::Nearest));
    return textures;
}

SpriteQuad quadAt(Vec2 center, TextureHandle texture = {}) {
    return {.center = center, .half = {4.0f, 4.0f}, .texture = texture, .source = {0.0f, 0.0f, 8.0f, 8.0f}};
}

class RendererTest : public testing::Test {
protected:
    void SetUp() override { list.begin(kView); }

    std::vector<SpriteInstance> drawn() {
        device.clearDraws();
        renderer.draw(list, kWindow);
        std::vector<SpriteInstance> all;
        for (const RecordingDevice::SpriteDraw& draw : device.spriteDraws) {
            all.insert(all.end(), draw.instances.begin(), draw.instances.end());
        }
        return all;
    }

    RecordingDevice device;
    Renderer renderer{device};
    DrawList list;
};

TEST_F(RendererTest, lowerLayersAreDrawnFirstAndEqualOnesInTheOrderOfInsertion) {
    for (const int layer : {5, -3, 5, 0, -3}) {
        SpriteQuad quad = quadAt({100.0f + static_cast<float>(list.spriteCount()), 50.0f});
        quad.layer = layer;
        list.sprite(quad);
    }
    const std::vector<SpriteInstance> order = drawn();
    ASSERT_EQ(order.size(), 5u);
    const std::array expected{101.0f, 104.0f, 103.0f, 100.0f, 102.0f};
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(order[i].center.x, expected[i]);
}

TEST_F(RendererTest, withinALayerLargerYIsDrawnOnTop) {
    for (const float y : {80.0f, 20.0f, 50.0f, -40.0f, 200.0f}) {
        SpriteQuad quad = quadAt({50.0f, 90.0f});
        quad.half = {200.0f, 200.0f};
        quad.rotation = y;
        quad.sortY = y;
        list.sprite(quad);
    }
    const std::vector<SpriteInstance> order = drawn();
    ASSERT_EQ(order.size(), 5u);
    for (std::size_t i = 1; i < order.size(); ++i) EXPECT_LT(order[i - 1].rotation, order[i].rotation);
}

TEST_F(RendererTest, aRunIsDrawnInItsLayerAndSharesTheBatchOfAdjacentSprites) {
    const std::vector<TextureHandle> textures = makeTextures(device, 2);
    const auto addRun = [&](int layer, float from, std::size_t count) {
        const std::span<SpriteInstance> room = list.beginRun(count + 5);
        for (std::size_t i = 0; i < count; ++i)
            room[i] = {.center = {from + static_cast<float>(i), 50.0f},
                       .half = {1.0f, 1.0f},
                       .slot = kSpriteAdditive};
        list.endRun(count, textures[1], layer);
    };
    SpriteQuad quad = quadAt({200.0f, 50.0f}, textures[0]);
    quad.layer = 1;
    list.sprite(quad);
    addRun(2, 100.0f, 3);
    addRun(0, 10.0f, 2);
    addRun(0, 10.0f, 0);
    EXPECT_EQ(list.spriteCount(), 6u);
    EXPECT_EQ(list.culledCount(), 15u) << "reserved quads that were not filled";

    const std::vector<SpriteInstance> order = drawn();
    ASSERT_EQ(order.size(), 6u);
    const std::array expected{10.0f, 11.0f, 200.0f, 100.0f, 101.0f, 102.0f};
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(order[i].center.x, expected[i]);
    ASSERT_EQ(device.drawCalls(), 1u);
    const SpriteBatch& batch = device.spriteDraws[0].batch;
    EXPECT_EQ(batch.textures[order[0].slot & 0xff].index, textures[1].index);
    EXPECT_EQ(batch.textures[order[2].slot & 0xff].index, textures[0].index);
    EXPECT_NE(order[0].slot & kSpriteAdditive, 0u);
    EXPECT_EQ(order[2].slot & kSpriteAdditive, 0u);
}

TEST_F(RendererTest, sixteenInterleavedTexturesAreOneDrawCall) {
    const std::vector<TextureHandle> textures = makeTextures(device, 16);
    for (int i = 0; i < 1000; ++i) {
        list.sprite(quadAt({static_cast<float>(i % 320), 90.0f}, textures[static_cast<std::size_t>(i) % 16]));
    }
    EXPECT_EQ(drawn().size(), 1000u);
    EXPECT_EQ(device.drawCalls(), 1u);
    EXPECT_EQ(device.spriteDraws.front().batch.textureCount, 16u);
}

TEST_F(RendererTest, aDeviceMayLimitTheTexturesPerBatch) {
    const std::vector<TextureHandle> textures = makeTextures(device, 16);
    device.maxTextures = 4;
    for (int i = 0; i < 16; ++i) list.sprite(quadAt({100.0f, 90.0f}, textures[static_cast<std::size_t>(i)]));
    EXPECT_EQ(drawn().size(), 16u);
    EXPECT_EQ(device.drawCalls(), 4u);
}

TEST_F(RendererTest, groupingKeepsTenThousandSpritesOfAHundredTexturesInEightCalls) {
    const std::vector<TextureHandle> textures = makeTextures(device, 100);
    list.begin(kView, TextureGrouping::Group);
    Random random{4};
    for (int i = 0; i < 10000; ++i) list.sprite(quadAt({160.0f, 90.0f}, textures[random.below(100)]));
    EXPECT_EQ(drawn().size(), 10000u);
    EXPECT_LE(device.drawCalls(), 8u);
}

TEST_F(RendererTest, everyInstanceKeepsTheTextureItWasAddedWith) {
    const std::vector<TextureHandle> textures = makeTextures(device, 40);
    Random random{9};
    for (int i = 0; i < 500; ++i) {
        SpriteQuad quad = quadAt({static_cast<float>(i % 300) + 4.0f, 90.0f}, textures[random.below(40)]);
        quad.rotation = static_cast<float>(quad.texture.index);
        quad.layer = static_cast<int>(random.below(3));
        list.sprite(quad);
    }
    EXPECT_EQ(drawn().size(), 500u);
    for (const RecordingDevice::SpriteDraw& draw : device.spriteDraws) {
        for (const SpriteInstance& instance : draw.instances) {
            EXPECT_EQ(static_cast<float>(draw.batch.textures[instance.slot & 0xffu].index),
                      instance.rotation);
        }
    }
}

TEST_F(RendererTest, objectsOutsideTheViewAreCulled) {
    list.sprite(quadAt({-5.0f, 90.0f}));
    list.sprite(quadAt({-3.0f, 90.0f}));
    list.sprite(quadAt({160.0f, 185.0f}));
    list.sprite(quadAt({1.0e9f, 0.0f}));
    list.sprite(quadAt({std::numeric_limits<float>::quiet_NaN(), 0.0f}));
    EXPECT_EQ(list.spriteCount(), 1u);
    EXPECT_EQ(list.culledCount(), 4u);
}

TEST_F(RendererTest, objectsThatReachIntoTheViewAreNeverCulled) {
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        Random random{seed};
        const View view{.center = {random.between(-50.0f, 50.0f), random.between(-50.0f, 50.0f)},
                        .size = {320.0f, 180.0f},
                        .zoom = random.between(0.3f, 4.0f),
                        .rotation = random.between(-4.0f, 4.0f)};
        list.begin(view);
        // A sprite with one corner exactly at a position on the screen.
        const Vec2 seen = toWorld(view, {random.between(1.0f, 319.0f), random.between(1.0f, 179.0f)});
        SpriteQuad quad = quadAt({});
        quad.half = {random.between(1.0f, 60.0f), random.between(1.0f, 60.0f)};
        quad.rotation = random.between(-4.0f, 4.0f);
        const SinCos rotation = sinCos(quad.rotation);
        quad.center = seen - Vec2{rotation.cos * quad.half.x - rotation.sin * quad.half.y,
                                  rotation.sin * quad.half.x + rotation.cos * quad.half.y} *
                                 0.99f;
        list.sprite(quad);
        EXPECT_EQ(list.spriteCount(), 1u) << seed;
    }
}

TEST_F(RendererTest, aFlipSwapsTwoEdgesOfTheSource) {
    SpriteQuad quad = quadAt({50.0f, 50.0f});
    quad.source = {3.0f, 5.0f, 8.0f, 16.0f};
    quad.flipX = true;
    list.sprite(quad);
    quad.flipX = false;
    quad.flipY = true;
    list.sprite(quad);
    const std::vector<SpriteInstance> order = drawn();
    EXPECT_EQ(order[0].uv, (std::array<std::uint16_t, 4>{44, 20, 12, 84}));
    EXPECT_EQ(order[1].uv, (std::array<std::uint16_t, 4>{12, 84, 44, 20}));
}

TEST_F(RendererTest, retainedSpritesAndShapesAreDrawnInTheirLayer) {
    const std::array<SpriteInstance, 2> tiles{};
    RetainedSprites chunk;
    chunk.buffer = device.createInstances(tiles);
    chunk.count = tiles.size();
    chunk.bounds = {{0.0f, 0.0f}, {64.0f, 64.0f}};
    chunk.layer = 1;
    SpriteQuad behind = quadAt({50.0f, 50.0f});
    SpriteQuad before = behind;
    before.layer = 2;
    list.filledCircle({80.0f, 80.0f}, 10.0f, {}, 3);
    list.sprite(before);
    list.retained(chunk);
    list.sprite(behind);
    renderer.draw(list, kWindow);
    ASSERT_EQ(device.spriteDraws.size(), 3u);
    EXPECT_EQ(device.spriteDraws[0].batch.buffer.index, 0u);
    EXPECT_EQ(device.spriteDraws[1].batch.buffer, chunk.buffer);
    EXPECT_EQ(device.spriteDraws[2].batch.buffer.index, 0u);
    ASSERT_EQ(device.geometryDraws.size(), 1u);
    EXPECT_EQ(device.geometryDraws[0].afterSprites, 3u);

    chunk.offset = {-64.0f, 0.0f};
    list.begin(kView);
    list.retained(chunk);
    EXPECT_EQ(list.culledCount(), 1u);
}

TEST_F(RendererTest, outlinesShareTheDrawCallOfSpritesAndFilledShapesShareAnother) {
    list.sprite(quadAt({50.0f, 50.0f}));
    list.line({0.0f, 0.0f}, {100.0f, 100.0f}, {});
    list.rect({{10.0f, 10.0f}, {50.0f, 40.0f}}, {});
    list.circle({80.0f, 80.0f}, 20.0f, {});
    list.arrow({10.0f, 10.0f}, {100.0f, 20.0f}, {});
    for (int i = 0; i < 10; ++i) list.filledCircle({80.0f, 80.0f}, 10.0f, {});
    EXPECT_FALSE(drawn().empty());
    EXPECT_EQ(device.spriteDraws.size(), 1u);
    EXPECT_EQ(device.geometryDraws.size(), 1u);
}

TEST_F(RendererTest, distantLayersAreDrawnToASmallTargetAndEnlargedBehindTheOthers) {
    for (const int layer : {7, -80, 0, -100, -80}) {
        SpriteQuad quad = quadAt({100.0f + static_cast<float>(list.spriteCount()), 50.0f});
        quad.layer = layer;
        list.sprite(quad);
    }
    const Viewport small{device.createTarget(320, 180), 0, 0, 320, 180};
    const Viewport window{.width = 1280, .height = 720};
    renderer.draw(list, window, {small, 0});

    ASSERT_EQ(device.spriteDraws.size(), 2u);
    EXPECT_EQ(device.spriteDraws[0].viewport, small);
    EXPECT_EQ(device.spriteDraws[1].viewport, window);
    ASSERT_EQ(device.spriteDraws[0].instances.size(), 3u);
    ASSERT_EQ(device.spriteDraws[1].instances.size(), 2u);
    const std::array expected{103.0f, 101.0f, 104.0f, 102.0f, 100.0f};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(device.spriteDraws[i / 3].instances[i % 3].center.x, expected[i]);
    }
    ASSERT_EQ(device.showCalls.size(), 1u);
    EXPECT_EQ(device.showCalls.front().source, small.target);
    EXPECT_EQ(device.showCalls.front().viewport, window);
    EXPECT_EQ(device.showCalls.front().afterSprites, 1u);
    EXPECT_EQ(renderer.counts().drawCalls, 3u);

    device.clearDraws();
    renderer.draw(list, window, {small, -200});
    EXPECT_TRUE(device.showCalls.empty()) << "no layer is below -200";
    EXPECT_EQ(device.spriteDraws.size(), 1u);
}

TEST_F(RendererTest, anEmptyListDrawsNothing) {
    EXPECT_TRUE(drawn().empty());
    EXPECT_EQ(device.drawCalls(), 0u);
}

}  // namespace
}  // namespace plumb
