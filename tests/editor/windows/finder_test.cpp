#include "editor/model/finder/finder.hpp"

#include <imgui.h>

#include "editor/model/actions.hpp"
#include "editor/model/finder/fuzzy.hpp"
#include "editor/model/prefabs/prefab_visit.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor {
namespace {

int score(std::string_view typed, std::string_view text, std::size_t name = 0) {
    const auto match = fuzzyMatch(typed, text, name);
    return match ? match->score : -1;
}
std::vector<std::uint32_t> places(std::string_view typed, std::string_view text) {
    const auto match = fuzzyMatch(typed, text);
    return match ? match->at : std::vector<std::uint32_t>{};
}
using Places = std::vector<std::uint32_t>;

TEST(Fuzzy, lettersAreMatchedInOrderInAnyCase) {
    EXPECT_EQ(places("crt", "crate"), (Places{0, 1, 3}));
    EXPECT_EQ(places("CRATE", "crate"), (Places{0, 1, 2, 3, 4}));
    EXPECT_FALSE(fuzzyMatch("tc", "crate"));
    EXPECT_FALSE(fuzzyMatch("crates", "crate"));
    EXPECT_FALSE(fuzzyMatch("x", ""));
}

TEST(Fuzzy, anEmptyQueryMatchesEverything) {
    ASSERT_TRUE(fuzzyMatch("", "crate"));
    EXPECT_EQ(fuzzyMatch("", "crate")->score, fuzzyMatch("", "")->score);
    EXPECT_TRUE(places("", "crate").empty());
}

TEST(Fuzzy, theBestPositionsAreMatchedNotTheFirstOnes) {
    EXPECT_EQ(places("ocr", "One cell right"), (Places{0, 4, 9}));
    EXPECT_EQ(places("re", "Entity: Redo"), (Places{8, 9}));
    EXPECT_EQ(places("l1", "hall/level1"), (Places{5, 10}));
    EXPECT_EQ(places("pS", "apsPlayerStart"), (Places{3, 9}));
}

TEST(Fuzzy, wordBeginningsAndRunsScoreHigher) {
    EXPECT_GT(score("un", "Undo"), score("un", "Run")) << "the beginning";
    EXPECT_GT(score("cell", "One cell right"), score("cell", "Cut everything, let lie")) << "a run";
    EXPECT_GT(score("fs", "Frame selection"), score("fs", "offset")) << "beginnings of words";
    EXPECT_GT(score("ab", "xaxb"), score("ab", "xaxxxxb")) << "closer together";
    EXPECT_GT(score("Menu", "Menu"), score("Menu", "menu")) << "the same case";
    EXPECT_GT(score("cave", "scenes/cave.json", 7), score("cave", "cave/scenes.json", 5)) << "in the name";
}

TEST(Fuzzy, wordsMayComeInAnyOrder) {
    EXPECT_EQ(places("right one", "One cell right"), (Places{0, 1, 2, 9, 10, 11, 12, 13}));
    EXPECT_FALSE(fuzzyMatch("one left", "One cell right"));
}

class FinderTest : public EditorFixture {
protected:
    FinderTest() {
        putFile("scenes/cave.scene.json", kSceneText);
        putFile("assets/crate.png", "");
        putFile("assets/notes.txt", "");
        putFile("prefabs/lantern.prefab.json", "{}");
    }
    std::vector<std::string> found(Finder::What what, std::string typed) {
        finder.open(workspace, what);
        finder.search(workspace, std::move(typed));
        std::vector<std::string> texts;
        for (const FinderRow& row : finder.rows()) texts.push_back(finder.item(row).text);
        return texts;
    }
    std::string best(Finder::What what, std::string typed) {
        const auto texts = found(what, std::move(typed));
        return texts.empty() ? "" : texts.front();
    }

