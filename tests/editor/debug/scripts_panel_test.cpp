#include <filesystem>

#include "tests/editor/keys/desk.hpp"
#include "tests/editor/support/script_game.hpp"

namespace plumb::editor::ui {
namespace {

/// The editor with a scene of two counters and the file of their script.
class ScriptsPanel : public Desk {
protected:
    ScriptsPanel() {
        putFile("scenes/counters.scene.json", ScriptGame::kCounters);
        EXPECT_TRUE(workspace.open("scenes/counters.scene.json").ok());
        log.clear();
    }
    ~ScriptsPanel() override { workspace.play.stop(); }

    /// Writes the script and shows the panel.
    void use(const char* script) {
        putFile("scripts/counter.lua", script);
        game = std::make_unique<ScriptGame>(ScriptGame::Texts{{"counter", script}});
        workspace.makeSession = [this](const std::string&, const std::string&) { return game->start(); };
        workspace.settings.layout.show("Scripts");
        hands.rest(40);  // files are read twice a second
    }
    void bringIntoSight(int line) {
        workspace.scripts.show({"scripts/counter.lua", line});
        hands.rest(3);
    }
    [[nodiscard]] int line() const {
        return workspace.debugger.halt() == nullptr ? 0 : workspace.debugger.halt()->line;
    }

