#include "app/screen.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "reflect/type_registry.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/transform.hpp"
#include "scene/register_components.hpp"
#include "tests/support/places.hpp"

namespace plumb {
namespace {

constexpr int kWidth = 200;
constexpr int kHeight = 100;

struct ScaleCase {
    const char* name;
    WindowScale scale;
    int left;  ///< px; position of the image's upper left corner in the window
    int top;
};

Color at(const Image& image, int x, int y) {
    const std::size_t i = static_cast<std::size_t>(y * image.width + x) * 4;
    return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2], image.rgba[i + 3]};
}

TEST(Screen, theMousePositionIsInImagePixels) {
    Result<std::unique_ptr<Screen>> opened =
        Screen::open({"test", kWidth, kHeight, false, {64.0f, 36.0f}, WindowScale::Integer});
    ASSERT_TRUE(opened) << opened.error().text();
    InputFrame frame;
    frame.mouseX = 36 + 2 * 10;  // the image starts at (36, 14) and is enlarged by 2
    frame.mouseY = 14 + 2 * 20 + 1;
    (*opened)->placeMouse(frame);
    EXPECT_EQ(frame.mouseX, 10);
    EXPECT_EQ(frame.mouseY, 20);
    frame.mouseX = 1;
    frame.mouseY = 0;
    (*opened)->placeMouse(frame);
    EXPECT_EQ(frame.mouse(), (Vec2{-18.0f, -7.0f}));
    frame = {};
    (*opened)->placeMouse(frame);
    EXPECT_EQ(frame.mouse(), Vec2{}) << "no event has said yet where it is";
}

TEST(Screen, antialiasedEdgesAreBetweenInsideAndOutside) {
    TypeRegistry types;
    registerSceneComponents(types);
    const auto between = [&types](bool smooth) {
        ScreenSettings settings{"test", kWidth, kHeight, false, {200.0f, 100.0f}, WindowScale::Fit, smooth};
        Result<std::unique_ptr<Screen>> opened = Screen::open(settings);
        EXPECT_TRUE(opened) << opened.error().text();
        World world{types};
        AssetStore assets;
        Entity entity = world.createEntity();
        entity.addComponent<Transform>(60.0f, 20.0f).rotation = 0.3f;
        entity.addComponent<Sprite>(TextureId{}, 60, 40);
        (*opened)->draw(world, assets, 1.0f);
        const Image image = (*opened)->picture();
        int count = 0;
        for (std::size_t i = 0; i < image.rgba.size(); i += 4)
            count += image.rgba[i] > 20 && image.rgba[i] < 235 ? 1 : 0;
        return count;
    };
    EXPECT_EQ(between(false), 0);
    EXPECT_GT(between(true), 40);
}

TEST(Screen, afterTheCardHasLostEverythingThePictureIsTheSame) {
    TypeRegistry types;
    registerSceneComponents(types);
    for (const bool smooth : {false, true}) {
        ScreenSettings settings{"test", kWidth, kHeight, false, {200.0f, 100.0f}, WindowScale::Fit, smooth};
        Result<std::unique_ptr<Screen>> opened = Screen::open(settings);
        ASSERT_TRUE(opened) << opened.error().text();
        Screen& screen = **opened;
        World world{types};
        AssetStore assets{test::sourceFolder() / "projects/platformer"};
        Entity entity = world.createEntity();
        entity.addComponent<Transform>(60.0f, 20.0f).rotation = 0.3f;
        entity.addComponent<Sprite>(assets.loadTexture("bob.png"), 60, 40);
        const auto drawn = [&] {
            screen.draw(world, assets, 1.0f);
            return screen.picture().rgba;
        };
        const std::vector<std::uint8_t> before = drawn();
        EXPECT_GT(std::count_if(before.begin(), before.end(), [](std::uint8_t part) { return part > 20; }),
                  kWidth * kHeight + 1000)
            << "more than the opacity";
        for (int i = 0; i < 3; ++i) {
            screen.renew();
            EXPECT_EQ(drawn(), before);
            EXPECT_EQ(drawn(), before);
        }
    }
}

TEST(Screen, theImageIsScaledByTheModeAndTheRestOfTheWindowIsBlack) {
    constexpr Color kBlack{0, 0, 0, 255};
    constexpr Color kWhite{255, 255, 255, 255};
    for (const ScaleCase& item : {ScaleCase{"fit", WindowScale::Fit, 11, 0},
                                  {"integer", WindowScale::Integer, 36, 14},
                                  {"stretch", WindowScale::Stretch, 0, 0},
                                  {"fill", WindowScale::Fill, 0, 0}}) {
        SCOPED_TRACE(item.name);
        Result<std::unique_ptr<Screen>> opened =
            Screen::open({"test", kWidth, kHeight, false, {64.0f, 36.0f}, item.scale});
        ASSERT_TRUE(opened) << opened.error().text();
        Screen& screen = **opened;
        TypeRegistry types;
        registerSceneComponents(types);
        World world{types};
        AssetStore assets;
        Entity entity = world.createEntity();
        entity.addComponent<Transform>(-10.0f, -10.0f);  // the sprite extends beyond the image on every side
        entity.addComponent<Sprite>(TextureId{}, 84, 56);
        screen.draw(world, assets, 1.0f);
        const Image image = screen.picture();
        ASSERT_EQ(image.width, kWidth);
        const int right = kWidth - 1 - item.left;
        const int bottom = kHeight - 1 - item.top;
        EXPECT_EQ(at(image, item.left, 50), kWhite);
        EXPECT_EQ(at(image, right, 50), kWhite);
        EXPECT_EQ(at(image, 100, item.top), kWhite);
        EXPECT_EQ(at(image, 100, bottom), kWhite);
        if (item.left > 0) {
            EXPECT_EQ(at(image, item.left - 1, 50), kBlack);
            EXPECT_EQ(at(image, right + 1, 50), kBlack);
        }
        if (item.top > 0) {
            EXPECT_EQ(at(image, 100, item.top - 1), kBlack);
            EXPECT_EQ(at(image, 100, bottom + 1), kBlack);
        }
    }
}

}  // namespace
}  // namespace plumb