    Finder finder;
};

TEST_F(FinderTest, filesAndEntitiesOfTheOpenSceneAreFound) {
    EXPECT_EQ(found(Finder::What::Files, ""),
              (std::vector<std::string>{"scenes/cave.scene.json", "scenes/level.scene.json",
                                        "prefabs/lantern.prefab.json", "camera", "crate", "ground", "lamp",
                                        "player", "sign", "assets/crate.png"}));
    EXPECT_EQ(best(Finder::What::Files, "crate"), "crate");
    EXPECT_EQ(best(Finder::What::Files, "crpng"), "assets/crate.png");
    EXPECT_EQ(best(Finder::What::Files, "cave"), "scenes/cave.scene.json");
    EXPECT_EQ(best(Finder::What::Files, "lmp"), "lamp");
    EXPECT_EQ(finder.item(finder.rows().front()).detail, "in player");
    EXPECT_TRUE(found(Finder::What::Files, "qqq").empty());
}

TEST_F(FinderTest, recentChoicesComeFirstInTheNextSessionToo) {
    finder.open(workspace, Finder::What::Files);
    finder.search(workspace, "sign");
    finder.choose(workspace);
    Finder next;
    next.open(workspace, Finder::What::Files);
    ASSERT_FALSE(next.rows().empty());
    EXPECT_EQ(next.item(next.rows().front()).text, "sign");
}

TEST_F(FinderTest, commandsAreListedWithTheirMenuOrKind) {
    EXPECT_EQ(best(Finder::What::Commands, "save layout"), "Layout: Save layout as...");
    EXPECT_EQ(best(Finder::What::Commands, "flip left"), "Tiles: Flip left to right");
}

TEST_F(FinderTest, aPrefabThatIsChosenIsOpened) {
    putFile("prefabs/box.prefab.json",
            R"({"format": 1, "entities": [{"id": "0000000000000001", "components": {"Transform": {}}}]})");
    finder.open(workspace, Finder::What::Files);
    finder.search(workspace, "box.prefab");
    finder.choose(workspace);
    const auto visit = takePrefabVisit(workspace);
    ASSERT_TRUE(visit);
    EXPECT_EQ(visit->path, "prefabs/box.prefab.json");
}

TEST_F(FinderTest, aPrefixSelectsTheKindOfSearch) {
    EXPECT_EQ(found(Finder::What::Files, "@crt"), std::vector<std::string>{"crate"});
    EXPECT_EQ(best(Finder::What::Files, ">undo"), "Edit: Undo");
    EXPECT_EQ(best(Finder::What::Files, "crate"), "crate") << "and back";
}

TEST_F(FinderTest, everyActionIsACommandWithItsKeysAndDisabledIfItCannotRun) {
    std::size_t actions = 0;
    for (const Action& action : actionTable()) actions += action.id.empty() ? 0 : 1;
    finder.open(workspace, Finder::What::Commands);
    EXPECT_EQ(finder.found(), actions);
    finder.search(workspace, "undo");
    EXPECT_EQ(finder.item(finder.rows().front()).detail, "Ctrl+Z");
    EXPECT_FALSE(finder.item(finder.rows().front()).possible) << "there is nothing to undo";
    finder.choose(workspace);
    EXPECT_EQ(workspace.notice, "\"Undo\" is not available now");
    EXPECT_EQ(best(Finder::What::Commands, "frame all"), "View: Frame all");
}

TEST_F(FinderTest, whatWasChosenLatelyComesFirst) {
    finder.open(workspace, Finder::What::Files);
    finder.search(workspace, "sign");
    EXPECT_TRUE(finder.choose(workspace).empty());
    EXPECT_EQ(workspace.document.selection.all(), std::vector{named("sign")});
    finder.search(workspace, "cave");
    EXPECT_EQ(finder.choose(workspace), "scenes/cave.scene.json") << "the window asks before it opens";
    const auto texts = found(Finder::What::Files, "");
    EXPECT_EQ(texts[0], "scenes/cave.scene.json");
    EXPECT_EQ(texts[1], "sign");
    EXPECT_EQ(texts[2], "scenes/level.scene.json");
    EXPECT_EQ(best(Finder::What::Files, "level"), "scenes/level.scene.json") << "but what fits comes before";
}

TEST_F(FinderTest, theSelectedRowWrapsAround) {
    finder.open(workspace, Finder::What::Files);
    finder.step(-1);
    EXPECT_EQ(finder.chosen, finder.rows().size() - 1);
    finder.step(1);
    EXPECT_EQ(finder.chosen, 0u);
    finder.search(workspace, "qqq");
    finder.step(1);
    EXPECT_TRUE(finder.choose(workspace).empty());
}

class FinderWindowTest : public FinderTest {
protected:
    FinderWindowTest()
        : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {}
    void ask(bool commands) {
        hands.key(Key::P, {.shift = commands, .control = true});
        hands.rest(2);
    }
    [[nodiscard]] bool open() const { return window.widgets().find("Finder/typed") != nullptr; }

