#include "editor/ui/tour.hpp"

#include <imgui.h>

#include "core/text.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {
namespace {

class TourTest : public EditorFixture {
protected:
    TourTest() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"} {}

    Result<Done> play(std::string_view text) {
        const Result<Tour> tour = Tour::read(text, "a.tour");
        if (!tour) return tour.error();
        return tour->play({[this]() -> const EditorWindow& { return window; },
                           [this]() -> const Workspace& { return workspace; },
                           [this](const std::vector<Event>& events) {
                               for (const Event& event : events) {
                                   if (event.key == Key::Right)
                                       down += event.kind == EventKind::KeyDown ? 1 : -1;
                               }
                               window.frame({events});
                           },
                           [this](std::string_view path) {
                               pictures.emplace_back(path);
                               return Result<Done>{Done{}};
                           }});
    }
    std::string errorOf(std::string_view text) {
        const Result<Done> done = play(text);
        return done ? "" : done.error().text();
    }

    LogBook log;
    EditorWindow window;
    std::vector<std::string> pictures;
    int down = 0;  // number of presses of the key Right
};

TEST_F(TourTest, eachLineIsExecuted) {
    const Result<Done> done = play(R"(
# the crate goes 40 px to the right, and gets a name
key Shift+S
drag @216,80 to @256,80
picture images/moved.png
key F2
key Ctrl+A
type box
key Enter
wait 5
)");
    ASSERT_TRUE(done.ok()) << done.error().text();
    EXPECT_EQ(positionOf(named("box")), (Vec2{240.0f, 64.0f}));
    EXPECT_EQ(pictures, std::vector<std::string>{"images/moved.png"});
}

TEST_F(TourTest, keysAreHeldWhileTheMouseActsAndUntilTheyAreReleased) {
    ASSERT_TRUE(play("click Scene/crate\nclick Scene/camera with Ctrl").ok());
    EXPECT_EQ(workspace.document.selection.size(), 2u);
    ASSERT_TRUE(play("press Right\nwait 30").ok());
    EXPECT_EQ(down, 1);
    ASSERT_TRUE(play("release Right").ok());
    EXPECT_EQ(down, 0);
}

TEST_F(TourTest, aPositionAlongAWidgetIsGivenInPercent) {
    for (const int percent : {25, 75}) {
        const Result<Done> done =
            play(format("click Scene/ground\nclick Tab/Tiles\nclick Tiles/layer/opacity {}%", percent));
        ASSERT_TRUE(done.ok()) << done.error().text();
        EXPECT_NEAR(parseFloat(window.widgets().find("Tiles/layer/opacity")->value).value(),
                    static_cast<float>(percent), 5.0f);
    }
}

TEST_F(TourTest, aSecondPercentageIsTheVerticalPosition) {
    ASSERT_TRUE(play("move Viewport 25% 75%").ok());
    const AABB box = window.widgets().find("Viewport")->box;
    EXPECT_NEAR(ImGui::GetIO().MousePos.x, box.min.x + 0.25f * box.size().x, 1.0f);
    EXPECT_NEAR(ImGui::GetIO().MousePos.y, box.min.y + 0.75f * box.size().y, 1.0f);
}

TEST_F(TourTest, anErrorNamesItsLineAndTheExistingWidgets) {
    EXPECT_NE(errorOf("wait 1\nclack @1,2").find("a.tour:2"), std::string::npos);
    EXPECT_NE(errorOf("clack @1,2").find("double-click"), std::string::npos);
    EXPECT_NE(errorOf("drag @1,2").find("drag @0,0 to @64,0"), std::string::npos);
    EXPECT_NE(errorOf("key Ctrl+Nothing").find("key Ctrl+Shift+Z"), std::string::npos);
    EXPECT_NE(errorOf("click @1,2 with Strg").find("with Ctrl+Shift"), std::string::npos);
    EXPECT_NE(errorOf("wait 0").find("wait 30"), std::string::npos);
    EXPECT_NE(errorOf("wait 99999999").find("wait 30"), std::string::npos);
    EXPECT_NE(errorOf("click @1,x").find("is not a complete action"), std::string::npos);
    EXPECT_NE(errorOf("click Toolbar/Plya").find("is not on the screen"), std::string::npos);
}

}  // namespace
}  // namespace plumb::editor::ui
