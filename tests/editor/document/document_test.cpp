#include "editor/model/commands/delete_entities.hpp"
#include "editor/model/view/log_book.hpp"
#include "tests/editor/support/editor_fixture.hpp"

namespace plumb::editor {
namespace {

using Documents = EditorFixture;

TEST_F(Documents, theListOfEntitiesStaysSortedWhenEntitiesAreAddedOrRemoved) {
    const Document& document = workspace.document;
    const std::vector<ObjectId>& all = document.objects();
    ASSERT_EQ(all.size(), 6u);
    EXPECT_EQ(&document.objects(), &all);
    const ObjectId* place = all.data();
    EXPECT_EQ(document.objects().data(), place) << "asking again does no work";

    workspace.undo.push(std::make_unique<DeleteEntities>(std::vector{named("player")}));
    EXPECT_EQ(document.objects().size(), 4u) << "the lamp goes with the player";
    workspace.undo.push(createEntity(workspace.document, "new", {}));
    EXPECT_EQ(document.nameOf(document.objects().back()), "new");
    workspace.undo.undo();
    workspace.undo.undo();

    ASSERT_EQ(document.objects().size(), 6u);
    EXPECT_EQ(document.nameOf(document.objects()[1]), "player");
    ASSERT_TRUE(workspace.open(kScene).ok());
    EXPECT_EQ(document.objects().size(), 6u);
}

TEST_F(Documents, aNewSceneIsWrittenOpenedAndSavedUnchanged) {
    ASSERT_TRUE(workspace.createScene("cave").ok());
    EXPECT_EQ(workspace.document.scenePath, "scenes/cave.scene.json");
    EXPECT_EQ(workspace.document.objectCount(), 0u);
    EXPECT_EQ(workspace.text(), fileText("scenes/cave.scene.json"));

    for (const char* wrong : {"", "cave", "../cave", "a/b", "level"}) {
        EXPECT_FALSE(workspace.createScene(wrong).ok()) << wrong;
    }
    EXPECT_EQ(fileText(), kSceneText);
}

TEST_F(Documents, aSceneSavedUnderAnotherNameIsTheOpenOneAndTheOldFileStays) {
    workspace.undo.push(createEntity(workspace.document, "new", {}));
    const std::string text = workspace.text();
    for (const char* wrong : {"", "level", "../cave", "a/b"})
        EXPECT_FALSE(workspace.saveAs(wrong).ok()) << wrong;
    EXPECT_EQ(workspace.document.scenePath, kScene) << "nothing has changed";
    EXPECT_TRUE(workspace.unsaved());

    ASSERT_TRUE(workspace.saveAs("cave").ok());
    EXPECT_EQ(workspace.document.scenePath, "scenes/cave.scene.json");
    EXPECT_FALSE(workspace.unsaved());
    EXPECT_EQ(fileText("scenes/cave.scene.json"), text);
    EXPECT_EQ(fileText(), kSceneText);

    workspace.undo.undo();
    EXPECT_TRUE(workspace.unsaved()) << "the history is kept";
    ASSERT_TRUE(workspace.save().ok());
    EXPECT_EQ(fileText("scenes/cave.scene.json"), kSceneText);
    EXPECT_EQ(fileText(), kSceneText);
}

TEST(LogBooks, keepAndForwardAllMessagesSinceTheirCreation) {
    std::vector<std::string> heard;
    const LogSink before = setLogSink([&](const LogLine& line) { heard.push_back(line.text); });
    {
        const LogBook book;
        logNote("Test", "before there is a window");
        EXPECT_EQ(book.lines().back().text, "before there is a window");
        for (std::size_t i = 0; i < LogBook::kLines; ++i) logNote("Test", "more");
        EXPECT_EQ(book.lines().size(), LogBook::kLines);
        EXPECT_EQ(book.count(), LogBook::kLines + 1);
    }
    logNote("Test", "after");
    setLogSink(before);
    EXPECT_EQ(heard.front(), "before there is a window");
    EXPECT_EQ(heard.back(), "after");
}

}  // namespace
}  // namespace plumb::editor
