#include <imgui.h>

#include "editor/model/debug/text_editor.hpp"
#include "editor/model/view/log_view.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor {
namespace {

class LogViews : public testing::Test {
protected:
    LogViews() : before{setLogSink([](const LogLine&) {})} {}
    ~LogViews() override { setLogSink(before); }
    std::vector<std::string> shown() {
        view.update(book);
        std::vector<std::string> texts;
        for (const LogView::Row& row : view.rows()) texts.push_back(book.lines()[row.line].text);
        return texts;
    }
    using Texts = std::vector<std::string>;

    LogSink before;
    LogBook book;
    LogView view;
};

TEST_F(LogViews, linesAreFilteredByLevelChannelAndWords) {
    logNote("Assets", "Loaded: crate.png");
    logWarning("Physics", "the crate is too small");
    logError("Scene", {"cave", "no such file", ""});
    EXPECT_EQ(shown().size(), 3u);
    EXPECT_EQ(view.count(LogLevel::Note), 1u);
    EXPECT_EQ(view.count(LogLevel::Warning), 1u);
    EXPECT_EQ(view.count(LogLevel::Error), 1u);

    view.search = "CRATE";
    EXPECT_EQ(shown(), (Texts{"Loaded: crate.png", "the crate is too small"}));
    view.search = "crate physics";
    EXPECT_EQ(shown(), Texts{"the crate is too small"}) << "the channel counts too";
    view.search.clear();
    view.hiddenChannels.insert("Assets");
    view.levels[static_cast<std::size_t>(LogLevel::Error)] = false;
    EXPECT_EQ(shown(), Texts{"the crate is too small"});
    EXPECT_EQ(view.count(LogLevel::Error), 1u) << "counted all the same";
    EXPECT_EQ(view.channels().size(), 3u);
}

TEST_F(LogViews, equalLinesAreMergedAtTheirLastPosition) {
    logNote("A", "again");
    logNote("A", "other");
    logNote("A", "again");
    logNote("B", "again");
    EXPECT_EQ(shown(), (Texts{"other", "again", "again"}));
    EXPECT_EQ(view.rows()[1].times, 2u);
    EXPECT_EQ(view.rows()[2].times, 1u) << "another channel";
    EXPECT_NE(view.text(book).find("again  (2 times)"), std::string::npos);
    view.once = false;
    EXPECT_EQ(shown(), (Texts{"again", "other", "again", "again"}));
    EXPECT_EQ(view.rows()[0].times, 1u);
}

TEST_F(LogViews, linesStoreTheirTickAndClearRemovesAll) {
    logNote("A", "before");
    book.tick = [] { return std::int64_t{41}; };
    logNote("A", "playing");
    EXPECT_EQ(book.lines()[0].tick, -1);
    EXPECT_EQ(book.lines()[1].tick, 41);
    EXPECT_NE(textOf(book.lines()[1]).find("tick 41  A  Note: playing"), std::string::npos);
    EXPECT_EQ(shown().size(), 2u);
    book.clear();
    EXPECT_TRUE(shown().empty());
    EXPECT_EQ(view.count(LogLevel::Note), 0u);
}

class ConsoleTest : public EditorFixture {
protected:
    ConsoleTest() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        hands.click("Tab/Console");
    }
    [[nodiscard]] std::string valueOf(std::string_view widget) const {
        const auto* found = window.widgets().find(widget);
        return found == nullptr ? "(none)" : found->value;
    }

    LogBook log;
    ui::EditorWindow window;
    ui::Hands hands;
};

TEST_F(ConsoleTest, aLineReferencesAnEntityByIdOrByFilePosition) {
    const Document& document = workspace.document;
    EXPECT_EQ(entityIn(document, "crate @0000000000000004: too small"), named("crate"));
    EXPECT_EQ(entityIn(document, "mail me@home, or @0000000000000003"), named("lamp"));
    EXPECT_FALSE(entityIn(document, "@0000000000000099: gone"));
    EXPECT_FALSE(entityIn(document, "@00000004"));
    EXPECT_EQ(entityIn(document, "scenes/level.scene.json: entities[1].RigidBody: odd"), named("player"));
    EXPECT_FALSE(entityIn(document, "scenes/cave.scene.json: entities[1]: odd"));
    EXPECT_FALSE(entityIn(document, "scenes/level.scene.json: entities[99]: odd"));
}

