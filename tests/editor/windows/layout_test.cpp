#include "editor/model/view/layout.hpp"

#include <gtest/gtest.h>

#include "reflect/json.hpp"
#include "reflect/json_text.hpp"

namespace plumb::editor {
namespace {

constexpr std::array kPanels{PanelHome{"Scene", Dock::Left},         PanelHome{"Viewport", Dock::Center},
                             PanelHome{"Inspector", Dock::Right},    PanelHome{"Tiles", Dock::Bottom, true},
                             PanelHome{"Console", Dock::Bottom},     PanelHome{"History", Dock::Bottom},
                             PanelHome{"Assets", Dock::Bottom, true}};
using Tabs = std::vector<std::string>;

class Layouts : public testing::Test {
protected:
    Layouts() { layout.complete(kPanels); }
    [[nodiscard]] AABB boxOf(Dock dock, Vec2 size = {1280.0f, 640.0f}) const {
        return arrange(layout, kPanels, size, 4.0f, 100.0f).panes[static_cast<std::size_t>(dock)];
    }

    PaneLayout layout;
};

TEST_F(Layouts, eachPanelStartsInItsDefaultDock) {
    EXPECT_EQ(layout.pane(Dock::Left).tabs, Tabs{"Scene"});
    EXPECT_EQ(layout.pane(Dock::Center).tabs, Tabs{"Viewport"});
    EXPECT_EQ(layout.pane(Dock::Bottom).tabs, (Tabs{"Tiles", "Console", "History", "Assets"}));
    EXPECT_EQ(layout.pane(Dock::Bottom).front, "Tiles");
}

TEST_F(Layouts, movingAPanelShowsItsNeighbour) {
    layout.show("Console");
    layout.move("Console", Dock::Left, 0);
    EXPECT_EQ(layout.pane(Dock::Left).tabs, (Tabs{"Console", "Scene"}));
    EXPECT_EQ(layout.pane(Dock::Left).front, "Console");
    EXPECT_EQ(layout.pane(Dock::Bottom).front, "History");
}

TEST_F(Layouts, theViewportStaysAloneInTheCenter) {
    layout.move("Viewport", Dock::Left);
    layout.move("Scene", Dock::Center);
    layout.close("Viewport");
    EXPECT_EQ(layout.pane(Dock::Center).tabs, Tabs{"Viewport"});
    EXPECT_EQ(layout.pane(Dock::Left).tabs, Tabs{"Scene"});
}

TEST_F(Layouts, aClosedPanelReopensInItsOldDock) {
    layout.move("History", Dock::Right);
    layout.close("History");
    EXPECT_FALSE(layout.isOpen("History"));
    layout.complete(kPanels);
    EXPECT_FALSE(layout.isOpen("History")) << "it is closed, not forgotten";
    layout.show("History");
    EXPECT_EQ(layout.pane(Dock::Right).tabs, (Tabs{"Inspector", "History"}));
    EXPECT_TRUE(layout.isSeen("History"));
    layout.hidden = true;
    EXPECT_FALSE(layout.isSeen("History"));
}

TEST_F(Layouts, isReadBackAsWritten) {
    layout.move("Console", Dock::BottomRight);
    layout.close("History");
    layout.resize(Edge::Left, 0.3f);
    std::vector<Error> problems;
    const auto read =
        PaneLayout::fromJson(*parseJson(writeJson(layout.toJson()), "test"), "layout", problems);
    ASSERT_TRUE(read);
    EXPECT_TRUE(problems.empty());
    PaneLayout again = *read;
    again.complete(kPanels);
    EXPECT_EQ(again, layout);
}

TEST_F(Layouts, newPanelsUseTheirDefaultDockAndUnknownOnesAreIgnored) {
    std::vector<Error> problems;
    auto read = PaneLayout::fromJson(*parseJson(R"({"left": ["Scene", "Scene", "Gone"], "center": ["Console"],
        "right": ["Inspector"], "bottom": ["Tiles"], "front": {"left": "Gone"}})",
                                                "test"),
                                     "layout", problems);
    ASSERT_TRUE(read);
    read->complete(kPanels);
    EXPECT_EQ(read->pane(Dock::Left).tabs, Tabs{"Scene"});
    EXPECT_EQ(read->pane(Dock::Left).front, "Scene");
    EXPECT_EQ(read->pane(Dock::Center).tabs, Tabs{"Viewport"});
    EXPECT_EQ(read->pane(Dock::Bottom).tabs, (Tabs{"Tiles", "Console", "History", "Assets"}));
}

