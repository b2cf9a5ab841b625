#include <imgui.h>

#include "editor/model/commands/change_components.hpp"
#include "editor/model/commands/delete_entities.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor {
namespace {

class HistoryTest : public EditorFixture {
protected:
    HistoryTest() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        hands.click("Tab/History");
    }
    void rename(std::string_view from, std::string_view to) {
        workspace.undo.push(renameEntity(workspace.document, named(from), to));
        workspace.undo.endGesture();
    }
    void remove(std::vector<ObjectId> ids) {
        workspace.undo.push(std::make_unique<DeleteEntities>(std::move(ids)));
        workspace.undo.endGesture();
    }
    [[nodiscard]] std::string valueOf(std::string_view widget) {
        hands.rest(2);
        const auto* found = window.widgets().find(widget);
        return found == nullptr ? "(none)" : found->value;
    }

    LogBook log;
    ui::EditorWindow window;
    ui::Hands hands;
};

TEST_F(HistoryTest, stepsNameTheirEntity) {
    workspace.undo.push(createEntity(workspace.document, "torch", {}));
    rename("crate", "box");
    remove({named("lamp"), named("sign")});
    EXPECT_EQ(workspace.undo.subject(0), "torch");
    EXPECT_EQ(workspace.undo.subject(1), "crate") << "the name that it had";
    EXPECT_EQ(workspace.undo.subject(2), "lamp and 1 more");
    EXPECT_EQ(valueOf("History/3"), workspace.undo.label(2) + ": lamp and 1 more");
    EXPECT_EQ(valueOf("History/0"), "opened");
}

TEST_F(HistoryTest, aTransactionNamesTheEntityOfItsFirstCommand) {
    Transaction step{workspace.undo, "two things"};
    workspace.undo.push(renameEntity(workspace.document, named("sign"), "post"));
    workspace.undo.push(renameEntity(workspace.document, named("crate"), "box"));
    ASSERT_TRUE(step.commit());
    EXPECT_EQ(workspace.undo.subject(0), "sign");
    rename("lamp", "light");
    EXPECT_EQ(workspace.undo.subject(1), "lamp");
}

TEST_F(HistoryTest, aClickGoesToAStepAndTheSavedOneIsMarked) {
    rename("crate", "box");
    ASSERT_TRUE(workspace.save().ok());
    rename("box", "chest");
    rename("chest", "case");
    EXPECT_EQ(valueOf("History/saved"), "1");
    EXPECT_EQ(valueOf("History/summary"), "3 steps can be undone, 0 redone; 2 after the saved state");
    hands.click("History/1");
    EXPECT_TRUE(named("box"));
    EXPECT_FALSE(workspace.unsaved());
    hands.click("History/0");
    EXPECT_TRUE(named("crate"));
    EXPECT_EQ(valueOf("History/summary"), "0 steps can be undone, 3 redone; 1 before the saved state");
    hands.click("History/3");
    EXPECT_TRUE(named("case"));
}

TEST_F(HistoryTest, stepsThatCanNoLongerBeRedoneAreReported) {
    rename("crate", "box");
    rename("box", "chest");
    rename("sign", "post");
    workspace.undo.jumpTo(1);
    EXPECT_TRUE(workspace.undo.lost().empty());
    rename("lamp", "light");
    ASSERT_EQ(workspace.undo.lost().size(), 1u);
    EXPECT_EQ(workspace.undo.lost()[0].position, 1u);
    EXPECT_EQ(workspace.undo.lost()[0].steps, 2u);
    EXPECT_NE(valueOf("History/1/lost").find("2 undone steps were discarded here"), std::string::npos);
    EXPECT_NE(valueOf("History/1/lost").find("sign"), std::string::npos);

    workspace.undo.jumpTo(0);
    rename("player", "hero");
    ASSERT_EQ(workspace.undo.lost().size(), 1u) << "the other place is no more";
    EXPECT_EQ(workspace.undo.lost()[0].position, 0u);
}

TEST_F(HistoryTest, aSavedStepThatWasLostIsReported) {
    rename("crate", "box");
    ASSERT_TRUE(workspace.save().ok());
    workspace.undo.undo();
    rename("crate", "chest");
    EXPECT_NE(valueOf("History/summary").find("the saved state is no longer among them"), std::string::npos);
}

}  // namespace
}  // namespace plumb::editor
