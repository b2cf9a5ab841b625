// The bars of the window at every size and scale: no widgets overlap or are cut off, and those without space
// are in a list.

#include <array>

#include "editor/ui/widgets/bar.hpp"
#include "editor/ui/widgets/fitted_text.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {
namespace {

constexpr std::array kSizes{PixelSize{800, 500},  PixelSize{1024, 600},  PixelSize{1280, 720},
                            PixelSize{1366, 768}, PixelSize{1920, 1080}, PixelSize{2560, 1440},
                            PixelSize{3840, 2160}};
constexpr std::array kScales{0.75f, 1.0f, 1.25f, 1.5f, 2.0f, 2.5f, 3.0f};

class WindowSizes : public EditorFixture {
protected:
    WindowSizes() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {}

    void show(PixelSize size, float scale) {
        workspace.settings.scale = scale;
        hands.size = size;
        hands.rest(3);
    }
    [[nodiscard]] bool onScreen(std::string_view widget) const {
        return window.widgets().find(widget) != nullptr;
    }
    /// Widgets of the bars, without the entries of their lists.
    [[nodiscard]] std::vector<std::pair<std::string, AABB>> bars() const {
        std::vector<std::pair<std::string, AABB>> found;
        for (const auto& [name, widget] : window.widgets().all()) {
            for (const char* bar : {"Toolbar/", "Overlay/", "Menu/", "Status/"}) {
                if (name.find(bar) == 0 && name.find('/') == name.rfind('/'))
                    found.emplace_back(name, widget.box);
            }
        }
        return found;
    }
    void expectTidy(PixelSize size) const {
        const auto all = bars();
        EXPECT_GT(all.size(), 8u);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto& [name, box] = all[i];
            EXPECT_GE(box.min.x, 0.0f) << name;
            EXPECT_LE(box.max.x, static_cast<float>(size.width) + 0.5f) << name;
            EXPECT_LE(box.max.y, static_cast<float>(size.height) + 0.5f) << name;
            for (std::size_t j = i + 1; j < all.size(); ++j) {
                const AABB& other = all[j].second;
                const bool apart = box.max.x <= other.min.x + 0.5f || other.max.x <= box.min.x + 0.5f ||
                                   box.max.y <= other.min.y + 0.5f || other.max.y <= box.min.y + 0.5f;
                EXPECT_TRUE(apart) << name << " and " << all[j].first;
            }
        }
    }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

TEST_F(WindowSizes, widgetsOfTheBarsNeitherOverlapNorAreCutOff) {
    for (const float scale : kScales) {
        for (const PixelSize size : kSizes) {
            SCOPED_TRACE(format("{}x{} at {} %", size.width, size.height, scale * 100.0f));
            workspace.notice = "Somewhere, a notice is as long as this one, which has a lot to say about it";
            show(size, scale);
            expectTidy(size);
            EXPECT_TRUE(onScreen("Toolbar/Play"));
        }
    }
}

TEST_F(WindowSizes, theLogAndTheNoticeShareTheStatusBar) {
    logError("Test", Error{"test", "one", "none"});
    for (const PixelSize size : {PixelSize{800, 500}, PixelSize{1280, 720}}) {
        for (const float scale : {1.0f, 1.5f, 3.0f}) {
            SCOPED_TRACE(format("{}x{} at {} %", size.width, size.height, scale * 100.0f));
            show(size, scale);
            expectTidy(size);
        }
    }
}

TEST_F(WindowSizes, toolbarItemsWithoutSpaceAreInItsList) {
    show({1280, 720}, 1.0f);
    EXPECT_FALSE(onScreen("Toolbar/more")) << "all of it fits";
    show({800, 500}, 1.5f);
    ASSERT_TRUE(onScreen("Toolbar/more"));
    EXPECT_FALSE(onScreen("Overlay/grid"));
    const bool grid = workspace.shows("grid");
    hands.click("Toolbar/more");
    hands.rest(2);
    hands.click("Toolbar/more/Grid");
    EXPECT_NE(workspace.shows("grid"), grid);
    hands.rest(2);
    hands.click("Toolbar/more");
    hands.rest(2);
    hands.click("Toolbar/more/Brush");
    EXPECT_TRUE(workspace.paintsTiles());
    hands.rest(2);
    hands.click("Toolbar/Play");
    EXPECT_FALSE(workspace.shows("collision")) << "one click does one thing";
}

TEST_F(WindowSizes, menusWithoutSpaceAreInAnOverflowMenu) {
    show({800, 500}, 3.0f);
    ASSERT_TRUE(onScreen("Menu/more"));
    EXPECT_FALSE(onScreen("Menu/Run"));
    hands.click("Menu/more");
    hands.rest(2);
    EXPECT_TRUE(onScreen("Menu/Run"));
}

TEST_F(WindowSizes, theButtonsOfADialogAreVisibleInTheSmallestWindow) {
    for (const float scale : {1.0f, 2.0f, 3.0f}) {
        SCOPED_TRACE(scale);
        show({800, 500}, scale);
        workspace.request = WindowRequest::NameNewScene;
        hands.rest(3);
        for (const char* name : {"New/Create", "New/Cancel"}) {
            const WidgetMap::Widget* widget = window.widgets().find(name);
            ASSERT_NE(widget, nullptr) << name;
            EXPECT_GE(widget->box.min.x, 0.0f) << name;
            EXPECT_LE(widget->box.max.x, 800.0f) << name;
            EXPECT_LE(widget->box.min.y, 500.0f) << name;
        }
        hands.click("New/Cancel");
        hands.rest(3);
        EXPECT_FALSE(onScreen("New/Cancel"));
    }
}

TEST(BarGroups, groupsOfLowPriorityAreHiddenFirstWithSpaceForTheListButton) {
    const std::array groups{BarGroup{100.0f, 2}, BarGroup{100.0f, 1}, BarGroup{100.0f, 3}};
    using Shown = std::vector<bool>;
    EXPECT_EQ(shownGroups(groups, 320.0f, 10.0f, 20.0f), (Shown{true, true, true}));
    EXPECT_EQ(shownGroups(groups, 319.0f, 10.0f, 20.0f), (Shown{true, false, true}));
    EXPECT_EQ(shownGroups(groups, 239.0f, 10.0f, 20.0f), (Shown{false, false, true}));
    EXPECT_EQ(shownGroups(groups, 129.0f, 10.0f, 20.0f), (Shown{false, false, false}));
}

TEST_F(WindowSizes, aShortenedTextKeepsItsBeginningAndItsEnd) {
    const std::string name = "background_forest_far.png";
    std::string fitted, none, whole;
    hands.rest();
    ImGui::NewFrame();
    const float width = ImGui::CalcTextSize(name.c_str()).x;
    whole = fittedText(name, width);
    fitted = fittedText(name, width * 0.6f);
    none = fittedText(name, 2.0f);
    ImGui::EndFrame();
    EXPECT_EQ(whole, name);
    EXPECT_EQ(none, "");
    EXPECT_EQ(fitted.find("ba"), 0u) << fitted;
    EXPECT_NE(fitted.find("png"), std::string::npos) << fitted;
    EXPECT_NE(fitted.find("\xe2\x80\xa6"), std::string::npos) << fitted;
}

}  // namespace
}  // namespace plumb::editor::ui
