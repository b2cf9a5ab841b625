#include "platform/window.hpp"

#include <gtest/gtest.h>

#include "platform/paths.hpp"

namespace plumb {
namespace {

TEST(Window, opensWithoutADisplayAndReportsIt) {
    const Result<std::unique_ptr<Window>> opened =
        Window::open({.width = 320, .height = 180, .hidden = true});
    ASSERT_TRUE(opened) << opened.error().text();
    const Window& window = **opened;
    EXPECT_EQ(window.size(), (PixelSize{320, 180}));
    EXPECT_EQ(window.drawableSize(), (PixelSize{320, 180}));
    EXPECT_FALSE(window.hasDisplay());
    EXPECT_FALSE(window.fullscreen());
}

TEST(Window, canBeOpenedAgainAfterItWasClosed) {
    for (int i = 0; i < 3; ++i) {
        Result<std::unique_ptr<Window>> opened = Window::open({.width = 64, .height = 64, .hidden = true});
        ASSERT_TRUE(opened) << opened.error().text();
        std::vector<Event> events;
        (*opened)->pollEvents(events);
        (*opened)->swap();
    }
}

TEST(Paths, theEngineFindsItsOwnAssets) {
    EXPECT_TRUE(std::filesystem::is_directory(engineAssets() / "fonts"));
    EXPECT_TRUE(std::filesystem::is_directory(executableFolder()));
}

}  // namespace
}  // namespace plumb