TEST_F(ConsoleTest, theEngineLogsEntitiesThatWay) {
    const EntityId crate = workspace.document.find(named("crate"));
    workspace.document.world.add<RigidBody>(crate).mass = -1.0f;
    workspace.physics.on = true;
    log.clear();
    hands.rest(2);
    workspace.document.sceneRevision++;
    hands.rest(2);
    ASSERT_FALSE(log.lines().empty()) << "a negative mass is refused";
    EXPECT_EQ(entityIn(workspace.document, log.lines().back().text), named("crate"))
        << log.lines().back().text;
}

TEST_F(ConsoleTest, aClickSelectsTheEntityOfTheLine) {
    log.clear();
    logWarning("Game", "lamp @0000000000000003 is out of oil");
    hands.rest(2);
    const Vec2 center = workspace.view.view().center;
    hands.click("Console/0");
    EXPECT_EQ(workspace.document.selection.all(), std::vector{named("lamp")});
    EXPECT_FALSE(workspace.view.view().center == center);
}

#if !defined(_WIN32)
TEST_F(ConsoleTest, aClickOnTheFileAndLineOfAnErrorOpensTheTextEditor) {
    putFile("editor", "#!/bin/sh\nprintf '%s\\n' \"$@\" > \"$0.part\"\nmv \"$0.part\" \"$0.words\"\n");
    const Path root = workspace.project.root;
    std::filesystem::permissions(root / "editor", std::filesystem::perms::owner_all);
    workspace.settings.textEditor = format("\"{}\" --at {file}:{line} {line}", (root / "editor").string());
    putFile("code/hero.cpp", "");
    putFile("scripts/slime.lua", "");
    const auto expectOpened = [&](const char* file, int line) {
        for (int i = 0; i < 100000 && !std::filesystem::exists(root / "editor.words"); ++i) hands.rest();
        const std::string path = std::filesystem::absolute(root / file).string();
        EXPECT_EQ(fileText("editor.words"), format("--at\n{}:{}\n{}\n", path, line, line));
        std::filesystem::remove(root / "editor.words");
    };
    log.clear();
    logError("Code", Error{"code/hero.cpp:12:5", "error: expected ';'", ""});
    logError("Script", Error{"scripts/slime.lua:3", "attempt to call a nil value", ""});
    hands.rest(2);
    hands.click("Console/0");
    expectOpened("code/hero.cpp", 12);
    EXPECT_EQ(valueOf("Console/1/source"), "slime.lua:3");
    hands.click("Console/1/source");
    expectOpened("scripts/slime.lua", 3);
    workspace.settings.textEditor = "/no/such/editor";
    hands.click("Console/0");
    EXPECT_NE(workspace.notice.find("/no/such/editor"), std::string::npos) << workspace.notice;
    EXPECT_NE(workspace.notice.find("Preferences"), std::string::npos) << "where it is set";
}
#endif

TEST(TextEditors, aCommandIsSplitIntoWordsBeforeTheFileIsFilledIn) {
    using Words = std::vector<std::string>;
    EXPECT_EQ(wordsOf("code -g {file}:{line}", "/a b/c.lua", 7), (Words{"code", "-g", "/a b/c.lua:7"}));
    EXPECT_EQ(wordsOf("  \"my editor\"  +{line} \"\" ", "x", 7), (Words{"my editor", "+7", "", "x"}));
    EXPECT_EQ(wordsOf("", "x", 7), Words{});
    EXPECT_EQ(wordsOf("vi {file}", "{line}", 7), (Words{"vi", "{line}"})) << "a name is not a command";
}

