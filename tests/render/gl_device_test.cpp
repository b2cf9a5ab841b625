#include "render/gl/gl_device.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "platform/window.hpp"
#include "render/renderer.hpp"

namespace plumb {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 48;

/// A device in a hidden window, created once, because that takes longer than all tests together.
class GlDeviceTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        Result<std::unique_ptr<Window>> opened =
            Window::open({.title = "test", .width = kWidth, .height = kHeight, .hidden = true});
        ASSERT_TRUE(opened) << opened.error().text();
        window = std::move(*opened);
        Result<std::unique_ptr<GlDevice>> made = GlDevice::create();
        ASSERT_TRUE(made) << made.error().text();
        device = std::move(*made);
        device->setWindowSize(window->drawableSize());
    }
    static void TearDownTestSuite() {
        device.reset();
        window.reset();
    }

    Image picture(TargetHandle target = {}) {
        Renderer renderer{*device};
        const Viewport viewport{.target = target, .width = kWidth, .height = kHeight};
        device->setViewport(viewport);
        device->clear({10, 20, 30, 255});
        renderer.draw(list, viewport);
        return device->readPixels(target);
    }

    static Color at(const Image& image, int x, int y) {
        const std::size_t i = static_cast<std::size_t>(y * image.width + x) * 4;
        return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2], image.rgba[i + 3]};
    }
    static void expectNear(Color seen, Color expected) {
        EXPECT_NEAR(seen.r, expected.r, 2);
        EXPECT_NEAR(seen.g, expected.g, 2);
        EXPECT_NEAR(seen.b, expected.b, 2);
    }

    /// Returns an image of 4x2 texels of different colors: r depends on the column, g on the row.
    static Image chart() {
        Image image{4, 2, {}};
        for (int y = 0; y < 2; ++y) {
            for (int x = 0; x < 4; ++x) {
                const auto red = static_cast<std::uint8_t>(x * 60);
                const auto green = static_cast<std::uint8_t>(y * 200);
                image.rgba.insert(image.rgba.end(), {red, green, 255, 255});
            }
        }
        return image;
    }
    static Color chartColor(int x, int y) {
        return {static_cast<std::uint8_t>(x * 60), static_cast<std::uint8_t>(y * 200), 255, 255};
    }

    static inline std::unique_ptr<Window> window;
    static inline std::unique_ptr<GlDevice> device;
    DrawList list;
    const View view{.center = {kWidth * 0.5f, kHeight * 0.5f}, .size = {kWidth, kHeight}};
};

TEST_F(GlDeviceTest, clearsToTheGivenColor) {
    list.begin(view);
    const Image image = picture();
    ASSERT_EQ(image.width, kWidth);
    ASSERT_EQ(image.height, kHeight);
    expectNear(at(image, 0, 0), {10, 20, 30, 255});
}

TEST_F(GlDeviceTest, drawsEveryTexelAtItsPositionInWindowsAndTargets) {
    const TextureHandle texture = device->createTexture(chart(), TextureFilter::Nearest);
    list.begin(view);
    list.sprite({.center = {18.0f, 14.0f},
                 .half = {8.0f, 4.0f},
                 .texture = texture,
                 .source = {0.0f, 0.0f, 4.0f, 2.0f}});
    const TargetHandle target = device->createTarget(kWidth, kHeight);
    for (const TargetHandle into : {TargetHandle{}, target}) {
        const Image image = picture(into);
        for (int y = 0; y < 8; ++y) {
            for (int x = 0; x < 16; ++x) {
                SCOPED_TRACE(testing::Message() << x << "," << y);
                expectNear(at(image, 10 + x, 10 + y), chartColor(x / 4, y / 4));
            }
        }
        expectNear(at(image, 9, 12), {10, 20, 30, 255});
        expectNear(at(image, 26, 12), {10, 20, 30, 255});
        expectNear(at(image, 12, 9), {10, 20, 30, 255});
        expectNear(at(image, 12, 18), {10, 20, 30, 255});
    }
    device->destroyTarget(target);
    device->destroyTexture(texture);
}

