#include "render/view.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "math/portable.hpp"
#include "render/camera_motion.hpp"

namespace plumb {
namespace {

View randomView(Random& random) {
    return {.center = {random.between(-500.0f, 500.0f), random.between(-500.0f, 500.0f)},
            .size = {random.between(100.0f, 1000.0f), random.between(100.0f, 1000.0f)},
            .zoom = random.between(0.2f, 8.0f),
            .rotation = random.between(-3.0f, 3.0f)};
}

TEST(View, worldAndScreenAreInversesAndAgreeWithTheTransform) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(seed);
        Random random{seed};
        const View view = randomView(random);
        const Vec2 screen{random.between(0.0f, view.size.x), random.between(0.0f, view.size.y)};
        const Vec2 world = toWorld(view, screen);
        EXPECT_LT(distance(toScreen(view, world), screen), 0.01f);
        const ViewTransform transform = transformOf(view);
        const Vec2 clip = Vec2{dot(transform.x, world), dot(transform.y, world)} + transform.offset;
        EXPECT_NEAR((clip.x + 1.0f) * 0.5f * view.size.x, screen.x, 0.05f);
        EXPECT_NEAR((1.0f - clip.y) * 0.5f * view.size.y, screen.y, 0.05f);
        EXPECT_TRUE(contains(grown(visibleBox(view), 0.01f), world));
    }
}

TEST(View, theViewsCenterIsInTheMiddleOfTheScreen) {
    const View view{.center = {30.0f, -7.0f}, .size = {320.0f, 180.0f}, .zoom = 2.0f, .rotation = 1.0f};
    EXPECT_EQ(toScreen(view, view.center), (Vec2{160.0f, 90.0f}));
}

TEST(View, snappingAlignsWorldPixelsToScreenPixels) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Random random{seed};
        View view{.center = {random.between(-90.0f, 90.0f), random.between(-90.0f, 90.0f)},
                  .size = {320.0f, 181.0f}};
        view.zoom = static_cast<float>(1 + random.below(4));
        const Vec2 screen = toScreen(snappedToPixels(view), {17.0f, 5.0f});
        EXPECT_NEAR(screen.x, std::round(screen.x), 1.0e-3f);
        EXPECT_NEAR(screen.y, std::round(screen.y), 1.0e-3f);
        EXPECT_LE(distance(snappedToPixels(view).center, view.center), 0.75f / view.zoom);
    }
}

struct ScaleCase {
    WindowScale scale;
    PixelSize window;
    Viewport expected;
};

TEST(WindowScale, everyModeComputesTheExpectedViewport) {
    const Vec2 picture{320.0f, 180.0f};
    const std::array cases{
        ScaleCase{WindowScale::Fit, {1280, 720}, {.x = 0, .y = 0, .width = 1280, .height = 720}},
        ScaleCase{WindowScale::Fit, {1000, 720}, {.x = 0, .y = 78, .width = 1000, .height = 563}},
        ScaleCase{WindowScale::Integer, {1000, 720}, {.x = 20, .y = 90, .width = 960, .height = 540}},
        ScaleCase{WindowScale::Integer, {160, 90}, {.x = 0, .y = 0, .width = 160, .height = 90}},
        ScaleCase{WindowScale::Stretch, {1000, 720}, {.x = 0, .y = 0, .width = 1000, .height = 720}},
        ScaleCase{WindowScale::Fill, {1000, 720}, {.x = -140, .y = 0, .width = 1280, .height = 720}},
    };
    for (const ScaleCase& item : cases) {
        SCOPED_TRACE(testing::Message() << static_cast<int>(item.scale) << " " << item.window.width);
        EXPECT_EQ(viewportFor(item.scale, picture, item.window), item.expected);
    }
    EXPECT_EQ(viewportFor(WindowScale::Integer, picture, {0, 0}).width, 1);
}

TEST(WindowScale, windowPositionsAreConvertedToScreenPositions) {
    const Viewport viewport = viewportFor(WindowScale::Integer, {320.0f, 180.0f}, {1000, 720});
    EXPECT_EQ(screenFromWindow(viewport, {320.0f, 180.0f}, {20.0f, 90.0f}), (Vec2{0.0f, 0.0f}));
    EXPECT_EQ(screenFromWindow(viewport, {320.0f, 180.0f}, {500.0f, 360.0f}), (Vec2{160.0f, 90.0f}));
}

TEST(CameraMotion, theCameraMovesOnlyIfTheTargetLeavesTheDeadZone) {
    EXPECT_EQ(keptInDeadZone({0.0f, 0.0f}, {9.0f, -9.0f}, {20.0f, 20.0f}), (Vec2{0.0f, 0.0f}));
    EXPECT_EQ(keptInDeadZone({0.0f, 0.0f}, {15.0f, -30.0f}, {20.0f, 20.0f}), (Vec2{5.0f, -20.0f}));
    EXPECT_EQ(keptInDeadZone({0.0f, 0.0f}, {15.0f, -30.0f}, {}), (Vec2{15.0f, -30.0f}));
}

TEST(CameraMotion, smoothingDependsOnTimeAndNotOnTheLengthOfTicks) {
    Vec2 coarse{};
    Vec2 fine{};
    for (int i = 0; i < 30; ++i) coarse = approached(coarse, {100.0f, 50.0f}, 0.5f, 1.0f / 60.0f);
    for (int i = 0; i < 120; ++i) fine = approached(fine, {100.0f, 50.0f}, 0.5f, 1.0f / 240.0f);
    EXPECT_LT(distance(coarse, fine), 0.01f);
    EXPECT_NEAR(coarse.x, 95.02f, 0.05f);
    EXPECT_EQ(approached({}, {7.0f, 8.0f}, 0.0f, 0.1f), (Vec2{7.0f, 8.0f}));
}

TEST(CameraMotion, theViewStaysInsideItsLimits) {
    const Rect limits{0.0f, 0.0f, 1000.0f, 100.0f};
    EXPECT_EQ(keptInLimits({10.0f, 10.0f}, {320.0f, 180.0f}, limits), (Vec2{160.0f, 50.0f}));
    EXPECT_EQ(keptInLimits({990.0f, 10.0f}, {320.0f, 80.0f}, limits), (Vec2{840.0f, 40.0f}));
    EXPECT_EQ(keptInLimits({-5.0f, 3.0f}, {320.0f, 80.0f}, {}), (Vec2{-5.0f, 3.0f}));
}

TEST(CameraMotion, aShakeStaysWithinItsStrengthAndEnds) {
    float most = 0.0f;
    for (int i = 0; i < 60; ++i) {
        const Vec2 offset = shakeOffset(8.0f, 0.5f, static_cast<float>(i) / 60.0f);
        EXPECT_LE(std::abs(offset.x), 8.0f);
        EXPECT_LE(std::abs(offset.y), 8.0f);
        most = std::max(most, length(offset));
        EXPECT_TRUE(i < 30 || offset == Vec2{});
    }
    EXPECT_GT(most, 2.0f);
    EXPECT_EQ(shakeOffset(8.0f, 0.0f, 0.0f), Vec2{});
}

}  // namespace
}  // namespace plumb
