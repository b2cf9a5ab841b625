#include "editor/model/project/settings.hpp"

#include <gtest/gtest.h>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb::editor {
namespace {

Settings someSettings() {
    Settings settings;
    settings.theme = Theme::Light;
    settings.scale = 1.25f;
    settings.textSize = 16.0f;
    settings.rightErases = true;
    settings.textEditor = "code -g {file}:{line}";
    settings.remember("/games/first");
    settings.remember("/games/second");
    settings.layout.resize(Edge::Left, 0.3f);
    settings.keepLayout("Mine");
    settings.keys.bind(*findAction("edit.undo"), {Key::U, true});
    settings.keys.unbind(*findAction("view.all"));
    return settings;
}

TEST(SettingsTest, allSettingsAreReadBackAsWritten) {
    const Settings settings = someSettings();
    std::vector<Error> problems;
    const Result<Settings> read = Settings::fromText(settings.toText(), problems);
    ASSERT_TRUE(read);
    EXPECT_TRUE(problems.empty()) << problems.front().text();
    EXPECT_EQ(*read, settings);
}

TEST(SettingsTest, keysOfActionsThatDoNotExistAreReportedAndIgnored) {
    for (const char* id : {"", "edit.gone"}) {
        std::vector<Error> problems;
        const std::string text = std::string{R"({"format": 1, "keys": {")"} + id + R"(": ["Ctrl+K"]}})";
        const auto read = Settings::fromText(text, problems);
        ASSERT_TRUE(read);
        ASSERT_EQ(problems.size(), 1u) << id;
        EXPECT_EQ(problems[0].what, "unknown action");
        EXPECT_FALSE(read->keys.anyChanged());
    }
}

TEST(SettingsTest, theFileIsWrittenOnceShortlyAfterAChangeAndReadAtTheNextStart) {
    const test::TemporaryFolder folder;
    SettingsFile file{folder.path};
    Settings settings;
    EXPECT_TRUE(file.load(settings).empty());
    file.update(settings, 2.0);
    EXPECT_FALSE(std::filesystem::exists(file.path())) << "nothing was chosen yet";
    settings = someSettings();
    file.update(settings, 0.5);
    EXPECT_FALSE(std::filesystem::exists(file.path()));
    file.update(settings, 0.6);
    ASSERT_TRUE(std::filesystem::exists(file.path()));

    Settings next;
    EXPECT_TRUE(SettingsFile{folder.path}.load(next).empty());
    EXPECT_EQ(next, settings);
}

TEST(SettingsTest, aDamagedFileIsKeptReportedAndReplacedByDefaults) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeFile(folder.path / "settings.json", "{\"theme\": \"li").ok());
    Settings settings;
    const std::vector<Error> problems = SettingsFile{folder.path}.load(settings);
    ASSERT_FALSE(problems.empty());
    EXPECT_NE(problems.back().text().find("settings.json.damaged"), std::string::npos)
        << problems.back().text();
    EXPECT_EQ(settings, Settings{});
    EXPECT_EQ(*readFile(folder.path / "settings.json.damaged"), "{\"theme\": \"li");
    EXPECT_FALSE(std::filesystem::exists(folder.path / "settings.json"));
}

TEST(SettingsTest, invalidSettingsAreReportedByNameAndTheOthersAreRead) {
    std::vector<Error> problems;
    const Result<Settings> read = Settings::fromText(
        R"({"theme": "pink", "scale": 40, "textSize": 16, "layout": 5, "keys": {"edit.undo": ["Ctrl+Nothing"],
            "no.such": ["A"], "edit.redo": ["Ctrl+R"]}})",
        problems);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->theme, Theme::Dark);
    EXPECT_EQ(read->scale, 1.0f);
    EXPECT_EQ(read->textSize, 16.0f);
    std::string all;
    for (const Error& problem : problems) all += problem.text() + "\n";
    for (const char* name : {"theme", "scale", "layout", "keys.edit.undo", "keys.no.such"})
        EXPECT_NE(all.find(name), std::string::npos) << name << " is not in\n" << all;
    EXPECT_EQ(read->keys.shownOf(*findAction("edit.undo")).text(), "Ctrl+Z");
    EXPECT_EQ(read->keys.shownOf(*findAction("edit.redo")).text(), "Ctrl+R");
}

TEST(SettingsTest, theLastProjectIsTheFirstOfTheRecentOnes) {
    Settings settings;
    for (int i = 0; i < 20; ++i) settings.remember(format("/games/{}", i));
    settings.remember("/games/15");
    EXPECT_EQ(settings.recent.size(), Settings::kMaxRecent);
    EXPECT_EQ(settings.recent.front(), "/games/15");
    EXPECT_EQ(settings.recent[1], "/games/19");
}

TEST(Keys, textIsReadBackForEveryShortcutOfTheTable) {
    for (const Action& action : actionTable()) {
        for (const Shortcut& keys : {action.shortcut, action.alternative}) {
            if (keys.key == Key::None) continue;
            const auto read = shortcutFromText(keys.text());
            ASSERT_TRUE(read) << keys.text();
            EXPECT_EQ(*read, keys);
        }
    }
    for (const char* none : {"", "Ctrl", "Ctrl+", "Foo+A", "+", "Ctrl+None"})
        EXPECT_FALSE(shortcutFromText(none)) << none;
}

TEST(Keys, bindingAUsedKeyRemovesItFromTheOtherAction) {
    KeyBindings keys;
    const Action& undo = *findAction("edit.undo");
    const Action& duplicate = *findAction("edit.duplicate");
    const Shortcut d{Key::D, true};
    ASSERT_EQ(keys.conflict(undo, d), &duplicate);
    keys.bind(undo, d);
    EXPECT_EQ(keys.shownOf(undo), d);
    EXPECT_TRUE(keys.of(duplicate).empty());
    EXPECT_EQ(keys.labelOf(duplicate), "Duplicate");
    EXPECT_EQ(keys.labelOf(undo), "Undo  (Ctrl+D)");
    EXPECT_TRUE(keys.isChanged(duplicate));
    keys.reset(duplicate);
    keys.reset(undo);
    EXPECT_FALSE(keys.anyChanged());
}

TEST(Keys, bindingAnAlternativeKeyRemovesItFromTheOtherAction) {
    KeyBindings keys;
    const Action& redo = *findAction("edit.redo");
    keys.bind(*findAction("edit.undo"), {Key::Z, true, true});
    EXPECT_EQ(keys.of(redo), (std::vector<Shortcut>{{Key::Y, true}}));
}

TEST(Keys, aKeyMayHaveAnotherActionForTiles) {
    KeyBindings keys;
    EXPECT_EQ(keys.conflict(*findAction("tool.erase"), {Key::E}), nullptr) << "it rotates entities";
}

}  // namespace
}  // namespace plumb::editor
