#include <algorithm>

#include <imgui.h>

#include "editor/model/cost/island_table.hpp"
#include "editor/ui/overlays/cost_overlays.hpp"
#include "tests/editor/support/cost_scenes.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {
namespace {

class CostPanelTest : public CostFixture {
protected:
    CostPanelTest() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {}

    void showPanel() {
        workspace.settings.layout.show("Cost");
        hands.rest(3);
    }
    [[nodiscard]] bool onScreen(std::string_view widget) { return window.widgets().find(widget) != nullptr; }
    [[nodiscard]] std::string valueOf(std::string_view widget) {
        const auto* found = window.widgets().find(widget);
        return found == nullptr ? "(none)" : found->value;
    }
    /// Clicks "Measure" and runs frames until the measuring thread has finished.
    void clickMeasure() {
        hands.click("Cost/measure");
        for (int frame = 0; frame < 200000 && !onScreen("Cost/verdict"); ++frame) hands.rest();
        ASSERT_TRUE(onScreen("Cost/verdict")) << valueOf("Cost/refusal");
        hands.rest(2);
    }
    void playFor(int ticks) {
        workspace.startPlaying(true);
        for (int tick = 0; tick < ticks; ++tick) workspace.play.step({});
        hands.rest(2);
    }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

TEST_F(CostPanelTest, measuringRecommendsAQualityThatAButtonApplies) {
    open(CostScene{R"("quality": 0)"}.stack(12));
    showPanel();
    EXPECT_TRUE(onScreen("Cost/lesson"));
    playFor(200);
    clickMeasure();
    EXPECT_NE(valueOf("Cost/verdict").find("Current quality 0"), std::string::npos)
        << valueOf("Cost/verdict");
    EXPECT_EQ(valueOf("Cost/curve/0"), "present");
    EXPECT_EQ(valueOf("Cost/quality/1").find("Quality 1: "), 0u) << valueOf("Cost/quality/1");
    EXPECT_FALSE(onScreen("Cost/use/0")) << "it is the present one";
    int enough = -1;
    for (int quality = 1; quality <= 6; ++quality) {
        if (valueOf(format("Cost/use/{}", quality)) == "enough") enough = quality;
    }
    ASSERT_GT(enough, 0);
    hands.click(format("Cost/use/{}", enough));
    hands.rest(2);
    EXPECT_EQ(scenePhysics(workspace.play.world())->quality, enough);
    EXPECT_EQ(valueOf(format("Cost/curve/{}", enough)), "present") << "the mark follows";
    workspace.stopPlaying();
    ASSERT_EQ(workspace.offeredChanges.size(), 1u);
}

TEST_F(CostPanelTest, aClickOnTheCurveSetsTheQualityOfTheSceneAndUndoRevertsIt) {
    open(CostScene{}.stack(10));
    showPanel();
    const std::string before = workspace.text();
    clickMeasure();
    hands.click("Cost/curve/5");
    ASSERT_NE(scenePhysics(workspace.document.world), nullptr);
    EXPECT_EQ(scenePhysics(workspace.document.world)->quality, 5);
    hands.rest(2);
    EXPECT_EQ(valueOf("Cost/curve/5"), "present");
    hands.key(Key::Z, {.control = true});
    EXPECT_EQ(workspace.text(), before);
    hands.rest(2);
    EXPECT_EQ(valueOf("Cost/curve/2"), "present");
}

TEST_F(CostPanelTest, adviceIsCountedOnItsPageAndItsRemedyIsOneClick) {
    open(CostScene{R"("sleeping": false)"}.stack(1).stack(1, 200));
    showPanel();
    clickMeasure();
    EXPECT_EQ(valueOf("Cost/page/Advice"), "Advice (1)");
    hands.click("Cost/page/Advice");
    hands.rest(2);
    EXPECT_EQ(valueOf("Cost/advice/sleep").find("2 bodies could sleep"), 0u) << valueOf("Cost/advice/sleep");
    hands.click("Cost/about/sleep");
    EXPECT_EQ(workspace.document.selection.size(), 2u);
    hands.click("Cost/remedy/sleep");
    EXPECT_TRUE(scenePhysics(workspace.document.world)->sleeping);
    hands.rest(2);
    EXPECT_TRUE(onScreen("Cost/advice/none"));
}

TEST_F(CostPanelTest, aClickOnAnIslandSelectsItsEntitiesAndColumnsSort) {
    open(CostScene{}.stack(6, 100.0f).stack(2, 400.0f));
    showPanel();
    hands.click("Cost/page/Islands");
    hands.rest(2);
    EXPECT_TRUE(onScreen("Cost/empty"));
    playFor(10);
    hands.rest(2);
    ASSERT_EQ(valueOf("Cost/islands"), "2");
    EXPECT_EQ(valueOf("Cost/island/0"), "6") << "the dearest first";
    hands.click("Cost/island/0");
    EXPECT_EQ(workspace.document.selection.size(), 6u);
    hands.click("Cost/sort/bodies");
    hands.rest(2);
    hands.click("Cost/sort/bodies");
    hands.rest(2);
    EXPECT_EQ(valueOf("Cost/island/0"), "2");
    hands.click("Cost/island/0");
    EXPECT_EQ(workspace.document.selection.size(), 2u);
}

TEST_F(CostPanelTest, stagesOfThePhysicsAreBarsWithMedianAndMaximum) {
    open(CostScene{R"("sleeping": false)"}.stack(6));
    showPanel();
    hands.click("Cost/page/Stages");
    hands.rest(2);
    EXPECT_TRUE(onScreen("Cost/empty"));
    playFor(1);
    for (int tick = 0; tick < 40; ++tick) {
        workspace.play.step({});
        hands.rest();
    }
    for (const char* stage : {"broad phase", "narrow phase", "solve", "finish bodies", "events"})
        EXPECT_TRUE(onScreen(std::string{"Cost/stage/"} + stage)) << stage;
    EXPECT_LE(std::stof(valueOf("Cost/median/solve")), std::stof(valueOf("Cost/p99/solve")));
    EXPECT_NE(valueOf("Cost/tick"), "(none)");
}

TEST_F(CostPanelTest, theOpenPanelDoesNotChangeTheGame) {
    open(CostScene{R"("sleeping": false)"}.stack(6));
    workspace.settings.layout.show("Console");
    hands.rest(3);
    const auto playAndHash = [&] {
        workspace.startPlaying(true);
        for (int tick = 0; tick < 120; ++tick) {
            workspace.play.step({});
            hands.rest();
        }
        const std::uint64_t hash = workspace.play.world().hash();
        workspace.stopPlaying();
        workspace.offeredChanges.clear();
        return hash;
    };
    const std::uint64_t alone = playAndHash();
    showPanel();
    workspace.setReach("bodyErrors", PhysicsReach::All);
    workspace.setReach("contactForces", PhysicsReach::All);
    workspace.startPlaying(true);
    for (int tick = 0; tick < 60; ++tick) {
        workspace.play.step({});
        hands.rest();
    }
    hands.click("Cost/measure");
    for (int tick = 60; tick < 120; ++tick) {
        workspace.play.step({});
        hands.rest();
    }
    EXPECT_GT(islandRows(workspace.play.world(), 1.0f).at(0).report.contacts, 0u);
    EXPECT_EQ(workspace.play.world().hash(), alone);
}

TEST_F(CostPanelTest, largeErrorsAreDrawnInAClassOfTheirOwn) {
    open(CostScene{R"("quality": 0, "sleeping": false)"}.stack(12));
    playFor(150);
    workspace.setReach("bodyErrors", PhysicsReach::All);
    Overlay errors;
    drawBodyErrors(workspace, workspace.play.world(), errors);
    EXPECT_GE(std::count_if(errors.shapes().begin(), errors.shapes().end(),
                            [&](const Overlay::Shape& shape) {
                                return shape.kind != Overlay::Kind::Text &&
                                       shape.color == kErrorShades.back().color;
                            }),
              5)
        << "a box, and a line in the legend";
}

TEST_F(CostPanelTest, errorsAndForcesAreDrawnInClassesWithALegend) {
    open(CostScene{R"("quality": 1, "sleeping": false)"}.stack(20, 100.0f).stack(4, 400.0f));
    playFor(150);
    const World& world = workspace.play.world();
    workspace.setReach("bodyErrors", PhysicsReach::All);
    Overlay errors;
    drawBodyErrors(workspace, world, errors);
    const auto strokes = [](const Overlay& overlay, Color color) {
        return std::count_if(overlay.shapes().begin(), overlay.shapes().end(),
                             [&](const Overlay::Shape& shape) {
                                 return shape.kind != Overlay::Kind::Text && shape.color == color;
                             });
    };
    const auto says = [](const Overlay& overlay, std::string_view words) {
        return std::any_of(
            overlay.shapes().begin(), overlay.shapes().end(),
            [&](const Overlay::Shape& shape) { return shape.text.find(words) != std::string::npos; });
    };
    for (const CostShade& shade : kErrorShades) {
        EXPECT_TRUE(says(errors, shade.label)) << shade.label;
        if (shade.from >= 2.0f) continue;  // largeErrorsAreDrawnInAClassOfTheirOwn checks these
        EXPECT_GE(strokes(errors, shade.color), 5) << shade.label << ": a box, and a line in the legend";
    }
    EXPECT_TRUE(says(errors, " px")) << "the worst have their number";
    const std::size_t all = errors.shapes().size();
    workspace.setReach("bodyErrors", PhysicsReach::Selected);
    workspace.document.selection.set({named("box 0")});
    errors.clear();
    drawBodyErrors(workspace, world, errors);
    EXPECT_LT(errors.shapes().size(), all);
    Overlay forces;
    workspace.setReach("contactForces", PhysicsReach::All);
    drawContactForces(workspace, world, forces);
    EXPECT_TRUE(says(forces, kForceShades[3].label));
    const auto dots = std::count_if(forces.shapes().begin(), forces.shapes().end(),
                                    [](const auto& shape) { return shape.kind == Overlay::Kind::Circle; });
    EXPECT_GE(dots, 8);
    workspace.stopPlaying();
    forces.clear();
    drawContactForces(workspace, workspace.document.world, forces);
    EXPECT_TRUE(forces.shapes().empty()) << "nothing pushes while the game does not run";
}

}  // namespace
}  // namespace plumb::editor::ui
