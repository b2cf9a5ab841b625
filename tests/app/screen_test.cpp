#include "app/screen.hpp"

#include <gtest/gtest.h>

#include "reflect/type_registry.hpp"
#include "scene/components/sprite.hpp"
#include "scene/components/transform.hpp"
#include "scene/register_components.hpp"

namespace plumb {
namespace {

constexpr int kWidth = 200;
constexpr int kHeight = 100;

struct ScaleCase {
    const char* name;
    WindowScale scale;
    int left;  ///< px: the first column and row of the window that shows the picture
    int top;
};

Color at(const Image& image, int x, int y) {
    const std::size_t i = static_cast<std::size_t>(y * image.width + x) * 4;
    return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2], image.rgba[i + 3]};
}

TEST(Screen, thePictureIsScaledAsAskedAndWhatIsLeftOfTheWindowIsBlack) {
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
        entity.addComponent<Transform>(-10.0f, -10.0f);  // reaches past the picture on every side
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