TEST(TextEditors, thePlaceOfAMessageIsFound) {
    using Place = ScriptPlace;
    EXPECT_EQ(sourcePlaceIn("code/a.cpp:12:5: error: no"), (Place{"code/a.cpp", 12}));
    EXPECT_EQ(sourcePlaceIn("In file included from /x/b.hpp:3,"), (Place{"/x/b.hpp", 3}));
    EXPECT_EQ(sourcePlaceIn("slime @1: scripts/slime.lua:4: no"), (Place{"scripts/slime.lua", 4}));
    EXPECT_FALSE(sourcePlaceIn("a.cpp: no line"));
    EXPECT_FALSE(sourcePlaceIn("a.cpp:0: no line"));
    EXPECT_FALSE(sourcePlaceIn("12:30 o'clock"));
}

TEST_F(ConsoleTest, buttonsHideLevelsAndChannelsAndSearchFinds) {
    log.clear();
    logNote("Assets", "loaded");
    logWarning("Physics", "careful");
    hands.rest(2);
    EXPECT_EQ(valueOf("Console/warnings"), "1 warning");
    EXPECT_EQ(valueOf("Console/last"), "careful");
    hands.click("Console/warnings");
    EXPECT_EQ(valueOf("Console/last"), "loaded");
    hands.click("Console/warnings");
    hands.click("Console/channels");
    hands.rest(2);
    hands.click("Console/channel/Physics");
    EXPECT_EQ(valueOf("Console/last"), "loaded");
    hands.click("Console/channel/Physics");
    hands.key(Key::Escape);
    hands.click("Console/search");
    hands.type("care");
    hands.rest();
    EXPECT_EQ(valueOf("Console/0"), "careful x1");
    EXPECT_EQ(valueOf("Console/1"), "(none)");
}

TEST_F(ConsoleTest, theVisibleLinesAreCopiedAndAllAreCleared) {
    log.clear();
    logNote("Game", "twice");
    logNote("Game", "twice");
    hands.rest(2);
    EXPECT_EQ(valueOf("Console/0"), "twice x2");
    hands.click("Console/once");
    EXPECT_EQ(valueOf("Console/1"), "twice x1");
    hands.click("Console/once");
    hands.click("Console/copy");
    EXPECT_NE(workspace.clipboard.find("Game  Note: twice  (2 times)"), std::string::npos);
    hands.click("Console/clear");
    EXPECT_TRUE(log.lines().empty());
}

TEST_F(ConsoleTest, theStatusBarCountsErrorsAndOpensTheConsole) {
    log.clear();
    hands.rest(2);
    EXPECT_EQ(valueOf("Status/log"), "(none)");
    hands.click("Tab/History");
    logWarning("Game", "one");
    logError("Game", {"here", "two", ""});
    logError("Game", {"here", "three", ""});
    hands.rest(2);
    EXPECT_EQ(valueOf("Status/log"), "2 errors, 1 warning");
    EXPECT_EQ(valueOf("Console/last"), "(none)");
    hands.click("Status/log");
    hands.rest(2);
    EXPECT_NE(valueOf("Console/last"), "(none)");
}

TEST_F(ConsoleTest, allButtonsAreVisibleInANarrowPane) {
    logNote("Game", "a line");
    for (const float part : {0.5f, 0.3f, 0.16f}) {
        workspace.settings.layout.move("Console", Dock::Right);
        workspace.settings.layout.resize(Edge::Right, part);
        hands.rest(3);
        const float left = window.widgets().find("Viewport")->box.max.x;
        for (const char* button : {"errors", "warnings", "notes", "channels", "channels/list", "search",
                                   "once", "follow", "copy", "clear"}) {
            const auto* widget = window.widgets().find(std::string{"Console/"} + button);
            ASSERT_NE(widget, nullptr) << button;
            EXPECT_GE(widget->box.min.x, left) << button << " at " << part;
            EXPECT_LE(widget->box.max.x, 1280.0f) << button << " at " << part;
        }
    }
    hands.click("Console/clear");
    hands.rest(2);
    EXPECT_TRUE(log.lines().empty());
}

}  // namespace
}  // namespace plumb::editor