TEST_F(GlDeviceTest, flipsMirrorTheSourceAndDiagonalFlipsTransposeIt) {
    const TextureHandle texture = device->createTexture(chart(), TextureFilter::Nearest);
    SpriteQuad quad{
        .center = {8.0f, 4.0f}, .half = {8.0f, 4.0f}, .texture = texture, .source = {0.0f, 0.0f, 4.0f, 2.0f}};
    quad.flipX = true;
    list.begin(view);
    list.sprite(quad);
    expectNear(at(picture(), 1, 1), chartColor(3, 0));
    quad.flipY = true;
    list.begin(view);
    list.sprite(quad);
    expectNear(at(picture(), 1, 1), chartColor(3, 1));

    const std::array<SpriteInstance, 1> tile{SpriteInstance{
        .center = {4.0f, 8.0f}, .half = {4.0f, 8.0f}, .uv = {0, 0, 16, 8}, .slot = kSpriteDiagonal}};
    RetainedSprites retained{.buffer = device->createInstances(tile), .count = 1, .textures = {texture}};
    retained.bounds = {{0.0f, 0.0f}, {8.0f, 16.0f}};
    list.begin(view);
    list.retained(retained);
    const Image image = picture();
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 2; ++x) expectNear(at(image, x * 4 + 2, y * 4 + 2), chartColor(y, x));
    }
    device->destroyInstances(retained.buffer);
    device->destroyTexture(texture);
}

TEST_F(GlDeviceTest, adjacentTexelsNeverBleedAtAnyZoomOrRotation) {
    // One green 4x4 cell in a red sheet.
    Image sheet{16, 16, {}};
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            const bool cell = x >= 4 && x < 8 && y >= 8 && y < 12;
            const std::array<std::uint8_t, 4> color = cell ? std::array<std::uint8_t, 4>{0, 255, 0, 255}
                                                           : std::array<std::uint8_t, 4>{255, 0, 0, 255};
            sheet.rgba.insert(sheet.rgba.end(), color.begin(), color.end());
        }
    }
    for (const TextureFilter filter : {TextureFilter::Nearest, TextureFilter::Linear}) {
        const TextureHandle texture = device->createTexture(sheet, filter);
        for (int i = 0; i < 24; ++i) {
            View turned = view;
            turned.zoom = 0.35f + static_cast<float>(i) * 0.37f;
            turned.rotation = static_cast<float>(i) * 0.3f;
            list.begin(turned);
            list.sprite({.center = {31.3f, 23.7f},
                         .half = {5.0f, 5.0f},
                         .texture = texture,
                         .source = {4.0f, 8.0f, 4.0f, 4.0f}});
            const Image image = picture();
            for (std::size_t p = 0; p < image.rgba.size(); p += 4) ASSERT_LE(image.rgba[p], 12) << i;
        }
        device->destroyTexture(texture);
    }
}

TEST_F(GlDeviceTest, everyTextureSlotShowsItsOwnTexture) {
    std::vector<TextureHandle> textures;
    list.begin(view);
    for (int i = 0; i < 40; ++i) {
        const auto shade = static_cast<std::uint8_t>(i * 6);
        textures.push_back(device->createTexture({1, 1, {shade, shade, shade, 255}}, TextureFilter::Nearest));
        const Vec2 center{static_cast<float>(i % 8) * 8.0f + 4.0f, static_cast<float>(i / 8) * 8.0f + 4.0f};
        list.sprite({.center = center,
                     .half = {4.0f, 4.0f},
                     .texture = textures.back(),
                     .source = {0.0f, 0.0f, 1.0f, 1.0f}});
    }
    const Image image = picture();
    for (int i = 0; i < 40; ++i) {
        const auto shade = static_cast<std::uint8_t>(i * 6);
        expectNear(at(image, i % 8 * 8 + 4, i / 8 * 8 + 4), {shade, shade, shade, 255});
    }
    for (const TextureHandle texture : textures) device->destroyTexture(texture);
}

