#include "editor/ui/tour.hpp"

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
        return tour->play(window, workspace,
                          {[this](const std::vector<Event>& events) { window.frame({events}); },
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
};

TEST_F(TourTest, whatALineSaysIsDone) {
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

TEST_F(TourTest, anErrorSaysWhichLineAndWhatThereIs) {
    EXPECT_NE(errorOf("wait 1\nclack @1,2").find("a.tour:2"), std::string::npos);
    EXPECT_NE(errorOf("clack @1,2").find("double-click"), std::string::npos);
    EXPECT_NE(errorOf("drag @1,2").find("drag @0,0 to @64,0"), std::string::npos);
    EXPECT_NE(errorOf("key Ctrl+Nothing").find("key Ctrl+Shift+Z"), std::string::npos);
    EXPECT_NE(errorOf("wait 0").find("wait 30"), std::string::npos);
    EXPECT_NE(errorOf("wait 99999999").find("wait 30"), std::string::npos);
    EXPECT_NE(errorOf("click @1,x").find("is not whole"), std::string::npos);
    EXPECT_NE(errorOf("click Toolbar/Plya").find("is not on the screen"), std::string::npos);
}

}  // namespace
}  // namespace plumb::editor::ui
