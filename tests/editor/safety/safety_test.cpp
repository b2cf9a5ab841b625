#include "editor/model/actions.hpp"
#include "editor/model/safety/safety_net.hpp"
#include "editor/model/safety/scene_differences.hpp"
#include "scene/drawing/physics_drawing.hpp"
#include "scene/physics/physics_state.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {
namespace {

/// Tests of journals, backups and conflicts with other programs.
class Safety : public EditorFixture {
protected:
    Safety() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {}

    void createOne() { ASSERT_TRUE(runAction(workspace, "entity.create")); }
    [[nodiscard]] Path root() const { return workspace.project.root; }
    /// Writes a journal like one that a crashed editor leaves.
    void leaveJournal(std::string_view text) {
        putFile(".plumb/session1/scenes+level.scene.json.journal",
                "{\"journal\":1,\"scene\":\"scenes/level.scene.json\"}\n" + std::string{text});
    }
    [[nodiscard]] std::vector<std::string> journals() const {
        return filesBelow(root() / ".plumb", ".journal");
    }
    [[nodiscard]] bool shows(std::string_view path) const { return window.widgets().find(path) != nullptr; }
    [[nodiscard]] std::string changedText() const {
        std::string text{kSceneText};
        return text.replace(text.find("[200, 64]"), 9, "[201, 64]");
    }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

TEST_F(Safety, theJournalStoresUnsavedWorkAndIsRemovedBySaving) {
    workspace.safety.begin();
    createOne();
    workspace.safety.update(0.1);
    workspace.safety.update(1.0);
    workspace.safety.finish();
    ASSERT_EQ(journals().size(), 1u);
    const std::string journal = fileText(".plumb/" + journals()[0]);
    EXPECT_EQ(journal.substr(journal.find('\n') + 1), workspace.text());
    EXPECT_EQ(fileText(), kSceneText) << "the user's file is not touched";
    ASSERT_TRUE(workspace.save().ok());
    EXPECT_TRUE(journals().empty());
}

TEST_F(Safety, writingTheJournalDoesNotMoveBodies) {
    workspace.safety.begin();
    previewPhysics(workspace.document.world);
    const auto bodies = [&] {
        const auto* state = workspace.document.world.findResource<PhysicsState>();
        return state == nullptr ? 0u : state->world.bodies.info.size();
    };
    const auto before = bodies();
    ASSERT_GT(before, 0u);
    createOne();
    workspace.safety.update(2.0);
    workspace.safety.finish();
    ASSERT_EQ(journals().size(), 1u);
    EXPECT_EQ(bodies(), before);
}

TEST_F(Safety, theJournalIsWrittenAfterOneSecondOrAFewActions) {
    workspace.safety.begin();
    createOne();
    workspace.safety.update(0.0);
    workspace.safety.finish();
    const std::string first = fileText(".plumb/" + journals().at(0));
    for (std::size_t i = 0; i + 1 < Journal::kActions; ++i) {
        createOne();
        workspace.safety.update(0.01);
    }
    workspace.safety.finish();
    EXPECT_EQ(fileText(".plumb/" + journals()[0]), first) << "not for every action";
    createOne();
    workspace.safety.update(0.01);
    workspace.safety.finish();
    EXPECT_NE(fileText(".plumb/" + journals()[0]), first);
}

TEST_F(Safety, undoingToTheSavedStateRemovesTheJournal) {
    workspace.safety.begin();
    createOne();
    workspace.safety.update(2.0);
    workspace.undo.undo();
    workspace.safety.update(0.1);
    EXPECT_TRUE(journals().empty());
}

TEST_F(Safety, afterACrashItIsOfferedOnceAndOpenedUnsaved) {
    leaveJournal(changedText());
    workspace.safety.begin();
    hands.rest(3);
    EXPECT_EQ(window.widgets().find("Recovery/0")->value, kScene);
    hands.click("Recovery/0/recover");
    hands.rest(3);
    EXPECT_FALSE(shows("Recovery/later"));
    EXPECT_EQ(workspace.text(), changedText());
    EXPECT_TRUE(workspace.unsaved());
    EXPECT_EQ(fileText(), kSceneText);
    ASSERT_TRUE(workspace.save().ok());
    EXPECT_EQ(fileText(), changedText());
    EXPECT_TRUE(journals().empty());
}

TEST_F(Safety, discardedWorkIsAmongTheBackups) {
    leaveJournal(changedText());
    workspace.safety.begin();
    hands.rest(3);
    hands.click("Recovery/0/discard");
    hands.rest(3);
    EXPECT_FALSE(shows("Recovery/later"));
    EXPECT_EQ(workspace.text(), kSceneText);
    EXPECT_TRUE(journals().empty());
    const std::vector<Backup> backups = workspace.safety.backups.of(kScene);
    ASSERT_EQ(backups.size(), 1u);
    EXPECT_EQ(*readFile(backups[0].path), changedText());
}

TEST_F(Safety, laterAsksAgainTheNextTime) {
    leaveJournal(changedText());
    workspace.safety.begin();
    hands.rest(3);
    hands.key(Key::Escape);
    hands.rest(3);
    EXPECT_FALSE(shows("Recovery/later"));
    createOne();
    workspace.safety.update(2.0), workspace.safety.finish();
    EXPECT_EQ(journals().size(), 2u) << "the new one does not replace what was lost";
    Workspace next{workspace.document.types(), workspace.assets, {root()}};
    next.safety.begin();
    EXPECT_EQ(next.safety.lost().size(), 1u) << "the other editor is open and has its own";
}

TEST_F(Safety, aJournalEqualToTheFileOrEmptyIsNotOffered) {
    leaveJournal(kSceneText);
    putFile(".plumb/session2/broken.journal", "no journal");
    putFile(".plumb/session3/outside.journal", "{\"journal\":1,\"scene\":\"../../etc/passwd\"}\nx");
    workspace.safety.begin();
    EXPECT_TRUE(workspace.safety.lost().empty());
}

TEST_F(Safety, eachSaveKeepsTheFileBeforeItAndTheLastTenOfThem) {
    std::vector<std::string> texts{fileText()};
    for (int i = 0; i < 13; ++i) {
        createOne();
        ASSERT_TRUE(workspace.save().ok());
        texts.push_back(fileText());
    }
    const std::vector<Backup> backups = workspace.safety.backups.of(kScene);
    ASSERT_EQ(backups.size(), Backups::kCopies);
    for (std::size_t i = 0; i < backups.size(); ++i) {
        EXPECT_EQ(*readFile(backups[i].path), texts[texts.size() - 2 - i]) << "the newest first";
        EXPECT_FALSE(backups[i].when.empty());
    }
    EXPECT_EQ(fileText(".plumb/.gitignore"), "*\n");
}

TEST_F(Safety, aBackupIsOpenedFromItsListAndNotSavedByThat) {
    createOne();
    ASSERT_TRUE(workspace.save().ok());
    const std::string saved = fileText();
    hands.key(Key::B, {.control = true, .alt = true});
    hands.rest(3);
    hands.click("Backups/0");
    hands.rest(3);
    EXPECT_EQ(workspace.text(), kSceneText);
    EXPECT_TRUE(workspace.unsaved());
    EXPECT_EQ(fileText(), saved);
}

TEST_F(Safety, aFileChangedByAnotherProgramIsNoticedAndTheirsIsLoaded) {
    workspace.safety.begin();
    createOne();
    const std::string mine = workspace.text();
    putFile(kScene, changedText());
    hands.rest(70);
    hands.click("Changed/theirs");
    hands.rest(3);
    EXPECT_FALSE(shows("Changed/theirs"));
    EXPECT_EQ(workspace.text(), changedText());
    EXPECT_FALSE(workspace.unsaved());
    ASSERT_FALSE(workspace.safety.backups.of(kScene).empty());
    EXPECT_EQ(*readFile(workspace.safety.backups.of(kScene)[0].path), mine);
}

TEST_F(Safety, savingDoesNotWriteOverWhatAnotherProgramWrote) {
    workspace.safety.begin();
    createOne();
    putFile(kScene, changedText());
    EXPECT_FALSE(workspace.save().ok()) << "before the question";
    EXPECT_EQ(fileText(), changedText());
    hands.rest(2);
    hands.click("Changed/mine");
    hands.rest(2);
    EXPECT_TRUE(workspace.unsaved());
    const std::string mine = workspace.text();
    ASSERT_TRUE(workspace.save().ok());
    EXPECT_EQ(fileText(), mine);
    EXPECT_EQ(*readFile(workspace.safety.backups.of(kScene)[0].path), changedText());
}

TEST_F(Safety, aFileWithOnlyANewTimestampIsUnchanged) {
    workspace.safety.begin();
    putFile(kScene, kSceneText);
    hands.rest(70);
    EXPECT_FALSE(shows("Changed/theirs"));
    EXPECT_EQ(workspace.safety.onDisk(), FileWatch::State::Same);
}

TEST_F(Safety, aDeletedFileIsSavedAgain) {
    workspace.safety.begin();
    std::filesystem::remove(root() / kScene);
    hands.rest(70);
    EXPECT_TRUE(workspace.unsaved());
    ASSERT_TRUE(workspace.save().ok());
    EXPECT_EQ(fileText(), kSceneText);
}

TEST_F(Safety, whatDiffersIsReportedByNameAndFieldBeforeAnythingIsDecided) {
    leaveJournal(changedText());
    workspace.safety.begin();
    hands.rest(3);
    hands.click("Recovery/0/look");
    hands.rest(2);
    ASSERT_TRUE(shows("Recovery/differences"));
    EXPECT_EQ(window.widgets().find("Recovery/differences")->value,
              "crate: Transform.position was [200,64], is [201,64]");
    EXPECT_EQ(workspace.text(), kSceneText) << "looking decides nothing";
    hands.click("Recovery/0/discard");
    hands.rest(3);

    createOne();
    putFile(kScene, changedText());
    hands.rest(70);
    hands.click("Changed/compare");
    hands.rest(2);
    ASSERT_TRUE(shows("Changed/differences"));
    EXPECT_EQ(window.widgets().find("Changed/differences")->value, "new entity was removed");
}

TEST_F(Safety, mineIsSavedBesideAndTheirsIsLoaded) {
    workspace.safety.begin();
    createOne();
    const std::string mine = workspace.text();
    putFile(kScene, changedText());
    putFile("scenes/level.mine.scene.json", "taken");
    hands.rest(70);
    hands.click("Changed/beside");
    hands.rest(3);
    EXPECT_EQ(fileText("scenes/level.mine2.scene.json"), mine);
    EXPECT_EQ(fileText("scenes/level.mine.scene.json"), "taken");
    EXPECT_EQ(workspace.text(), changedText());
    EXPECT_FALSE(shows("Changed/theirs"));
}

TEST_F(Safety, aCrashDuringSavingOffersNoStateOlderThanTheFile) {
    workspace.safety.begin();
    createOne();
    workspace.safety.update(2.0), workspace.safety.finish();
    createOne();
    workspace.safety.saving(),
        // the file is written afterwards, and the program is killed before it removes the journal
        workspace.safety.finish();
    ASSERT_EQ(journals().size(), 1u);
    const std::string journal = fileText(".plumb/" + journals()[0]);
    EXPECT_EQ(journal.substr(journal.find('\n') + 1), workspace.text());
}

TEST(SceneDifferences, areReportedByNameAndField) {
    const std::string text{kSceneText};
    EXPECT_EQ(sceneDifferences(text, text).size(), 1u);
    EXPECT_EQ(sceneDifferences(text, "{").size(), 1u);
    EXPECT_EQ(sceneDifferences("{\"a\":1,\"b\":2,\"c\":3}", "{}", 2),
              (std::vector<std::string>{"scene: a was 1, was removed", "scene: b was 2, was removed",
                                        "and 1 more"}));
    EXPECT_EQ(sceneDifferences("{}", "{\"entities\": [{\"id\": \"1\", \"name\": \"hut\"}]}"),
              std::vector<std::string>{"hut was added"});
}

TEST_F(Safety, accidentallyDiscardedWorkCanBeRestored) {
    workspace.safety.begin();
    createOne();
    const std::string mine = workspace.text();
    putFile("scenes/other.scene.json", kSceneText);
    ASSERT_TRUE(workspace.open("scenes/other.scene.json").ok());
    EXPECT_EQ(*readFile(workspace.safety.backups.of(kScene).at(0).path), mine);
}

}  // namespace
}  // namespace plumb::editor::ui