    std::unique_ptr<ScriptGame> game;
};

TEST_F(ScriptsPanel, withoutScriptsItSaysHowToAddOne) {
    workspace.settings.layout.show("Scripts");
    hands.rest(2);
    EXPECT_EQ(valueOf("Scripts/empty"), "This project has no scripts yet.");
}

TEST_F(ScriptsPanel, aBreakpointStopsTheGameAndKeysStepForthAndBack) {
    use(kCounter);
    EXPECT_EQ(valueOf("Scripts/files"), "scripts/counter.lua");
    EXPECT_EQ(valueOf("Scripts/Over"), "off") << "nothing is stopped yet";
    bringIntoSight(11);
    hands.click("Scripts/line/11");
    EXPECT_EQ(valueOf("Scripts/line/11"), "on");
    workspace.settings.layout.show("Console");
    press("F5");
    hands.rest(5);
    ASSERT_EQ(line(), 11);
    EXPECT_EQ(valueOf("Tab/Scripts"), "front") << "the panel shows where the game is stopped";
    EXPECT_EQ(valueOf("Scripts/current"), "11");
    EXPECT_EQ(valueOf("Scripts/state").find("Stopped at line 11 in \"first\", tick 1"), 0u)
        << valueOf("Scripts/state");
    EXPECT_EQ(valueOf("Scripts/frame/0"), "onTick scripts/counter.lua:11");

    press("F10");
    EXPECT_EQ(line(), 12);
    EXPECT_EQ(valueOf("Scripts/variable/far"), "2");
    press("Shift+F10");
    EXPECT_EQ(line(), 4) << "the last line of the function that was stepped over";
    EXPECT_EQ(valueOf("Scripts/variable/y"), "2");
    hands.click("Scripts/frame/1");
    EXPECT_EQ(valueOf("Scripts/current"), "11") << "the caller";
    EXPECT_TRUE(shown("Scripts/variable/dt"));
    press("Shift+F11");
    EXPECT_EQ(line(), 12);
    hands.click("Scripts/Into");
    hands.click("Scripts/Back");
    EXPECT_EQ(line(), 12);

    press("F6");
    hands.rest(5);
    EXPECT_EQ(line(), 11) << "of the second entity";
    hands.click("Scripts/line/11");
    EXPECT_EQ(valueOf("Scripts/line/11"), "");
    press("F6");
    hands.rest(30);
    EXPECT_FALSE(workspace.play.paused());
    EXPECT_GT(workspace.play.ticks(), 20);
}

TEST_F(ScriptsPanel, filesAreChosenInAListOrInAColumn) {
    putFile("scripts/enemies/bat.lua", "return {}\n");
    use(kCounter);
    EXPECT_EQ(valueOf("Scripts/files"), "scripts/counter.lua");
    hands.click("Scripts/files");
    hands.rest(2);
    hands.click("Scripts/file/scripts/enemies/bat.lua");
    hands.rest(2);
    EXPECT_EQ(valueOf("Scripts/files"), "scripts/enemies/bat.lua");
    hands.size = {1800, 900};
    hands.rest(3);
    EXPECT_FALSE(shown("Scripts/files")) << "there is room for a column";
    hands.click("Scripts/file/scripts/counter.lua");
    hands.rest(2);
    EXPECT_EQ(valueOf("Scripts/file/scripts/counter.lua"), "shown");
    EXPECT_TRUE(shown("Scripts/line/3"));
}

TEST_F(ScriptsPanel, aRightClickSetsAConditionAndTheProjectKeepsIt) {
    use(kCounter);
    bringIntoSight(15);
    hands.clickAt(hands.middleOf("Scripts/line/15"), MouseButton::Right);
    hands.rest(3);
    hands.type("far == 8");
    hands.key(Key::Enter);
    hands.rest(3);
    EXPECT_EQ(valueOf("Scripts/line/15"), "condition");
    EXPECT_NE(fileText(".plumb/breakpoints.json").find("far == 8"), std::string::npos);
    Workspace again{workspace.document.types(), workspace.assets, {workspace.project.root}};
    EXPECT_EQ(again.debugger.breakpoints.all(), workspace.debugger.breakpoints.all());
    press("F5");
    hands.rest(20);
    ASSERT_EQ(line(), 15);
    EXPECT_EQ(workspace.debugger.halt()->moment.tick, 4);
    EXPECT_EQ(valueOf("Scripts/variable/far"), "8");
    EXPECT_EQ(valueOf("Scripts/property/far"), "6") << "not assigned yet";
}

TEST_F(ScriptsPanel, aButtonRunsBackToTheLastChangeOfAProperty) {
    use(kCounter);
    press("F5");
    hands.rest(60);
    press("F6");
    press("F11");
    ASSERT_NE(line(), 0);
    hands.click("Scripts/property/hits/back");
    hands.rest(2);
    EXPECT_EQ(line(), 13);
    EXPECT_EQ(workspace.debugger.halt()->moment.tick % 3, 0);
    EXPECT_NE(workspace.notice.find("changes hits"), std::string::npos) << workspace.notice;
}

TEST_F(ScriptsPanel, theMenuOfAFieldInTheInspectorRunsBackToItsLastChange) {
    use("local Counter = script {}\n"
        "function Counter:onTick()\n"
        "    if world:tick() == 7 then\n"
        "        self.transform.x = 30\n"
        "    end\n"
        "end\n"
        "return Counter\n");
    select({"first"});
    press("F5");
    hands.rest(30);
    press("F6");
    hands.clickAt(hands.middleOf("Inspector/Transform/position/label"), MouseButton::Right);
    hands.rest(2);
    hands.click("Inspector/Transform/position/lastChange");
    hands.rest(3);
    EXPECT_EQ(line(), 4);
    EXPECT_EQ(workspace.debugger.halt()->moment.tick, 7);
    EXPECT_EQ(valueOf("Inspector/Transform/position.x"), "0") << "about to change";
    press("F10");
    EXPECT_EQ(valueOf("Inspector/Transform/position.x"), "30");
}

TEST_F(ScriptsPanel, anErrorInTheConsoleLeadsToItsLineAndToTheTickBefore) {
    use("local Counter = script {}\n"
        "function Counter:onTick()\n"
        "    local n = world:tick()\n"
        "    if n == 20 then error('twenty') end\n"
        "end\n"
        "return Counter\n");
    press("F5");
    hands.rest(40);
    workspace.settings.layout.show("Console");
    hands.rest(3);
    ASSERT_TRUE(shown("Console/0/goBack"));
    hands.clickAt(window.widgets().find("Console/0")->box.min + Vec2{200.0f, 5.0f});
    hands.rest(3);
    EXPECT_EQ(valueOf("Tab/Scripts"), "front");
    EXPECT_FALSE(workspace.play.paused()) << "only the line is shown";
    workspace.settings.layout.show("Console");
    hands.rest(3);
    hands.click("Console/0/goBack");
    hands.rest(3);
    EXPECT_EQ(workspace.play.ticks(), 19);
    EXPECT_EQ(valueOf("Tab/Scripts"), "front");
    for (int i = 0; i < 3; ++i) press("F11");
    EXPECT_EQ(line(), 4);
    EXPECT_EQ(valueOf("Scripts/variable/n"), "20");
    press("F5");
    press("F5");
    workspace.settings.layout.show("Console");
    hands.rest(3);
    EXPECT_FALSE(shown("Console/0/goBack")) << "the error of another game";
}

}  // namespace
}  // namespace plumb::editor::ui