TEST_F(GlDeviceTest, opacityTintAndAdditiveBlendingAreCorrect) {
    list.begin(view);
    list.filledRect({{0.0f, 0.0f}, {16.0f, 16.0f}}, {200, 100, 0, 128});
    SpriteQuad light{.center = {40.0f, 8.0f},
                     .half = {8.0f, 8.0f},
                     .source = {0.0f, 0.0f, 1.0f, 1.0f},
                     .tint = {100, 100, 100, 255}};
    light.additive = true;
    list.sprite(light);
    list.filledCircle({24.0f, 36.0f}, 8.0f, {0, 0, 255, 255});
    const Image image = picture();
    expectNear(at(image, 8, 8), {105, 60, 15, 255});
    expectNear(at(image, 40, 8), {110, 120, 130, 255});
    expectNear(at(image, 24, 36), {0, 0, 255, 255});
    expectNear(at(image, 33, 36), {10, 20, 30, 255});
}

TEST_F(GlDeviceTest, aTranslucentAreaHasAUniformColorAtAnySize) {
    constexpr int kWide = 320;
    const TargetHandle target = device->createTarget(kWide, kWide);
    const Viewport viewport{.target = target, .width = kWide, .height = kWide};
    const Vec2 size{static_cast<float>(kWide), static_cast<float>(kWide)};
    list.begin({size * 0.5f, size});
    list.filledPolygon(std::array{Vec2{0.0f, 0.0f}, Vec2{size.x, 0.0f}, size, Vec2{0.0f, size.y}},
                       {96, 196, 118, 26});
    Renderer renderer{*device};
    device->setViewport(viewport);
    device->clear({52, 58, 92, 255});
    renderer.draw(list, viewport);
    const Image image = device->readPixels(target);
    for (int y = 2; y < kWide; y += 7) {
        for (int x = 2; x < kWide; x += 7) expectNear(at(image, x, y), {56, 72, 95, 255});
    }
    device->destroyTarget(target);
}

TEST_F(GlDeviceTest, aTargetIsShownEnlargedInWindowsAndTargetsWithoutBlending) {
    const TextureHandle texture = device->createTexture(chart(), TextureFilter::Nearest);
    const TargetHandle small = device->createTarget(8, 6);
    list.begin({.center = {4.0f, 3.0f}, .size = {8.0f, 6.0f}});
    list.sprite({.center = {3.0f, 2.0f},
                 .half = {2.0f, 1.0f},
                 .texture = texture,
                 .source = {0.0f, 0.0f, 4.0f, 2.0f}});
    Renderer renderer{*device};
    const Viewport inside{.target = small, .width = 8, .height = 6};
    device->setViewport(inside);
    device->clear({10, 20, 30, 0});
    renderer.draw(list, inside);

    const TargetHandle target = device->createTarget(kWidth, kHeight);
    for (const TargetHandle into : {TargetHandle{}, target}) {
        const Viewport whole{.target = into, .width = kWidth, .height = kHeight};
        device->setViewport(whole);
        device->clear({200, 0, 0, 255});
        device->show(small, {into, 16, 8, 24, 18});
        const Image image = device->readPixels(into);
        for (int y = 0; y < 18; ++y) {
            for (int x = 0; x < 24; ++x) {
                SCOPED_TRACE(testing::Message() << x << "," << y);
                const int column = x / 3 - 1;
                const int row = y / 3 - 1;
                const bool sprite = column >= 0 && column < 4 && row >= 0 && row < 2;
                expectNear(at(image, 16 + x, 8 + y), sprite ? chartColor(column, row) : Color{10, 20, 30, 0});
            }
        }
        for (const auto& [x, y] : {std::pair{15, 12}, std::pair{40, 12}, std::pair{20, 7}, std::pair{20, 26}})
            expectNear(at(image, x, y), {200, 0, 0, 255});
    }
    device->destroyTarget(target);
    device->destroyTarget(small);
    device->destroyTexture(texture);
}

TEST_F(GlDeviceTest, anUpdatedTextureShowsTheNewRegion) {
    const TextureHandle texture = device->createTexture(chart(), TextureFilter::Nearest);
    device->updateTexture(texture, 2, 1, {1, 1, {255, 255, 0, 255}});
    list.begin(view);
    list.sprite({.center = {2.0f, 1.0f},
                 .half = {2.0f, 1.0f},
                 .texture = texture,
                 .source = {0.0f, 0.0f, 4.0f, 2.0f}});
    const Image image = picture();
    expectNear(at(image, 2, 1), {255, 255, 0, 255});
    expectNear(at(image, 1, 1), chartColor(1, 1));
    device->destroyTexture(texture);
}

}  // namespace
}  // namespace plumb