TEST_F(Layouts, errorsAreReportedByName) {
    std::vector<Error> problems;
    EXPECT_FALSE(PaneLayout::fromJson(*parseJson("[1, 2]", "test"), "settings.json: layout", problems));
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].where, "settings.json: layout");
    problems.clear();
    auto read = PaneLayout::fromJson(
        *parseJson(R"({"left": [7], "bottom": "all", "front": [], "closed": {"Console": 3},
        "sizes": {"left": 9000, "right": "wide"}})",
                   "test"),
        "layout", problems);
    ASSERT_TRUE(read);
    EXPECT_EQ(problems.size(), 4u);
    read->complete(kPanels);
    EXPECT_EQ(read->size(Edge::Left), PaneLayout{}.size(Edge::Left));
    EXPECT_TRUE(read->isOpen("Scene"));
    EXPECT_FALSE(read->isOpen("Console"));
}

TEST_F(Layouts, panesShareTheWindowWithoutGapsOrOverlaps) {
    layout.move("Console", Dock::BottomRight);
    for (const Vec2 size : {Vec2{1280.0f, 640.0f}, Vec2{2560.0f, 1380.0f}, Vec2{320.0f, 160.0f}}) {
        const PaneBoxes boxes = arrange(layout, kPanels, size, 4.0f, 100.0f);
        float area = 0.0f;
        std::vector<AABB> all(boxes.panes.begin(), boxes.panes.end());
        for (const PaneBoxes::Bar& bar : boxes.bars) all.push_back(bar.box);
        for (std::size_t i = 0; i < all.size(); ++i) {
            area += all[i].size().x * all[i].size().y;
            EXPECT_GT(std::min(all[i].size().x, all[i].size().y), 0.0f);
            for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(intersects(all[i], all[j])) << i << " and " << j;
        }
        EXPECT_EQ(boxes.bars.size(), 4u);
        EXPECT_FLOAT_EQ(area, size.x * size.y);
    }
}

TEST_F(Layouts, anEmptyPaneGivesItsSpaceToTheViewport) {
    const float before = boxOf(Dock::Center).size().x;
    layout.close("Scene");
    EXPECT_GT(boxOf(Dock::Center).size().x, before);
    EXPECT_EQ(boxOf(Dock::Left).size(), Vec2{});
    layout.hidden = true;
    EXPECT_EQ(boxOf(Dock::Center), (AABB{{}, {1280.0f, 640.0f}}));
}

TEST_F(Layouts, theBottomPaneHasTheHeightOfItsTallestPanel) {
    const float tall = boxOf(Dock::Bottom).size().y;
    layout.show("Console");
    EXPECT_EQ(boxOf(Dock::Bottom).size().y, tall) << "tabs that jump away from the mouse";
    layout.close("Tiles");
    layout.close("Assets");
    EXPECT_LT(boxOf(Dock::Bottom).size().y, tall);
}

TEST_F(Layouts, aDraggedTabIsDroppedUnderTheMouse) {
    const PaneBoxes boxes = arrange(layout, kPanels, {1280.0f, 640.0f}, 4.0f, 100.0f);
    EXPECT_EQ(dropAt(layout, boxes, {20.0f, 300.0f})->dock, Dock::Left);
    EXPECT_EQ(dropAt(layout, boxes, {300.0f, 630.0f})->dock, Dock::Bottom);
    EXPECT_EQ(dropAt(layout, boxes, {960.0f, 630.0f})->dock, Dock::BottomRight) << "it is divided by that";
    EXPECT_FALSE(dropAt(layout, boxes, {640.0f, 100.0f})) << "the scene stays alone";
    layout.close("Inspector");
    const PaneBoxes wider = arrange(layout, kPanels, {1280.0f, 640.0f}, 4.0f, 100.0f);
    EXPECT_EQ(dropAt(layout, wider, {1250.0f, 100.0f})->dock, Dock::Right) << "a pane comes back";
}

TEST_F(Layouts, presetsContainEveryPanel) {
    ASSERT_EQ(layoutPresets().size(), 3u);
    for (const LayoutPreset& preset : layoutPresets()) {
        PaneLayout one = preset.layout;
        one.complete(kPanels);
        for (const PanelHome& home : kPanels)
            EXPECT_TRUE(one.isOpen(home.title)) << preset.name << home.title;
    }
}

}  // namespace
}  // namespace plumb::editor