    LogBook log;
    ui::EditorWindow window;
    ui::Hands hands;
};

TEST_F(FinderWindowTest, typingFindsAnEntityAndEnterSelectsIt) {
    ask(false);
    hands.type("@lmp");
    hands.rest();
    EXPECT_NE(window.widgets().find("Finder/lamp"), nullptr);
    EXPECT_EQ(window.widgets().find("Finder/crate"), nullptr);
    hands.key(Key::Enter);
    EXPECT_FALSE(open());
    EXPECT_EQ(workspace.document.selection.all(), std::vector{named("lamp")});
    EXPECT_EQ(workspace.undo.size(), 0u);
}

TEST_F(FinderWindowTest, rowsAreSelectedByArrowsAndByTheMouse) {
    ask(true);
    hands.type("frame");
    hands.rest();
    const std::string second{window.widgets().find("Finder/1")->value};
    hands.key(Key::Down);
    hands.key(Key::Up);
    hands.key(Key::Down);
    hands.key(Key::Enter);
    EXPECT_FALSE(open());
    ask(true);
    EXPECT_EQ(window.widgets().find("Finder/0")->value, second) << "the last one comes first";
    hands.type("snap");
    hands.rest();
    const bool before = workspace.grid.snap;
    hands.click("Finder/Snap");
    EXPECT_NE(workspace.grid.snap, before);
    EXPECT_FALSE(open());
}

TEST_F(FinderWindowTest, escapeClosesItWithoutEffect) {
    workspace.document.selection.set({named("crate")});
    ask(false);
    hands.type("lamp");
    hands.key(Key::Escape);
    hands.rest();
    EXPECT_FALSE(open());
    EXPECT_EQ(workspace.document.selection.all(), std::vector{named("crate")});
    ask(false);
    EXPECT_EQ(window.widgets().find("Finder/typed")->value, "");
}

TEST_F(FinderWindowTest, openingASceneAsksForUnsavedChangesFirst) {
    workspace.document.selection.set({named("crate")});
    hands.key(Key::Delete);
    ASSERT_TRUE(workspace.unsaved());
    ask(false);
    hands.type("cave");
    hands.key(Key::Enter);
    hands.rest(2);
    EXPECT_EQ(workspace.document.scenePath, kScene);
    hands.click("Unsaved/Discard");
    EXPECT_EQ(workspace.document.scenePath, "scenes/cave.scene.json");
}

TEST_F(FinderWindowTest, aFileIsShownInTheAssetBrowser) {
    ask(false);
    hands.type("lantern");
    hands.key(Key::Enter);
    hands.rest(2);
    EXPECT_NE(window.widgets().find("Assets/prefabs/lantern.prefab.json"), nullptr);
}

TEST_F(FinderWindowTest, itsKeysAreIgnoredInTextFields) {
    hands.click("Scene/filter");
    ask(false);
    EXPECT_FALSE(open());
}

}  // namespace
}  // namespace plumb::editor
